#include "motion/record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tremolo::motion {

void require_sound(const Record& record) {
  const auto finite = [](double value) { return std::isfinite(value); };
  if (record.samples.size() < 2 || !(record.dt > 0.0) || !std::isfinite(record.dt) ||
      !std::ranges::all_of(record.samples, finite))
    throw std::invalid_argument(
        fmt::format("a motion needs at least 2 samples, all finite, and dt > 0, has {} and dt = {} s",
                    record.samples.size(), record.dt));
}

Record converted(Record record, Unit unit) {
  if (record.quantity() != quantity_of(unit))
    throw std::invalid_argument(fmt::format("{} is a unit of {}, the motion is {} in {}", name(unit),
                                            name(quantity_of(unit)), name(record.quantity()),
                                            name(record.unit)));
  if (record.unit == unit)
    return record;
  const double factor = in_si(record.unit) / in_si(unit);
  for (double& sample : record.samples)
    sample *= factor;
  record.unit = unit;
  return record;
}

Record with_unit(const Record& record, Unit unit) {
  require_sound(record);
  if (record.quantity() == quantity_of(unit))
    return converted(record, unit);
  Record result = converted(record, si_unit(record.quantity()));
  for (int from = static_cast<int>(record.quantity()); from < static_cast<int>(quantity_of(unit)); ++from)
    result.samples = integrate(result.samples, record.dt);
  for (int from = static_cast<int>(record.quantity()); from > static_cast<int>(quantity_of(unit)); --from)
    result.samples = differentiate(result.samples, record.dt);
  result.unit = si_unit(quantity_of(unit));
  return converted(std::move(result), unit);
}

Record as_kind(Record record, MotionKind kind) {
  if (!record.kind)
    throw std::invalid_argument(
        fmt::format("the motion does not say whether it is incident, outcrop or within: say which before it "
                    "is made {}",
                    name(kind)));
  if (*record.kind == kind)
    return record;
  if (*record.kind == MotionKind::within || kind == MotionKind::within)
    throw std::invalid_argument(
        fmt::format("from {} to {} the layers above the place are needed: multiply by the transfer function "
                    "of the profile (tremolo wave --transfer, or a column with that base motion)",
                    name(*record.kind), name(kind)));
  const double factor = kind == MotionKind::incident ? 0.5 : 2.0;
  for (double& sample : record.samples)
    sample *= factor;
  record.kind = kind;
  return record;
}

} // namespace tremolo::motion
