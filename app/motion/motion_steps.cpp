#include "app/motion/motion_steps.hpp"

#include "base/samples.hpp"
#include "motion/read/read_spectrum.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace tremolo::app {
namespace {

motion::Record rotated(motion::Record record, const MotionSteps& steps, motion::ReadAs as) {
  // The first component's number or name is not the other one's.
  const bool column = !as.column.empty();
  as.column = column ? steps.other_component : "";
  as.component = column ? "" : steps.other_component;
  const auto other = motion::converted(motion::read_record(steps.other, as), record.unit);
  if (other.dt != record.dt)
    throw std::invalid_argument(fmt::format("{}: its step of {} s is not that of the first component, {} s",
                                            steps.other, other.dt, record.dt));
  record.samples = motion::rotated(record.samples, other.samples, *steps.rotate_deg).first;
  return record;
}

/// The baseline is that of the acceleration; another quantity goes there and back.
motion::Record without_drift(const motion::Record& record, const MotionSteps& steps) {
  auto acceleration = motion::with_unit(record, motion::Unit::m_s2);
  acceleration.samples =
      motion::baseline_corrected(acceleration.samples, record.dt, steps.fit, *steps.baseline);
  return motion::with_unit(acceleration, record.unit);
}

/// Factor that scales the motion to the requested PGA.
double factor(const motion::Record& record, const MotionSteps& steps) {
  if (!steps.pga)
    return steps.scale.value_or(1.0);
  const double found = peak(motion::with_unit(record, motion::Unit::m_s2).samples);
  if (!(found > 0.0) || !(*steps.pga > 0.0))
    throw std::invalid_argument(
        fmt::format("cannot scale a PGA of {} m/s2 to {} m/s2: both must be > 0", found, *steps.pga));
  return *steps.pga / found;
}

/// The response is that to the acceleration; another quantity goes there and back.
Matched match(motion::Record& record, const MotionSteps& steps) {
  auto target = motion::read_spectrum(steps.target);
  target.damping = steps.target_damping;
  auto acceleration = motion::with_unit(record, motion::Unit::m_s2);
  auto result = motion::spectrally_matched(acceleration.samples, record.dt, target);
  acceleration.samples = std::move(result.acceleration);
  record = motion::with_unit(acceleration, record.unit);
  return {result.before, result.after, result.steps};
}

} // namespace

Processed processed(motion::Record record, const MotionSteps& steps, const motion::ReadAs& as) {
  std::optional<Matched> matched;
  if (steps.rotate_deg)
    record = rotated(std::move(record), steps, as);
  if (steps.baseline)
    record = without_drift(record, steps);
  if (steps.taper != 0.0)
    record.samples = motion::tapered(std::move(record.samples), record.dt, steps.taper, steps.taper);
  if (!steps.band.empty())
    record.samples = motion::band_passed(record.samples, record.dt,
                                         {.low = steps.band[0], .high = steps.band[1], .order = steps.order});
  if (steps.step) {
    record.samples = motion::resampled(record.samples, record.dt, *steps.step);
    record.dt = *steps.step;
  }
  if (steps.scale || steps.pga)
    for (const double by = factor(record, steps); double& sample : record.samples)
      sample *= by;
  if (!steps.target.empty())
    matched = match(record, steps);
  if (steps.shift != 0.0)
    record.samples = motion::shifted(record.samples, record.dt, steps.shift);
  if (steps.kind)
    record = motion::as_kind(std::move(record), *steps.kind);
  motion::require_sound(record);
  return {std::move(record), matched};
}

} // namespace tremolo::app
