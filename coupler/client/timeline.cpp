#include "coupler/client/timeline.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>
#include <utility>

namespace tremolo::coupler {

namespace {

constexpr std::size_t most_slices = 256;

} // namespace

std::string waiting_for(std::string_view whom) {
  return fmt::format("waiting for {}", whom);
}

double TimelineReport::seconds(std::string_view activity) const {
  const auto found = activities.find(activity);
  return found == activities.end() ? 0.0 : std::accumulate(found->second.begin(), found->second.end(), 0.0);
}

void TimelineReport::resolve_waits(std::string_view whom, TimelineReport of_whom) {
  const auto found = activities.find(waiting_for(whom));
  if (found == activities.end())
    return;
  while (slice < of_whom.slice)
    coarsen();
  while (of_whom.slice < slice)
    of_whom.coarsen();
  auto& waits = found->second;
  for (const auto& [activity, seconds] : of_whom.activities) {
    if (!activity.starts_with(waiting_for("")))
      continue;
    auto& resolved = activities[activity];
    resolved.resize(std::max(resolved.size(), waits.size()), 0.0);
    for (std::size_t i = 0; i < std::min(waits.size(), seconds.size()); ++i) {
      const double moved = std::min(waits[i], seconds[i]);
      waits[i] -= moved;
      resolved[i] += moved;
    }
  }
}

void TimelineReport::coarsen() {
  slice *= 2.0;
  for (auto& [activity, seconds] : activities) {
    seconds.resize(seconds.size() + seconds.size() % 2, 0.0);
    for (std::size_t i = 0; i < seconds.size() / 2; ++i)
      seconds[i] = seconds[2 * i] + seconds[2 * i + 1];
    seconds.resize(seconds.size() / 2);
  }
}

Timeline::Timeline(double slice) : report_{slice, {}} {}

Timeline::Scope::Scope(Timeline& timeline, std::string activity)
    : timeline_(timeline), before_(timeline.activity_) {
  timeline_.turn_to(std::move(activity));
}

Timeline::Scope::~Scope() {
  timeline_.turn_to(std::move(before_));
}

const TimelineReport& Timeline::report() {
  turn_to(activity_);
  return report_;
}

void Timeline::turn_to(std::string activity) {
  const double now = seconds_since(start_);
  add(until_, now);
  until_ = now;
  activity_ = std::move(activity);
}

void Timeline::add(double from, double to) {
  while (to >= report_.slice * static_cast<double>(most_slices))
    report_.coarsen();
  auto& seconds = report_.activities[activity_];
  const auto last = static_cast<std::size_t>(to / report_.slice);
  seconds.resize(std::max(seconds.size(), last + 1), 0.0);
  for (auto i = static_cast<std::size_t>(from / report_.slice); i <= last; ++i) {
    const double begin = report_.slice * static_cast<double>(i);
    seconds[i] += std::max(0.0, std::min(to, begin + report_.slice) - std::max(from, begin));
  }
}

} // namespace tremolo::coupler
