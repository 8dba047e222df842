#include "app/motion/record_options.hpp"

#include "app/motion/chosen.hpp"

namespace tremolo::app {

void add_record_options(Command& command, RecordOptions& options) {
  command.add_option("--quantity", options.quantity,
                     "acceleration, velocity or displacement, where the file leaves it open");
  command.add_option("--unit", options.unit,
                     "g, m/s2, cm/s2, m/s, cm/s, m, cm or mm, where the file leaves it open");
}

motion::ReadAs read_as(const RecordOptions& options) {
  return {.quantity = chosen(options.quantity, motion::quantity_named, "--quantity"),
          .unit = chosen(options.unit, motion::unit_named, "--unit"),
          .kind = {}};
}

} // namespace tremolo::app
