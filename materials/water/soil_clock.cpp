#include "materials/water/soil_clock.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::materials {

namespace {

/// Time of the soil in a time (s) in which N rises from 1, s: int exp(rate t) dt.
double risen(double rate, double time) {
  return std::expm1(rate * time) / rate;
}

/// Its inverse.
double rising_time(double rate, double time_of_soil) {
  return std::log1p(rate * time_of_soil) / rate;
}

} // namespace

double SoilClock::Rest::rate() const {
  return std::log(factor) / rise;
}

double SoilClock::Rest::speed(double time_from_an_end) const {
  return std::pow(factor, std::min(time_from_an_end, change) / rise);
}

double SoilClock::Rest::time_of_soil(double time) const {
  if (factor == 1.0)
    return time + (soil_from - from);
  if (to - time < change)
    return soil_to - risen(rate(), to - time);
  const double rising = std::min(time - from, change);
  return soil_from + risen(rate(), rising) + speed(change) * (time - from - rising);
}

double SoilClock::Rest::simulated_time(double time_of_soil) const {
  if (factor == 1.0)
    return time_of_soil - (soil_from - from);
  const double in_change = risen(rate(), change);
  if (soil_to - time_of_soil < in_change)
    return to - rising_time(rate(), soil_to - time_of_soil);
  const double passed = time_of_soil - soil_from;
  return passed < in_change ? from + rising_time(rate(), passed)
                            : from + change + (passed - in_change) / speed(change);
}

void SoilClock::Rest::end_after(double duration) {
  soil_to = soil_from + duration;
  to = from + duration;
  if (factor == 1.0)
    return;
  change = std::min(rise, rising_time(rate(), 0.5 * duration));
  to = from + 2.0 * change + (duration - 2.0 * risen(rate(), change)) / speed(change);
}

SoilClock::SoilClock(const std::vector<Stage>& stages) {
  double time = 0.0;
  double time_of_soil = 0.0;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    const auto& [duration, factor] = stages[i];
    const bool is_last = i + 1 == stages.size();
    if (factor)
      rests_.push_back({.from = time, .soil_from = time_of_soil, .factor = *factor});
    if (factor && !is_last)
      rests_.back().end_after(duration);
    time = factor ? rests_.back().to : time + duration;
    time_of_soil += duration;
  }
}

bool SoilClock::rests(double time) const {
  return std::ranges::any_of(rests_, [&](const Rest& rest) { return time >= rest.from && time < rest.to; });
}

double SoilClock::speed(double time) const {
  for (const Rest& rest : rests_)
    if (time >= rest.from && time < rest.to)
      return rest.speed(std::min(time - rest.from, rest.to - time));
  return 1.0;
}

double SoilClock::time_of_soil(double time) const {
  double shift = 0.0; // of the time of the soil over that of the simulation, while the ground is shaken
  for (const Rest& rest : rests_) {
    if (time <= rest.from)
      break;
    if (time < rest.to)
      return rest.time_of_soil(time);
    shift = rest.soil_to - rest.to;
  }
  return time + shift;
}

double SoilClock::simulated_time(double time_of_soil) const {
  double shift = 0.0;
  for (const Rest& rest : rests_) {
    if (time_of_soil <= rest.soil_from)
      break;
    if (time_of_soil < rest.soil_to)
      return rest.simulated_time(time_of_soil);
    shift = rest.soil_to - rest.to;
  }
  return time_of_soil - shift;
}

} // namespace tremolo::materials
