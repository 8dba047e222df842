// Hard cases of the marched column: its one-step matrix near every limit, energy over 1e5 steps, long decays,
// laws with corners.

#include "freefield/marched/marched_column.hpp"
#include "freefield/twophase/step_limit.hpp"
#include "tests/support/oblique_march.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

namespace {

using namespace tremolo::freefield;
using namespace tremolo::freefield::testing;
using tremolo::materials::Drainage;
using tremolo::materials::DruckerPrager;
using tremolo::materials::MasingShear;

/// Eight elements in two layers, base up: thickness 4 m each.
Profile two_layers(Layer upper, Layer lower) {
  return {.surface_level = 8.0,
          .layers = {std::move(upper), std::move(lower)},
          .half_space = tremolo::materials::Elasticity::from_wave_speeds(2400.0, 760.0, 1900.0),
          .gravity = 9.81,
          .water = WaterTable{8.0, {}}};
}

struct Ground {
  const char* name;
  Profile profile;
  double rounding = 1e-12; ///< of an eigenvalue
};

std::vector<Ground> grounds() {
  const auto coupled = [](double n, double k) { return wet(4.0, n, 200.0, 0.3, k); };
  const auto undrained = [](double n) { return wet(4.0, n, 200.0, 0.3, 1e-3, Drainage::undrained); };
  const Layer dry{4.0, elastic(1800.0, 150.0, 0.3)}, stiff{4.0, elastic(2000.0, 300.0, 0.35)};
  Profile under_dry = two_layers(dry, coupled(0.4, 1e-3));
  under_dry.water->level = 4.0;
  Profile drained = two_layers(dry, stiff);
  drained.water.reset();
  return {{"dry", drained},
          {"undrained", two_layers(undrained(0.5), undrained(0.3))},
          {"coupled", two_layers(coupled(0.5, 1e-1), coupled(0.3, 1e-3))},
          {"free water", two_layers(coupled(0.3, 1e6), coupled(0.5, 1e6))},
          // Drag of 1e13 Pa s/m2 beside masses: the eigenvalues are found to nine digits.
          {"tight", two_layers(coupled(0.4, 1e-9), coupled(0.4, 1e-9)), 1e-8},
          {"dry over coupled", under_dry},
          {"coupled over undrained", two_layers(coupled(0.4, 1e-3), undrained(0.4))}};
}

/// The largest eigenvalue of the matrix that a step multiplies the state with: momenta, velocities and
/// stresses.
double largest_eigenvalue(const Profile& profile, BaseKind base, double share_of_critical,
                          double share_of_limit) {
  const ColumnMesh mesh = mesh_profile(profile, 1.0);
  const ColumnSoil soil(profile, mesh);
  MarchedState rest(wet_grid(profile, mesh, {}, false), soil, {profile, mesh, {}, 1.0});
  std::vector<double> moduli;
  soil.p_moduli(rest.soil, moduli);
  double fastest = profile.half_space.p_wave_speed();
  for (std::size_t e = 0; e < mesh.elements(); ++e)
    fastest = std::max(fastest, fast_wave_speed(rest.grid, e, moduli[e]));
  MarchedScheme scheme{.slowness = share_of_critical / fastest, .base = base};
  scheme.dt = share_of_limit * step_limit(rest.grid, moduli, scheme.slowness);
  if (base == BaseKind::compliant)
    scheme.half_space = base_impedance(profile.half_space, scheme.slowness).outgoing;
  MarchedTangent tangent(mesh.elements());
  tangent.factor(scheme, rest, moduli);

  const std::size_t nodes = rest.velocity.size(), elements = mesh.elements();
  const std::size_t size = 8 * nodes + 4 * elements;
  // Units in which all values are of one size: velocities of 1 m/s.
  constexpr double impedance = 4e5; // Pa s/m
  const auto values = [&](MarchedState& state) {
    std::vector<std::pair<double*, double>> all;
    for (std::size_t i = 0; i < nodes; ++i)
      for (Eigen::Index c = 0; c < 2; ++c) {
        all.emplace_back(&state.momenta[i].mixture[c], 2000.0);
        all.emplace_back(&state.momenta[i].fluid[c], 1000.0);
        all.emplace_back(&state.velocity[i].solid[c], 1.0);
        all.emplace_back(&state.velocity[i].relative[c], 1.0);
      }
    for (ElementStress& s : state.stress)
      for (double* value : {&s.xx, &s.yy, &s.xy, &s.pressure})
        all.emplace_back(value, impedance);
    return all;
  };
  Eigen::MatrixXd matrix(size, size);
  MarchedTrial trial(soil, rest);
  for (std::size_t column = 0; column < size; ++column) {
    MarchedState state = rest;
    const auto [value, unit] = values(state)[column];
    *value = unit;
    for (std::size_t e = 0; e < elements; ++e) {
      state.soil.sxx[e] += state.stress[e].xx;
      state.soil.syy[e] += state.stress[e].yy;
      state.soil.sxy[e] += state.stress[e].xy;
      state.law_stress.row(static_cast<Eigen::Index>(e)) << state.stress[e].xx, state.stress[e].yy,
          state.stress[e].xy;
      if (rest.grid.elements[e].stiffness == 0.0)
        state.stress[e].pressure = 0.0;
      state.excess[e] = state.stress[e].pressure;
      state.grid.elements[e].lowest_excess = -std::numeric_limits<double>::infinity();
    }
    trial.begin(scheme, state, {}, moduli, {});
    Increments x = Increments::Zero(static_cast<Eigen::Index>(elements), 4), residual = x;
    for (int i = 0; i < 3; ++i) {
      trial.evaluate(scheme, state, x, residual);
      tangent.solve(residual);
      x += residual;
    }
    trial.evaluate(scheme, state, x, residual);
    trial.finish(scheme);
    trial.accept(scheme, state);
    const auto after = values(state);
    for (std::size_t row = 0; row < size; ++row)
      matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
          *after[row].first / after[row].second;
  }
  return Eigen::EigenSolver<Eigen::MatrixXd>(matrix, false).eigenvalues().cwiseAbs().maxCoeff();
}

TEST(MarchedColumn, NoStepLetsAnythingGrowUpToTheCriticalAngleAndTheStepLimit) {
  for (const Ground& ground : grounds())
    for (const BaseKind base : {BaseKind::compliant, BaseKind::rigid})
      for (const double angle : {0.0, 0.5, 0.9, 0.99})
        for (const double step : {0.3, 0.95, 0.999}) {
          const double largest = largest_eigenvalue(ground.profile, base, angle, step);
          EXPECT_LT(largest - 1.0, ground.rounding)
              << ground.name << (base == BaseKind::rigid ? ", rigid" : "") << ", s c " << angle << ", step "
              << step;
        }
}

/// A pulse that ends: zero from t = 0.4 s on.
InputVelocity short_pulse(double angle_deg, double peak) {
  return [=](double t) {
    const double v = t > 0.0 && t < 0.4 ? peak * std::pow(std::sin(2.5 * std::numbers::pi * t), 3) : 0.0;
    return Velocity{v * std::cos(angle_deg * degree), -v * std::sin(angle_deg * degree)};
  };
}

MarchedSettings near_limit(const Profile& ground, double angle_deg, double share, BaseKind base) {
  const double s = std::sin(angle_deg * degree) / ground.half_space.s_wave_speed();
  return {.max_element_size = 2.0,
          .time_step = share * marched_step_limit(ground, 2.0, s, {}),
          .slowness_x = s,
          .base = base,
          .tolerance = 1e-9};
}

TEST(MarchedColumn, KeepsTheEnergyOfElasticSoilOverAHundredThousandSteps) {
  for (Profile ground : {dry_ground(), wet_ground(Drainage::undrained)}) {
    ground.gravity = 0.0; // whose stress would be rounded by as much as the wave's is in the end
    MarchedSettings settings = near_limit(ground, 15.0, 0.95, BaseKind::rigid);
    settings.tolerance = 1e-13;
    MarchedColumn column(ground, settings, short_pulse(15.0, 1e-7));
    march_to(column, 0.5);
    const auto held = [&] {
      const WetEnergy energy = column.energy();
      return energy.kinetic + energy.elastic + energy.pore - energy.gravity;
    };
    const double start = held();
    double change = 0.0;
    for (int i = 0; i < 100; ++i) {
      for (int k = 0; k < 1000; ++k)
        column.step();
      change = std::max(change, std::abs(held() / start - 1.0));
    }
    std::printf("energy changes by %.1e\n", change);
    EXPECT_LT(change, 1e-11);
  }
}

/// Ground whose soil yields in a pulse of 0.1 m/s.
Profile hysteretic_ground() {
  Profile ground = dry_ground();
  for (Layer& layer : ground.layers)
    layer.law = MasingShear{.elastic = layer.soil, .reference_strain = 1e-4, .exponent = 0.919};
  return ground;
}

TEST(MarchedColumn, MotionDiesOutOverAHundredThousandSteps) {
  struct Row {
    Profile ground;
    double angle_deg, peak;
  };
  for (const Row& row : {Row{dry_ground(), 32.0, 1e-4}, Row{hysteretic_ground(), 32.0, 0.1},
                         Row{wet_ground(Drainage::undrained), 21.0, 1e-4}, Row{wet_ground(), 21.0, 1e-4}}) {
    MarchedSettings settings = near_limit(row.ground, row.angle_deg, 0.95, BaseKind::compliant);
    settings.tolerance = MarchedSettings().tolerance;
    MarchedColumn column(row.ground, settings, short_pulse(row.angle_deg, row.peak));
    std::array<ColumnSample, 1> surface;
    const auto largest_of = [&](int steps) {
      double largest = 0.0;
      for (int i = 0; i < steps; ++i) {
        column.step();
        column.sample(std::array{20.0}, surface);
        largest = std::max(largest, std::hypot(surface[0].vx, surface[0].vy));
      }
      return largest;
    };
    const double first = largest_of(10'000);
    double before = first;
    for (int i = 0; i < 9; ++i) {
      const double now = largest_of(10'000);
      EXPECT_TRUE(now < before || now < 1e-9 * first) << "window " << i << ": " << now << " after " << before;
      before = now;
    }
    EXPECT_LT(before, 1e-6 * first);
  }
}

/// Loose dry sand that the motion throws up: its cone has a corner at zero pressure, which no smooth tangent
/// knows.
TEST(MarchedColumn, SandAtTheApexOfItsConeStaysBounded) {
  Profile ground = dry_ground();
  ground.gravity = 9.81;
  for (Layer& layer : ground.layers) {
    layer.soil.at_rest = 0.6;
    const DruckerPrager law{.elastic = layer.soil, .cohesion = 100.0, .friction = 30.0 * degree};
    layer.law = law;
  }
  const InputVelocity wave = short_pulse(15.0, 1.5);
  MarchedSettings settings = near_limit(ground, 15.0, 0.8, BaseKind::compliant);
  settings.tolerance = MarchedSettings().tolerance;
  MarchedColumn column(ground, settings, wave);
  std::array<ColumnSample, 1> surface;
  double largest = 0.0;
  while (column.time() < 4.0) {
    column.step();
    column.sample(std::array{20.0}, surface);
    largest = std::max(largest, std::hypot(surface[0].vx, surface[0].vy));
  }
  std::printf("%s\n", column.report().c_str());
  EXPECT_LT(largest, 4.0 * 1.5);
  EXPECT_LT(column.largest_residual(), 5e-3);
  EXPECT_LT(std::abs(column.energy().missing()), 0.02 * column.energy().given());
}

} // namespace
