// The domain's step on a graded mesh: what a uniform mesh does, it must do too.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/step/grid_update.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "mpm_domain/step/time_step.hpp"
#include "mpm_domain/transfer/gather.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/affine_velocity.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/for_particles.hpp"
#include "tests/support/no_traction.hpp"
#include "tests/support/quiet_ground.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>

namespace tremolo::mpm_domain {
namespace {

/// 12 m x 8 m of 1 m cells; half-metre cells around x = 6 m at the surface, quarter-metre ones in their
/// corner.
Spec graded_box(int per_cell = 2) {
  Spec spec = test_support::elastic_box(12.0, 8.0, 1.0);
  spec.particles_per_cell = per_cell;
  spec.refine = {{{3.0, -5.0, 9.0, 0.0}, 1}, {{5.0, -3.0, 7.0, 0.0}, 2}};
  return spec;
}

using test_support::for_particles;

TEST(GradedDomain, ParticlesGoWithTheirCells) {
  for (int per_cell = 1; per_cell <= 4; ++per_cell) {
    Domain domain(graded_box(per_cell));
    ASSERT_EQ(domain.sets.size(), 3U);
    double volume = 0.0;
    for_particles(domain, [&](Particles& set, std::size_t k) {
      const double cell = 1.0 / (1 << set.level);
      EXPECT_NEAR(set.half_size, 0.5 * cell / per_cell, 1e-15);
      EXPECT_EQ(domain.mesh->tree().finest_in(box_of(set, k)), set.level);
      volume += set.volume[k];
    });
    EXPECT_NEAR(volume, 12.0 * 8.0, 1e-10);
    EXPECT_EQ(domain.sets[2].size(), 8U * 12U * static_cast<std::size_t>(per_cell * per_cell));
  }
}

/// Which law holds in a cell depends on its size.
TEST(GradedDomain, TakesTheLawOfTheCellsLevel) {
  Spec spec = graded_box();
  spec.soils.front().finer_laws = {materials::LinearElastic{{1701.0, 40e6, 0.28}},
                                   materials::LinearElastic{{1702.0, 40e6, 0.28}}};
  const Domain domain(spec);
  for (const Particles& set : domain.sets)
    EXPECT_EQ(materials::elasticity(set.law).density, 1700.0 + set.level);
}

/// Refined everywhere, the mesh is the uniform one of half the size.
TEST(GradedDomain, RefinedEverywhereIsTheFinerUniformMesh) {
  for (const Transfer transfer : {Transfer::apic, Transfer::flip}) {
    Spec fine = test_support::elastic_box(10.0, 6.0, 0.5);
    Spec refined = test_support::elastic_box(10.0, 6.0, 1.0);
    refined.refine = {{refined.box, 1}};
    std::map<std::pair<double, double>, std::array<double, 2>> results;
    double difference = 0.0;
    double largest = 0.0;
    for (Spec* spec : {&fine, &refined}) {
      spec->scheme.transfer = transfer;
      Domain domain(*spec);
      test_support::PlaneWave wave;
      wave.angle = 15.0 * std::numbers::pi / 180.0;
      wave.y_reference = -6.0;
      Stepper stepper(domain, 0.8, test_support::plane_wave_source(domain, wave, true));
      for (int step = 0; step < 100; ++step)
        stepper.step();
      for_particles(domain, [&](Particles& set, std::size_t k) {
        const std::pair position{std::round(64.0 * set.x_initial[k]), std::round(64.0 * set.y_initial[k])};
        if (spec == &fine) {
          results[position] = {set.vx[k], set.sxy[k]};
          return;
        }
        ASSERT_TRUE(results.contains(position));
        largest = std::max(largest, std::abs(set.vx[k]));
        difference = std::max({difference, std::abs(set.vx[k] - results[position][0]),
                               std::abs(set.sxy[k] - results[position][1]) / 1e6});
      });
    }
    EXPECT_GT(largest, 0.02);
    EXPECT_LT(difference, 1e-12);
  }
}

struct Totals {
  double mass = 0.0;
  Vector momentum;
  double spin = 0.0;
};

/// act(n, x, y) for every node and its place, m.
template <typename Act>
void for_nodes(const Domain& domain, const Act& act) {
  for (int level = 0; level < domain.lattice_count(); ++level) {
    const Lattice& lattice = domain.lattice(level);
    for (int j = 0; j < lattice.ny; ++j)
      for (int i = 0; i < lattice.nx; ++i)
        act(lattice.index(i, j), lattice.x0 + i * lattice.h, lattice.y0 + j * lattice.h);
  }
}

Totals grid_totals(const Domain& domain) {
  Totals total;
  const Grid& grid = domain.grid;
  for_nodes(domain, [&](std::size_t n, double x, double y) {
    total.mass += grid.mass[n];
    total.momentum.x += grid.momentum_x[n];
    total.momentum.y += grid.momentum_y[n];
    total.spin += x * grid.momentum_y[n] - y * grid.momentum_x[n];
  });
  return total;
}

/// A uniform field v = a + A x, with C = A.
void set_linear_field(Domain& domain, Vector a, const std::array<double, 4>& gradient) {
  const auto [xx, xy, yx, yy] = gradient;
  for_particles(domain, [&](Particles& p, std::size_t k) {
    p.vx[k] = a.x + xx * p.x[k] + xy * p.y[k];
    p.vy[k] = a.y + yx * p.x[k] + yy * p.y[k];
    test_support::set_affine_velocity(domain, p, k, {xx, xy, yx, yy});
  });
}

/// Passes over nodes leave out what soil does not touch: a node left out that something does would keep its
/// mass from step to step.
TEST(GradedDomain, AllSoilIsOnTheNodesThatStepsPassOver) {
  for (const double speed : {0.0, 3.0, 30.0}) {
    Domain domain(graded_box());
    set_linear_field(domain, {speed, 0.5 * speed}, {0.0, 0.0, 0.0, 0.0});
    Stepper stepper(domain, 0.0, test_support::no_traction(domain));
    double soil = 0.0;
    for_particles(domain, [&](Particles& p, std::size_t k) { soil += p.mass[k]; });
    for (int n = 0; n < 60; ++n) {
      stepper.step();
      double passed = 0.0;
      for (const NodeRange& nodes : domain.soil_rows)
        for (std::size_t node = nodes.begin; node < nodes.end; ++node)
          passed += domain.grid.mass[node];
      ASSERT_NEAR(passed / soil, 1.0, 1e-12);
      ASSERT_NEAR(grid_totals(domain).mass / soil, 1.0, 1e-12);
    }
  }
}

TEST(GradedDomain, ScatterConservesMassMomentumAndAngularMomentum) {
  Domain domain(graded_box());
  set_linear_field(domain, {0.3, -0.2}, {0.1, -0.4, 0.7, 0.2});
  scatter(domain, ScatterPart::both);
  Totals expected;
  for_particles(domain, [&](Particles& p, std::size_t k) {
    expected.mass += p.mass[k];
    expected.momentum.x += p.mass[k] * p.vx[k];
    expected.momentum.y += p.mass[k] * p.vy[k];
    expected.spin += p.mass[k] * (p.x[k] * p.vy[k] - p.y[k] * p.vx[k] + p.byx[k] - p.bxy[k]);
  });
  const Totals grid = grid_totals(domain);
  EXPECT_NEAR(grid.mass, expected.mass, 1e-12 * expected.mass);
  EXPECT_NEAR(grid.momentum.x, expected.momentum.x, 1e-12 * expected.mass);
  EXPECT_NEAR(grid.momentum.y, expected.momentum.y, 1e-12 * expected.mass);
  EXPECT_NEAR(grid.spin, expected.spin, 1e-11 * expected.mass);
}

TEST(GradedDomain, RigidMotionCausesNoStressOnAnyLevel) {
  Domain domain(graded_box());
  // A turn by theta in the step: A = dt grad v = R - I.
  const double dt = 1e-3;
  const double theta = 1e-2;
  const double shrink = (std::cos(theta) - 1.0) / dt; // 1/s
  const double spin = std::sin(theta) / dt;           // rad/s
  set_linear_field(domain, {1.0, 2.0}, {shrink, -spin, spin, shrink});
  scatter(domain, ScatterPart::both);
  grid_velocities(domain, domain.soil_rows);
  // The lumped grid velocity of a linear field is that field only where the weights are symmetric about the
  // node: away from free edges and level interfaces. The exact field on the nodes must come back everywhere.
  for (int level = 0; level < domain.lattice_count(); ++level) {
    const Lattice& lattice = domain.lattice(level);
    for (int j = 0; j < lattice.ny; ++j)
      for (int i = 0; i < lattice.nx; ++i) {
        const std::size_t n = lattice.index(i, j);
        const double x = lattice.x0 + i * lattice.h;
        const double y = lattice.y0 + j * lattice.h;
        domain.grid.vx_before[n] = domain.grid.vx_after[n] = 1.0 + shrink * x - spin * y;
        domain.grid.vy_before[n] = domain.grid.vy_after[n] = 2.0 + spin * x + shrink * y;
      }
  }
  std::vector<Vector> d; // where B is taken
  for_particles(
      domain, [&](Particles& p, std::size_t k) { d.push_back(test_support::second_moments(domain, p, k)); });
  gather(domain, dt, {.velocity = true, .position = true, .strain = true});
  // What is left of A - A^2/2; A alone would be a contraction by theta^2/2.
  const double stress =
      2.0 * materials::elasticity(domain.sets.front().law).p_modulus() * std::pow(theta, 4) / 4.0; // Pa
  std::size_t next = 0;
  for_particles(domain, [&](Particles& p, std::size_t k) {
    const Vector moments = d[next++];
    EXPECT_NEAR(p.sxx[k], 0.0, stress);
    EXPECT_NEAR(p.syy[k], 0.0, stress);
    EXPECT_NEAR(p.sxy[k], 0.0, 1e-3 * stress);
    EXPECT_NEAR(p.byx[k], spin * moments.x, 1e-12 * spin);
    EXPECT_NEAR(p.bxy[k], -spin * moments.y, 1e-12 * spin);
    EXPECT_NEAR(p.bxx[k], shrink * moments.x, 1e-12 * spin);
  });
}

/// v = A x, told by particles wherever they stand, comes to every node as A x: APIC smooths no linear field.
TEST(GradedDomain, ApicHandsLinearVelocitiesToNodesOfAllLevels) {
  for (const int per_cell : {1, 2, 4})
    for (const double shift : {0.0, 0.13}) {
      Spec spec = graded_box(per_cell);
      spec.scheme.transfer = Transfer::apic;
      Domain domain(spec);
      const test_support::AffineVelocity a{.xx = 0.3, .xy = -1.1, .yx = 0.7, .yy = 0.9};
      for_particles(domain, [&](Particles& set, std::size_t k) {
        set.x[k] += shift;
        set.y[k] -= 0.6 * shift;
        set.vx[k] = a.xx * set.x[k] + a.xy * set.y[k];
        set.vy[k] = a.yx * set.x[k] + a.yy * set.y[k];
        test_support::set_affine_velocity(domain, set, k, a);
      });
      sort_particles(domain);
      scatter(domain, ScatterPart::motion);
      grid_velocities(domain, domain.soil_rows);
      const Grid& grid = domain.grid;
      for_nodes(domain, [&](std::size_t n, double x, double y) {
        if (grid.mass[n] <= 1e-6 * 1700.0)
          return;
        EXPECT_NEAR(grid.vx_before[n], a.xx * x + a.xy * y, 1e-11)
            << x << ", " << y << ", per cell " << per_cell;
        EXPECT_NEAR(grid.vy_before[n], a.yx * x + a.yy * y, 1e-11)
            << x << ", " << y << ", per cell " << per_cell;
      });
    }
}

TEST(GradedDomain, TranslationThroughAllLevelsStaysRigid) {
  for (const Transfer transfer : {Transfer::apic, Transfer::flip}) {
    Spec spec = graded_box();
    spec.scheme.transfer = transfer;
    spec.regions = {{0, {{1.0, -4.0}, {3.0, -4.0}, {3.0, -2.0}, {1.0, -2.0}}}};
    Domain domain(spec);
    for_particles(domain, [](Particles& set, std::size_t k) { set.vx[k] = 20.0; });
    Stepper stepper(domain, 0.0, test_support::no_traction(domain));
    while (stepper.time() < 0.4)
      stepper.step();
    for_particles(domain, [&](Particles& set, std::size_t k) {
      EXPECT_NEAR(set.x[k] - set.x_initial[k], 20.0 * stepper.time(), 1e-10);
      EXPECT_NEAR(set.vx[k], 20.0, 1e-10);
      EXPECT_NEAR(set.sxx[k], 0.0, 1e-3); // Pa, of 40 MPa soil
    });
  }
}

/// The faces' shares of a node add up to the trapezoid of real edge lengths.
TEST(GradedDomain, FacesGiveNodesTheirTributaryLengths) {
  Spec spec = test_support::elastic_box(8.0, 6.0, 1.0);
  spec.refine = {
      {{0.0, -4.0, 3.0, -2.0}, 1}}; // at the left side: real nodes at y = -6, -5, -4, -3.5, -3, -2.5, -2 ...
  const Domain domain(spec);
  std::map<double, double> length; // by y
  for (const BoundaryFace& face : domain.boundary.faces()) {
    if (face.side != Side::left)
      continue;
    FaceWeights weights;
    face_weights(domain, face, weights);
    for (const FaceWeight& w : weights)
      for (int level = 0; level < domain.lattice_count(); ++level) {
        const Lattice& lattice = domain.lattice(level);
        if (w.node < lattice.first || w.node >= lattice.first + lattice.count() || w.w < 1e-12)
          continue;
        const std::size_t row = (w.node - lattice.first) / static_cast<std::size_t>(lattice.nx);
        length[lattice.y0 + lattice.h * static_cast<double>(row)] += w.w * face.length;
      }
  }
  const std::map<double, double> expected{{-6.0, 0.5}, {-5.0, 1.0},  {-4.0, 0.75}, {-3.5, 0.5}, {-3.0, 0.5},
                                          {-2.5, 0.5}, {-2.0, 0.75}, {-1.0, 1.0},  {0.0, 0.5}};
  ASSERT_EQ(length.size(), expected.size());
  for (const auto& [y, l] : expected)
    EXPECT_NEAR(length[y], l, 1e-12) << "y = " << y;
}

/// A stress that varies linearly with depth, on three levels and with the supports replaced by tractions.
TEST(GradedDomain, StandsUnderItsWeightAndStaysSo) {
  Spec spec = graded_box();
  spec.gravity = 9.81;
  Domain domain(spec);
  replace_constraints(domain, relax_under_gravity(domain, {}, [](long, double) {}));
  const double scale = 1700.0 * 9.81 * 8.0;
  double worst = 0.0;
  for_particles(domain, [&](Particles& set, std::size_t k) {
    worst = std::max(worst, std::abs(set.syy[k] - 1700.0 * 9.81 * set.y[k]) / scale);
  });
  EXPECT_LT(worst, 0.25 * 0.25 / 8.0); // (l/h)^2 of the weight of a cell
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  while (stepper.time() < 0.3)
    stepper.step();
  double fastest = 0.0;
  for_particles(domain, [&](Particles& set, std::size_t k) {
    fastest = std::max(fastest, std::hypot(set.vx[k], set.vy[k]));
  });
  EXPECT_LT(fastest, 1e-6);
}

/// The graded box on stiffer ground in coarse cells.
Spec box_on_stiff_ground(double times_stiffer) {
  Spec spec = graded_box();
  spec.soils.push_back({"stiff", materials::LinearElastic{{1700.0, times_stiffer * 40e6, 0.28}}});
  spec.regions.push_back({1, {{0.0, -8.0}, {12.0, -8.0}, {12.0, -7.0}, {0.0, -7.0}}});
  return spec;
}

TEST(GradedDomain, TheStepIsThatOfTheFinestCellsInTheirSoil) {
  const Spec spec = box_on_stiff_ground(16.0);
  Domain domain(spec);
  const double c = materials::elasticity(spec.soils.front().law).p_wave_speed();
  // 0.25 m cells with c against 1 m cells with 4 c: the same.
  EXPECT_NEAR(critical_time_step(domain, 0.0), 0.65 * 0.25 / c, 1e-12);
}

/// Neither the finest cells nor, of these, the fastest waves need set the limit: the pair that does is named.
TEST(GradedDomain, AStepOverTheLimitIsRefusedWithTheCellsAndWavesThatSetIt) {
  for (const double times_stiffer : {64.0, 4.0}) {
    Spec spec = box_on_stiff_ground(times_stiffer);
    spec.scheme.dt = 1.0;
    Domain domain(spec);
    const double c = materials::elasticity(spec.soils.front().law).p_wave_speed();
    const bool coarse_sets_it = times_stiffer > 16.0;
    const std::string pair = fmt::format("with h = {:.6g} m, c_p = {:.6g} m/s", coarse_sets_it ? 1.0 : 0.25,
                                         coarse_sets_it ? 8.0 * c : c);
    try {
      next_time_step(domain, step_bounds(domain), 0.0, 0.0);
      FAIL() << "a time step of 1 s was accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr(pair));
    }
  }
}

/// A particle of a narrow period may touch a node and its image, which are two positions.
TEST(GradedDomain, APeriodOfTwoCellsIsTwiceInOneOfFour) {
  const auto velocities = [](double width) {
    Spec spec = test_support::elastic_box(width, 6.0, 1.0);
    spec.sides = mpm_domain::Sides::periodic;
    spec.scheme.transfer = Transfer::apic;
    spec.refine = {{{0.0, -3.0, width, 0.0}, 1}};
    Domain domain(spec);
    for_particles(domain, [](Particles& set, std::size_t k) {
      set.vx[k] = 0.1 * std::cos(std::numbers::pi * set.x[k]) * set.y[k];
      set.vy[k] = 0.1 * std::sin(std::numbers::pi * set.x[k]) + 0.02 * set.y[k];
    });
    Stepper stepper(domain, 0.0, test_support::no_traction(domain));
    for (int step = 0; step < 100; ++step)
      stepper.step();
    std::map<std::pair<long, long>, Vector> found; // by place, mm
    for_particles(domain, [&](Particles& set, std::size_t k) {
      if (set.x_initial[k] < 2.0)
        found[{std::lround(1e3 * set.x_initial[k]), std::lround(1e3 * set.y_initial[k])}] = {set.vx[k],
                                                                                             set.vy[k]};
    });
    return found;
  };
  const auto narrow = velocities(2.0);
  const auto wide = velocities(4.0);
  ASSERT_EQ(narrow.size(), wide.size());
  for (const auto& [position, v] : narrow) {
    EXPECT_NEAR(v.x, wide.at(position).x, 1e-9);
    EXPECT_NEAR(v.y, wide.at(position).y, 1e-9);
  }
}

/// On a torus the seam cannot be seen, wherever the fine cells lie.
TEST(GradedDomain, SeamOfAPeriodCannotBeSeen) {
  std::vector<std::map<std::pair<long, long>, double>> results;
  for (const double shift : {0.0, 5.0}) {
    Spec spec = test_support::elastic_box(8.0, 4.0, 1.0);
    spec.sides = mpm_domain::Sides::periodic;
    // [2, 4] m, and moved across the seam: [7, 9] m
    if (shift == 0.0)
      spec.refine = {{{2.0, -2.0, 4.0, 0.0}, 1}};
    else
      spec.refine = {{{7.0, -2.0, 8.0, 0.0}, 1}, {{0.0, -2.0, 1.0, 0.0}, 1}};
    Domain domain(spec);
    const auto phase = [&](double x) { return 2.0 * std::numbers::pi * (x - shift) / 8.0; };
    for_particles(domain, [&](Particles& set, std::size_t k) {
      set.vx[k] = 3.0 + 0.4 * std::sin(phase(set.x[k]));
      set.vy[k] = 0.2 * std::cos(phase(set.x[k]));
    });
    Stepper stepper(domain, 0.0, test_support::no_traction(domain));
    while (stepper.time() < 0.5)
      stepper.step();
    auto& result = results.emplace_back();
    for_particles(domain, [&](Particles& set, std::size_t k) {
      // x_initial moves with a particle that is wrapped; what counts is its place in the pattern.
      const double x = set.x_initial[k] - shift;
      result[{std::lround(64.0 * (x - 8.0 * std::floor(x / 8.0))), std::lround(64.0 * set.y_initial[k])}] =
          set.sxy[k] + set.vx[k];
    });
  }
  ASSERT_EQ(results[0].size(), results[1].size());
  for (const auto& [position, value] : results[0]) {
    ASSERT_TRUE(results[1].contains(position));
    EXPECT_NEAR(value, results[1][position], 1e-6); // Pa, of some 1e5
  }
}

} // namespace
} // namespace tremolo::mpm_domain
