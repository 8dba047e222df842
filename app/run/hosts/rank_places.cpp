#include "app/run/hosts/rank_places.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <stdexcept>

namespace tremolo::app {

std::vector<int> rank_places(int count, const std::vector<scene::RankMachine>& machines, int here,
                             bool beyond) {
  std::vector<int> most{here};
  for (const scene::RankMachine& machine : machines)
    most.push_back(machine.most.value_or(here));
  const int all = std::accumulate(most.begin(), most.end(), 0);
  if (count > all && !beyond)
    throw std::invalid_argument(
        fmt::format("--ranks {}: the machines take at most {}, of which {} here; --oversubscribe starts more",
                    count, all, here));
  std::vector<int> places(most.size(), 0);
  int placed = 0;
  // A rank for each in turn; where all are full, for each anew.
  for (bool full = false; placed < count; full = placed >= all)
    for (std::size_t m = 0; m < most.size() && placed < count; ++m)
      if (full || places[m] < most[m]) {
        ++places[m];
        ++placed;
      }
  return places;
}

} // namespace tremolo::app
