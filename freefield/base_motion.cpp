#include "freefield/base_motion.hpp"

namespace tremolo::freefield {
namespace {

BaseComponent advanced(const BaseComponent& before, double middle, double end, double step) {
  return {.displacement = before.displacement + step / 6.0 * (before.velocity + 4.0 * middle + end),
          .velocity = end,
          .acceleration = (3.0 * end - 4.0 * middle + before.velocity) / step};
}

} // namespace

BaseMotion advanced(BaseKind kind, const InputVelocity& input, const BaseMotion& before, double time,
                    double step) {
  const Velocity end = input(time + step);
  if (kind == BaseKind::compliant)
    return {.x = {.velocity = end.x}, .y = {.velocity = end.y}};
  const Velocity middle = input(time + 0.5 * step);
  return {advanced(before.x, middle.x, end.x, step), advanced(before.y, middle.y, end.y, step)};
}

} // namespace tremolo::freefield
