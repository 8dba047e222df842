#include "mpm_domain/boundary/passes/passes.hpp"
#include "mpm_domain/boundary/walls/impervious_faces.hpp"

#include <memory>

namespace tremolo::mpm_domain {

std::vector<Pass> wall_passes(Ground& ground, const Boundary& boundary) {
  if (!ground.has_flow())
    return {};
  const auto walls = std::make_shared<ImperviousFaces>();
  return {{Phase::forces, "", [&ground, &boundary, walls](Step&) { walls->close(ground, boundary); }},
          {Phase::books, "", [&ground, walls](Step& step) {
             const double work = step.kicks.front() * walls->open(ground);
             step.bookings.add([&energy = step.energy, work] { energy.input += work; });
           }}};
}

} // namespace tremolo::mpm_domain
