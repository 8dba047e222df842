#pragma once

#include <sys/prctl.h>

namespace tremolo::mpm_domain {

/// Memory of this process comes in pages of 4 kB from now on, even where the kernel is set to back large
/// arrays with pages of 2 MB: so what a rank never writes to takes none (fields/zero_pages.hpp).
inline void use_small_pages() {
  ::prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0); // a kernel that cannot leaves the rank larger
}

} // namespace tremolo::mpm_domain
