// The error of displacement in a manufactured solution (tests/support/manufactured_block.hpp), the largest
// over one period, against cell size, by transfer, particles per cell and their boxes, for a small and a
// large amplitude. Prints CSV:
//
//     cost_manufactured > manufactured.csv

#include "tests/support/manufactured_block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <string>
#include <vector>

int main() {
  using namespace tremolo;
  using mpm_domain::ParticleBoxes;
  using mpm_domain::StepOrder;
  using mpm_domain::Transfer;
  struct Named {
    std::string name;
    mpm_domain::Scheme scheme;
    int particles_per_cell;
    ParticleBoxes boxes = ParticleBoxes::fixed;
  };
  std::vector<Named> schemes;
  for (const int particles : {1, 2, 3, 4}) {
    schemes.push_back({"APIC musl", {Transfer::apic, StepOrder::musl}, particles});
    schemes.push_back({"FLIP musl", {Transfer::flip, StepOrder::musl}, particles});
    schemes.push_back({"APIC musl", {Transfer::apic, StepOrder::musl}, particles, ParticleBoxes::deforming});
  }
  schemes.push_back({"APIC usl", {Transfer::apic, StepOrder::usl}, 2});
  schemes.push_back({"FLIP usl", {Transfer::flip, StepOrder::usl}, 2});
  fmt::print("amplitude,scheme,particles_per_cell,boxes,cells,relative_error,cpu_s,updates\n");
  for (const double amplitude : {1e-6, 0.001, 0.05})
    for (const Named& named : schemes)
      for (const int cells : {8, 16, 32, 64}) {
        const std::clock_t begin = std::clock();
        test_support::ManufacturedBlock block(amplitude, cells, named.particles_per_cell, named.scheme,
                                              named.boxes);
        double error = 0.0;
        double updates = 0.0;
        while (block.time() < block.period()) {
          block.step();
          error = std::max(error, block.displacement_error());
          updates += static_cast<double>(block.particles());
        }
        fmt::print("{:g},{},{},{},{},{:.6g},{:.4g},{:.6g}\n", amplitude, named.name, named.particles_per_cell,
                   named.boxes == ParticleBoxes::fixed ? "fixed" : "deforming", cells, error,
                   static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, updates);
        std::fflush(stdout);
      }
}
