#include "materials/soiltest/path/path_start.hpp"

#include "materials/soiltest/path/path_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace tremolo::soiltest {
namespace {

/// Whether one is about 1000 times the other.
bool thousandfold(double one, double other) {
  const double factor = one / other;
  return factor > 500.0 && factor < 2000.0;
}

} // namespace

void check_start(const Path& path, const InitialState& initial, const materials::PointStress& start) {
  const PathRow& row = path.rows.front();
  const std::array<double, 4> given = {row.stress.xx, row.stress.yy, row.stress.xy, row.stress.zz};
  const std::array<double, 4> held = {start.xx, start.yy, start.xy, start.zz};
  for (std::size_t i = 0; i < given.size(); ++i) {
    const bool kilopascal = thousandfold(held[i], given[i]);
    const bool pascal = thousandfold(given[i], held[i]);
    const bool off = std::abs(given[i] - held[i]) > 0.01 * initial.vertical_stress;
    if (kilopascal || pascal || (path.by_stress[i] && off)) {
      throw std::invalid_argument(fmt::format(
          "{} starts with {} = {:g} Pa, but the test starts from {:g} Pa{}", place(row, 0), stress_names[i],
          given[i], held[i],
          kilopascal ? "; kPa for Pa? Then stress_unit = \"kPa\""
          : pascal   ? "; Pa for kPa? Then stress_unit = \"Pa\""
                     : ": vertical_stress, k0 and shear_bias must give the stress of the first row"));
    }
  }
}

} // namespace tremolo::soiltest
