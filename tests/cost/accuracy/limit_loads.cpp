// Limit loads on more meshes than the suite has time for: whether soil fails on the one side of its published
// limit and stands on the other, with the CPU time that it takes to see.

#include "tests/verification/mpm_domain/limit_loads/growing_strength.hpp"
#include "tests/verification/mpm_domain/limit_loads/known_slopes.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <string>
#include <string_view>

namespace {

using namespace tremolo::mpm_domain;

/// @param beyond  the share of the limit (load, strength or factor) with which soil must fail
/// @param before  that with which it must stand
template <typename Limit>
void print(std::string_view row, const Limit& limit, double beyond, double before) {
  const std::clock_t start = std::clock();
  const bool fails = !stands(limit, beyond);
  const bool holds = stands(limit, before);
  fmt::print("{},{},{},{:.0f}\n", row, fails ? "fails" : "stands", holds ? "stands" : "fails",
             double(std::clock() - start) / CLOCKS_PER_SEC);
}

int run(int argc, char** argv) {
  const std::string_view of = argc > 1 ? argv[1] : "";
  const auto number = [&](int i) { return std::atof(argv[i]); };
  const std::string row = fmt::format("{}", fmt::join(argv + 1, argv + argc, ","));
  if (of == "taylor" && argc == 6)
    print(row, test::ClaySlope{{number(2), number(3), number(4)}, number(5)}, 0.95, 1.05);
  else if (of == "griffiths_and_lane" && argc == 5)
    print(row, test::SandySlope{number(2), number(3), number(4)}, 1.05, 0.95);
  else if ((of == "rough" || of == "smooth") && argc == 4)
    print(row, test::Footing{of == "rough", number(2), number(3)}, 1.05, 0.95);
  else if (of == "growing" && argc == 4)
    print(row, test::GrowingClay{number(2), number(3)}, 1.05, 0.95);
  else {
    fmt::print(
        stderr,
        "usage: {} taylor ANGLE_DEG DEPTH_FACTOR CELL_M NU | griffiths_and_lane DEPTH_FACTOR CELL_M NU | "
        "rough CELL_M NU | smooth CELL_M NU | growing CELL_M NU\n"
        "prints these, what soil does 5 % beyond its limit and 5 % before it, and CPU seconds\n",
        argv[0]);
    return 2;
  }
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
