#include "motion/plausible.hpp"

#include "motion/measures.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace tremolo::motion {

namespace {

/// Units in which the same numbers would be a strong motion: "; in cm/s2 they would be 0.31 g".
std::string other_units(const Record& record, double pga_g) {
  constexpr std::array units = {ScaledUnit{Unit::m_s2}, ScaledUnit{Unit::cm_s2}, ScaledUnit{Unit::g, 1e-2},
                                ScaledUnit{Unit::g, 1e-3}};
  constexpr double least = 0.005; // g
  std::string text;
  if (record.quantity() != Quantity::acceleration)
    return text;
  for (const ScaledUnit& unit : units)
    if (const double other = pga_g * in_si(unit) / in_si(record.unit);
        other >= least && other <= largest_pga_g)
      text +=
          fmt::format("{} {:.2g} g in {}", text.empty() ? "; the samples would be" : ",", other, name(unit));
  return text;
}

} // namespace

std::vector<std::string> doubts(const Record& record) {
  std::vector<std::string> found = record.origin.doubts;
  const Measures m = measures(record);
  if (const double pga_g = m.pga / standard_gravity; pga_g > largest_pga_g)
    found.push_back(fmt::format("PGA {:.4g} g, above {:g} g: likely another unit than {}, or a factor{}",
                                pga_g, largest_pga_g, name(record.unit), other_units(record, pga_g)));
  if (m.pgv > largest_pgv)
    found.push_back(fmt::format("PGV {:.4g} m/s, above {:g} m/s: likely {}", m.pgv, largest_pgv,
                                std::abs(m.residual_velocity) > 0.5 * m.pgv
                                    ? "an offset of the baseline, which integrates to a drift"
                                    : "another unit, or a factor"));
  if (record.dt > longest_step)
    found.push_back(
        fmt::format("a step of {:g} s, above {:g} s: likely times in another unit than s, or numbers of "
                    "steps; frequencies up to {:.3g} Hz are left",
                    record.dt, longest_step, 0.5 / record.dt));
  return found;
}

} // namespace tremolo::motion
