// The closed form of drag at a node: flow by Darcy's law at any step, momentum of both phases, and its
// limits.

#include "mpm_domain/water/mixture_kick.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tremolo::mpm_domain {
namespace {

constexpr double volume = 0.25; // m2
constexpr double porosity = 0.4;
constexpr double water = 1000.0;  // kg/m3
constexpr double grains = 2650.0; // kg/m3
constexpr double gravity = 9.81;  // m/s2
constexpr double gradient = 0.1;  // of head
const Lanes open = all(1.0);
const Lanes none{};

MixtureNodes saturated_nodes(double permeability) {
  return {.solid_mass = all((1.0 - porosity) * grains * volume),
          .water_mass = all(porosity * water * volume),
          .full_water = all(water * volume),
          .resistance = all(volume * water * gravity / permeability),
          .has_soil = Lanes{} == Lanes{},
          .has_water = Lanes{} == Lanes{}};
}

/// lambda: the rate at which drag takes w.
double drag_rate(double permeability) {
  const double density = (1.0 - porosity) * grains + porosity * water;
  return porosity * gravity * density / (permeability * (1.0 - porosity) * grains);
}

TEST(MixtureKick, FlowIsDarcysAtAnyStep) {
  constexpr double k = 1e-4;
  const MixtureNodes nodes = saturated_nodes(k);
  for (const double step : {1e-3, 1e-1, 1.0, 1e1, 1e3, 1e6}) { // lambda dt
    SCOPED_TRACE(step);
    const double dt = step / drag_rate(k);
    const Lanes pull = all(volume * water * gravity * gradient);
    double w = 0.0;
    for (int i = 0; i < 20.0 + 20.0 / step; ++i) {
      const MixtureKick a = kick_mixture(nodes, none, none, pull, all(w), open, dt);
      w += dt * (a.water[0] - a.solid[0]);
    }
    EXPECT_NEAR(porosity * w, k * gradient, 1e-6 * k * gradient);
  }
}

/// Drag multiplied onto the velocity after the kick lets hardly any water flow once lambda dt exceeds 1: the
/// test above tells it from the closed form.
TEST(MixtureKick, SplitDragIsNotDarcys) {
  constexpr double k = 1e-4;
  const double dt = 6.6 / drag_rate(k);
  const double relative = gravity * gradient * (1.0 + porosity * water / ((1.0 - porosity) * grains));
  double w = 0.0;
  for (int i = 0; i < 100; ++i)
    w = std::exp(-drag_rate(k) * dt) * (w + dt * relative);
  EXPECT_LT(porosity * w, 0.02 * k * gradient);
}

TEST(MixtureKick, KeepsTheMomentumOfBoth) {
  for (const double k : {1e-1, 1e-4, 1e-9}) {
    const MixtureNodes nodes = saturated_nodes(k);
    const MixtureKick a = kick_mixture(nodes, all(3.0), none, all(-7.0), all(0.2), open, 1e-4);
    EXPECT_NEAR(nodes.solid_mass[0] * a.solid[0] + nodes.water_mass[0] * a.water[0], 3.0, 1e-11);
  }
}

TEST(MixtureKick, ClosedNodesHaveNoFlow) {
  const MixtureKick a = kick_mixture(saturated_nodes(1e-3), all(3.0), none, all(-7.0), all(0.2), none, 1e-4);
  EXPECT_NEAR(0.2 + 1e-4 * (a.water[0] - a.solid[0]), 0.0, 1e-16);
}

/// Endless drag is one mass; no water is dry soil; an empty node stays at rest.
TEST(MixtureKick, HasItsLimits) {
  MixtureNodes nodes = saturated_nodes(1e-30);
  const double mass = nodes.solid_mass[0] + nodes.water_mass[0];
  const MixtureKick locked = kick_mixture(nodes, all(3.0), all(5.0), all(-7.0), none, open, 1e-2);
  EXPECT_NEAR(locked.solid[0], 3.0 / (mass + 0.5 * 1e-2 * 5.0), 1e-16);
  EXPECT_NEAR(locked.water[0], locked.solid[0], 1e-16);

  nodes.has_water = Lanes{} != Lanes{};
  const MixtureKick dry = kick_mixture(nodes, all(3.0), all(5.0), all(-7.0), all(0.2), open, 1e-2);
  EXPECT_EQ(dry.solid[0], 3.0 / (nodes.solid_mass[0] + 0.5 * 1e-2 * 5.0));
  EXPECT_EQ(dry.water[0], dry.solid[0]);

  nodes.has_soil = nodes.has_water;
  const MixtureKick empty = kick_mixture(nodes, all(3.0), none, all(-7.0), all(0.2), open, 1e-2);
  EXPECT_EQ(empty.solid[0], 0.0);
  EXPECT_EQ(empty.water[0], 0.0);
}

} // namespace
} // namespace tremolo::mpm_domain
