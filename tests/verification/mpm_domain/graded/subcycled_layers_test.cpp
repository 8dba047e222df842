// Matched layers behind faces of several clocks: what leaves a sub-cycled box through them, and what comes
// back.

#include "tests/support/blow.hpp"
#include "tests/support/particle_energy.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace tremolo {
namespace {

using mpm_domain::Spec;
using test_support::StruckGround;

constexpr double fine_step = 4e-4; // of cells of 0.25 m, s: 0.43 of the critical one

enum class Behind { dashpots, layers };

/// A box of 40 m by 20 m of 1 m cells.
/// @param wider m, on every side but the surface
Spec box(Behind behind, double wider = 0.0) {
  Spec spec = test_support::elastic_box(40.0 + 2.0 * wider, 20.0 + wider, 1.0);
  spec.threads = 1;
  if (behind == Behind::layers) {
    using enum mpm_domain::Side;
    spec.matched_sides = {left, right, base};
  }
  return spec;
}

/// Every level takes the step of its own cells.
Spec subcycled(Spec spec) {
  spec.scheme.subcycle = true;
  spec.scheme.dt = 4.0 * fine_step;
  return spec;
}

/// Half-metre and quarter-metre cells where the left side meets the surface: its faces run on three clocks.
Spec fine_at_the_side(Spec spec) {
  spec.refine = {{{0.0, -6.0, 8.0, 0.0}, 1}, {{0.0, -3.0, 4.0, 0.0}, 2}};
  return spec;
}

/// Around the middle of the surface, away from all faces.
Spec fine_inside(Spec spec) {
  const double x = 0.5 * spec.box.x_max;
  spec.refine = {{{x - 8.0, -6.0, x + 8.0, 0.0}, 1}, {{x - 4.0, -3.0, x + 4.0, 0.0}, 2}};
  return spec;
}

/// When the waves have left, s; those of the later ones have been reflected more than once.
constexpr std::array times{0.64, 0.8, 0.96};

struct Left {
  std::array<double, times.size()> energy; ///< of the particles at these times
  double taken = 0.0;                      ///< by the layers
  double residual = 0.0;                   ///< of the ledger at the end
};

/// All over the energy of the blow.
Left left_after_a_blow(const Spec& spec) {
  StruckGround run(spec);
  const double start = test_support::particle_energy(run.domain);
  Left left{};
  for (std::size_t i = 0; i < times.size(); ++i) {
    while (run.stepper.time() < times[i] - 1e-9)
      run.stepper.step();
    left.energy[i] = test_support::particle_energy(run.domain) / start;
  }
  left.taken = -run.domain.energy.dashpots / start;
  left.residual = std::abs(run.domain.energy.residual()) / start;
  return left;
}

/// As much is left as in coarse cells alone that take the coarse step: fine cells on clocks of their own
/// change nothing. With one step for all, particles of coarse cells transfer four times as often, which damps
/// all waves more; then, 15 % less is left, with dashpots 26 %.
TEST(SubcycledLayers, LeaveNoMoreEnergyThanLayersBehindOneClock) {
  const Left levels = left_after_a_blow(subcycled(fine_at_the_side(box(Behind::layers))));
  Spec spec = box(Behind::layers);
  spec.scheme.dt = 4.0 * fine_step;
  const Left coarse = left_after_a_blow(spec);
  for (std::size_t i = 0; i < times.size(); ++i) {
    RecordProperty("left_at_" + std::to_string(i), std::to_string(1e6 * levels.energy[i]) + "e-6");
    EXPECT_LT(levels.energy[i], 1.05 * coarse.energy[i]) << times[i] << " s";
  }
  EXPECT_LT(levels.energy[0], 2e-3);
  EXPECT_GT(levels.taken, 0.85);
  EXPECT_LT(levels.residual, 0.005);
}

/// Nothing comes back from the wide box within 0.6 s. Measured: 0.039 before layers, 0.141 before dashpots.
TEST(SubcycledLayers, TakeUpABlowInTheGround) {
  const auto after = [](Behind behind, double wider = 0.0) {
    return test_support::seen_after_a_blow(subcycled(fine_inside(box(behind, wider))), 0.6);
  };
  const std::vector<double> wide = after(Behind::dashpots, 50.0);
  const double dashpots = test_support::relative_difference(after(Behind::dashpots), wide);
  const double layers = test_support::relative_difference(after(Behind::layers), wide);
  RecordProperty("dashpots", std::to_string(dashpots));
  RecordProperty("layers", std::to_string(layers));
  EXPECT_LT(layers, 0.3 * dashpots) << dashpots;
}

} // namespace
} // namespace tremolo
