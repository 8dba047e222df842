#include "mpm_domain/dispersion/fullness.hpp"
#include "mpm_domain/transfer/passes/passes.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "mpm_domain/transfer/sharp_transfer.hpp"

namespace tremolo::mpm_domain {

std::vector<Pass> sharp_passes(Ground& ground) {
  if (!ground.is_sharp())
    return {};
  return {{Phase::scatter, "particles to grid", [&ground](Step&) { scatter(ground, ScatterPart::motion); }},
          {Phase::scatter, "sharpened forces",
           [&ground](Step&) {
             find_fullness(ground);
             scatter_sharp_forces(ground);
           }},
          {Phase::remap, "sharpened velocities", [&ground](Step&) { sharpen_strain(ground); }}};
}

} // namespace tremolo::mpm_domain
