#include "materials/water/rest_clock.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::materials {

double RestClock::speed(double time) const {
  return std::pow(factor, std::clamp((time - from) / rise, 0.0, 1.0));
}

double RestClock::time_of_soil(double time) const {
  if (factor == 1.0 || time <= from)
    return time;
  const double rate = std::log(factor) / rise; // d(ln N)/dt
  const double risen = std::min(time - from, rise);
  return from + std::expm1(rate * risen) / rate + factor * (time - from - risen);
}

double RestClock::simulated_time(double time_of_soil) const {
  if (factor == 1.0 || time_of_soil <= from)
    return time_of_soil;
  const double rate = std::log(factor) / rise;
  const double passed = time_of_soil - from;
  const double in_rise = (factor - 1.0) / rate;
  return passed < in_rise ? from + std::log1p(rate * passed) / rate
                          : from + rise + (passed - in_rise) / factor;
}

} // namespace tremolo::materials
