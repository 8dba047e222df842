// Memory of ranks that fill a domain together, sort it, bring it to rest, dig in it and shake it: a share
// each.

#include "mpm_domain/gravity/static_stages.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/ranks/communicator.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/quiet_ground.hpp"
#include "tests/unit/mpm_domain/ranks/structure_models.hpp"
#include "tests/unit/mpm_domain/ranks/test_ranks.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <string>

namespace tremolo {
namespace {

using mpm_domain::Domain;

/// A line of /proc/self/status, bytes.
double status(const std::string& wanted) {
  std::ifstream file("/proc/self/status");
  std::string line;
  while (std::getline(file, line))
    if (line.starts_with(wanted + ":"))
      return 1024.0 * std::stod(line.substr(wanted.size() + 1));
  return 0.0;
}

/// From now on the peak of the memory of this process counts anew.
void forget_peak() {
  std::ofstream("/proc/self/clear_refs") << "5";
}

/// 3200 m by 64 m of ground in cells of 1 m.
mpm_domain::Spec long_ground() {
  mpm_domain::Spec spec = test_support::elastic_box(3200.0, 64.0, 1.0);
  spec.gravity = 9.81;
  return spec;
}

/// Runs, and compares the peak on any rank with a share of what one process would take.
void expect_share(const char* name, const std::function<void()>& run) {
  mpm_domain::Communicator& ranks = *test_support::test_ranks();
  constexpr double particles = 4.0 * 3200.0 * 64.0;
  // Fields of a particle, and of a quarter of a node: 143 MB.
  constexpr double whole = particles * (136.0 + 34.0 + 4.0);
  forget_peak();
  const double before = status("VmRSS");
  run();
  double taken = status("VmHWM") - before;
  ranks.largest({&taken, 1});
  testing::Test::RecordProperty(name, std::to_string(1e-6 * taken));
  const double share = whole / ranks.size();
  EXPECT_GT(taken, 0.5 * share);
  constexpr double besides = 40e6; // messages, threads, faces, pages that rows of several ranks share
  EXPECT_LT(taken, 1.5 * share + besides);
}

TEST(MemoryOfRanks, IsThatOfTheirShares) {
  TREMOLO_NEED_RANKS();
  expect_share("megabytes", [] {
    Domain domain(long_ground(), test_support::test_ranks());
    mpm_domain::StaticStages stages(domain, {.residual = 0.5}, {}, [](std::size_t, long, double) {});
    stages.next();
    replace_constraints(domain, stages.finish());
    mpm_domain::Stepper stepper(domain, 0.0, test_support::quiet_ground());
    stepper.step();
    sort_particles(domain);
    stepper.step();
  });
}

/// Structures, props, loads, linings and earthworks look for particles near them, and no rank needs more for
/// it.
TEST(MemoryOfRanks, IsThatOfTheirSharesWithStructures) {
  TREMOLO_NEED_RANKS();
  expect_share("megabytes_with_structures", [] {
    mpm_domain::Spec spec = long_ground();
    test_support::add_propped_walls(spec);
    spec.loads = {{.x_min = 300.0, .x_max = 320.0, .pressure = 2e4, .shear = 0.0}};
    test_support::add_lining(spec);
    spec.linings.front() = test_support::concrete_lining({100.0, -15.0}, 0.6);
    const mpm_domain::Region trench{0, test_support::rectangle(200.0, -3.0, 220.0, 0.0)};
    spec.regions.push_back(trench);
    spec.earthworks = {{{0.0, 0.02}, {}, {trench}}};
    Domain domain(spec, test_support::test_ranks());
    mpm_domain::Stepper stepper(domain, 0.0, test_support::quiet_ground());
    stepper.step();
    stepper.step();
  });
}

} // namespace
} // namespace tremolo
