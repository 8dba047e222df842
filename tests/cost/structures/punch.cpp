// Prandtl's punch by cells across its width. Prints
//
//     rough, cells, sunk, pressure, cpu
//
// pressure over (2 + pi) c at a depth (m), and CPU time so far (s).

#include "tests/support/cpu_seconds.hpp"
#include "tests/support/punched_clay.hpp"

#include <fmt/format.h>

#include <cstdio>

int main() {
  using namespace tremolo::test_support;
  fmt::print("rough,cells,sunk,pressure,cpu\n");
  for (const bool rough : {true, false})
    for (const int cells : {4, 6, 8, 12, 16, 24, 32}) {
      PunchedClay clay(PunchedClay::width / cells, rough);
      double cpu = 0.0;
      for (int k = 0; k < 40; ++k) {
        double pressure = 0.0;
        cpu += tremolo::testing::cpu_seconds([&] { pressure = clay.pressure(0.1) / PunchedClay::exact; });
        fmt::print("{},{},{:.4g},{:.5g},{:.4g}\n", rough ? 1 : 0, cells, clay.sunk(), pressure, cpu);
      }
      std::fflush(stdout);
    }
}
