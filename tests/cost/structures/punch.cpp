// Prandtl's punch by cells across its width. Prints
//
//     rough, cells, sunk, pressure, cpu
//
// pressure over (2 + pi) c at a depth (m), and CPU time so far (s).

#include "tests/support/punched_clay.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <ctime>

int main() {
  using namespace tremolo::test_support;
  fmt::print("rough,cells,sunk,pressure,cpu\n");
  for (const bool rough : {true, false})
    for (const int cells : {4, 6, 8, 12, 16, 24, 32}) {
      PunchedClay clay(PunchedClay::width / cells, rough);
      const std::clock_t begin = std::clock();
      for (int k = 0; k < 40; ++k) {
        const double pressure = clay.pressure(0.1) / PunchedClay::exact;
        const double cpu = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
        fmt::print("{},{},{:.4g},{:.5g},{:.4g}\n", rough ? 1 : 0, cells, clay.sunk(), pressure, cpu);
      }
      std::fflush(stdout);
    }
}
