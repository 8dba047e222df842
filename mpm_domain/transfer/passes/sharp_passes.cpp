#include "mpm_domain/transfer/passes/passes.hpp"
#include "mpm_domain/transfer/sharp_transfer.hpp"

namespace tremolo::mpm_domain {

std::vector<Pass> sharp_passes(Ground& ground) {
  if (!ground.is_sharp())
    return {};
  return {{Phase::remap, "sharpened velocities", [&ground](Step&) { sharpen_strain(ground); }}};
}

} // namespace tremolo::mpm_domain
