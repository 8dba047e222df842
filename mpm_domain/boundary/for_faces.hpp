#pragma once

#include "mpm_domain/tiles/worker_pool.hpp"

#include <algorithm>
#include <cstddef>

namespace tremolo::mpm_domain {

inline constexpr std::size_t faces_per_task = 64;

/// act(first, end) for portions of so many faces, side by side; portion n begins with face n faces_per_task.
template <typename Act>
void for_portions_of_faces(WorkerPool& workers, std::size_t count, const Act& act) {
  workers.run((count + faces_per_task - 1) / faces_per_task, [&](std::size_t task) {
    act(task * faces_per_task, std::min((task + 1) * faces_per_task, count));
  });
}

/// act(f) for all faces, portions of them side by side.
template <typename Act>
void for_faces(WorkerPool& workers, std::size_t count, const Act& act) {
  for_portions_of_faces(workers, count, [&](std::size_t first, std::size_t end) {
    for (std::size_t f = first; f < end; ++f)
      act(f);
  });
}

} // namespace tremolo::mpm_domain
