#include "app/motion/record_options.hpp"

#include "app/motion/chosen.hpp"

namespace tremolo::app {

void add_record_options(Command& command, RecordOptions& options) {
  command.add_option("--quantity", options.quantity,
                     "acceleration, velocity or displacement, where the file leaves it open");
  command.add_option("--unit", options.unit,
                     "g, m/s2, cm/s2, m/s, cm/s, m, cm or mm, where the file leaves it open");
  command.add_option("--component", options.component,
                     "Which of several components: its number from 1, its name or a part of it");
  command.add_option("--column", options.column,
                     "Which column of a table has the values: its number, its name or a part of it");
}

motion::ReadAs read_as(const RecordOptions& options) {
  return {.quantity = chosen(options.quantity, motion::quantity_named, "--quantity"),
          .unit = chosen(options.unit, motion::unit_named, "--unit"),
          .kind = {},
          .component = options.component,
          .column = options.column};
}

} // namespace tremolo::app
