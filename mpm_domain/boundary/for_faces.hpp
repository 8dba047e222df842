#pragma once

#include "mpm_domain/tiles/worker_pool.hpp"

#include <algorithm>
#include <cstddef>

namespace tremolo::mpm_domain {

inline constexpr std::size_t faces_per_task = 64;

/// act(f) for so many faces, portions of them side by side.
template <typename Act>
void for_faces(WorkerPool& workers, std::size_t count, const Act& act) {
  workers.run((count + faces_per_task - 1) / faces_per_task, [&](std::size_t task) {
    for (std::size_t f = task * faces_per_task; f < std::min((task + 1) * faces_per_task, count); ++f)
      act(f);
  });
}

} // namespace tremolo::mpm_domain
