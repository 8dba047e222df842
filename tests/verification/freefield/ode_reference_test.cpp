// The column by the method of lines against exact solutions: the Kelvin-Voigt layer under a pulse and simple
// waves in nonlinear soil (reference data), a layer on a rigid base in steady vibration; order two in space
// at a tight tolerance, all four integrators.

#include "freefield/ode/ode_column.hpp"
#include "tests/support/reference_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;
using tremolo::materials::MasingShear;
using Rows = std::vector<std::vector<double>>;

constexpr std::array<OdeMethod, 4> methods = {OdeMethod::adams, OdeMethod::bdf,
                                              OdeMethod::explicit_runge_kutta, OdeMethod::imex};

Rows rows_of(const std::string& name) {
  const auto file = tremolo::testing::reference_folder() / "waves" / name;
  return std::filesystem::exists(file) ? tremolo::testing::read_table(file) : Rows{};
}

OdeColumnSettings tight(OdeMethod method, double cell) {
  OdeColumnSettings settings;
  settings.max_cell_size = cell;
  settings.time_step = 2.5e-3;
  settings.method = method;
  settings.relative_tolerance = 1e-7;
  settings.absolute_tolerance = 1e-9;
  return settings;
}

/// Errors of velocity and stress at four levels, relative to their peaks.
std::array<double, 2> pulse_errors(const Rows& rows, OdeMethod method, double cell) {
  const Profile profile{.layers = {{30.0, Elasticity::from_wave_speeds(1800.0, 200.0, 400.0), 0.02}},
                        .half_space = Elasticity::from_wave_speeds(2200.0, 800.0, 1600.0)};
  auto settings = tight(method, cell);
  settings.damping = KelvinVoigtDamping{5.0 / 3.0};
  OdeColumn column(profile, settings, [](double t) {
    const double a = std::pow(std::numbers::pi * 3.0 * (t - 0.5), 2);
    return Velocity{(1.0 - 2.0 * a) * std::exp(-a), 0.0};
  });
  const std::array<double, 4> levels = {0.0, -7.5, -15.0, -30.0};
  std::array<ColumnSample, 4> samples;
  std::array<double, 2> error{}, peak{};
  for (const auto& row : rows) {
    if (row[0] > 2.0) {
      break;
    }
    while (column.time() < row[0] - 1e-4) {
      column.step();
    }
    column.sample(levels, samples);
    for (std::size_t level = 0; level < levels.size(); ++level) {
      const std::array<double, 2> computed = {samples[level].vx, samples[level].sxy};
      for (std::size_t q = 0; q < 2; ++q) {
        error[q] = std::max(error[q], std::abs(computed[q] - row[1 + 2 * level + q]));
        peak[q] = std::max(peak[q], std::abs(row[1 + 2 * level + q]));
      }
    }
  }
  return {error[0] / peak[0], error[1] / peak[1]};
}

TEST(OdeColumnReference, KelvinVoigtLayerAtSecondOrderByEveryMethod) {
  const auto rows = rows_of("column_uniform_kv_ricker.csv");
  if (rows.empty()) {
    GTEST_SKIP() << "no reference data";
  }
  for (const OdeMethod method : methods) {
    const auto coarse = pulse_errors(rows, method, 1.0);
    const auto fine = pulse_errors(rows, method, 0.5);
    std::printf("method %d: v %.2e %.2e, tau %.2e %.2e\n", static_cast<int>(method), coarse[0], fine[0],
                coarse[1], fine[1]);
    for (std::size_t q = 0; q < 2; ++q) {
      EXPECT_GT(std::log2(coarse[q] / fine[q]), 1.8) << static_cast<int>(method);
      EXPECT_LT(fine[q], 2e-3);
    }
  }
}

// The face's velocity has a second derivative that jumps where the ramp begins and where it ends. Both jumps
// travel with the wave, at the speed of unloaded soil and at that of soil as soft as it gets. A scheme of
// second order without dissipation spreads such a jump over a length of h^(2/3) with errors of h^(4/3): order
// 5/3 in the root mean square. Between the two the solution is smooth, and that is what is compared.
constexpr double around_jump = 0.01; ///< s, left out beside a jump
constexpr double end = 0.49;         ///< s; hyperbolic soil at the face is 30 times as soft by then
constexpr double ramp = 0.2;         ///< s

/// Root-mean-square errors of velocity, strain and stress at 5, 10 and 20 m from the driven face.
std::array<double, 3> simple_wave_errors(const Rows& rows, const MasingShear& law, double face, double cell) {
  constexpr double speed = 200.0;
  const Profile profile{.surface_level = 80.0, .layers = {layer_of(80.0, law)}, .half_space = law.elastic};
  auto settings = tight(OdeMethod::explicit_runge_kutta, cell);
  settings.base = BaseKind::rigid;
  OdeColumn column(profile, settings, [face](double t) {
    const double share = t <= 0.0    ? 0.0
                         : t >= ramp ? 1.0
                                     : 0.5 * (1.0 - std::cos(std::numbers::pi * t / ramp));
    return Velocity{face * share, 0.0};
  });
  const auto backbone = law.backbone();
  const double largest_strain = rows.back()[2]; // at the face
  const double slowest = speed * std::sqrt(backbone.tangent(largest_strain) / backbone.shear_modulus);
  constexpr std::array<double, 3> levels = {5.0, 10.0, 20.0};
  std::array<ColumnSample, 3> samples;
  std::array<double, 3> squares{}, peak{};
  int count = 0;
  for (const auto& row : rows) {
    if (row[0] > end) {
      break;
    }
    while (column.time() < row[0] - 1e-4) {
      column.step();
    }
    column.sample(levels, samples);
    for (std::size_t level = 0; level < levels.size(); ++level) {
      if (std::abs(row[0] - levels[level] / speed) < around_jump ||
          row[0] > ramp + levels[level] / slowest - around_jump) {
        continue;
      }
      ++count;
      const std::array<double, 3> computed = {samples[level].vx, -samples[level].gxy, -samples[level].sxy};
      for (std::size_t q = 0; q < 3; ++q) {
        const double expected = row[4 + 3 * level + q];
        squares[q] += std::pow(computed[q] - expected, 2);
        peak[q] = std::max(peak[q], std::abs(expected));
      }
    }
  }
  EXPECT_GT(count, 300);
  for (std::size_t q = 0; q < 3; ++q) {
    squares[q] = std::sqrt(squares[q] / count) / peak[q];
  }
  return squares;
}

void expect_simple_wave(const std::string& file, double exponent, double face) {
  const auto rows = rows_of(file);
  if (rows.empty()) {
    GTEST_SKIP() << "no reference data";
  }
  const MasingShear law{Elasticity::from_wave_speeds(1800.0, 200.0, 300.0), 1e-3, 1.0, exponent};
  const auto coarse = simple_wave_errors(rows, law, face, 0.2);
  const auto fine = simple_wave_errors(rows, law, face, 0.1);
  for (std::size_t q = 0; q < 3; ++q) {
    std::printf("%s %zu: %.2e %.2e order %.2f\n", file.c_str(), q, coarse[q], fine[q],
                std::log2(coarse[q] / fine[q]));
    EXPECT_GT(std::log2(coarse[q] / fine[q]), 1.9);
    EXPECT_LT(fine[q], 2e-4);
  }
}

TEST(OdeColumnReference, SimpleWaveInHyperbolicSoilAtSecondOrder) {
  expect_simple_wave("nonlinear_simple_wave.csv", 1.0, 0.8);
}

TEST(OdeColumnReference, SimpleWaveInMkzSoilAtSecondOrder) {
  expect_simple_wave("nonlinear_simple_wave_mkz.csv", 0.919, 0.5);
}

// u(surface)/u(base) = 1/cos(k* H), k* = w/sqrt(G (1 + i w beta)/rho), both polarisations in quadrature. The
// motion starts gently and has become steady when it is compared.
TEST(OdeColumnReference, RigidBaseTransfersOneOverCosine) {
  constexpr double frequency = 3.0, w = 2.0 * std::numbers::pi * frequency, height = 10.0;
  const auto soil = Elasticity::from_wave_speeds(1800.0, 150.0, 300.0);
  const Profile profile{.layers = {{height, soil, 0.05}}, .half_space = soil};
  auto settings = tight(OdeMethod::bdf, 0.125);
  settings.base = BaseKind::rigid;
  settings.damping = KelvinVoigtDamping{frequency};
  OdeColumn column(profile, settings, [](double t) {
    const double start = t <= 0.0 ? 0.0 : 1.0 - std::exp(-t * t);
    return Velocity{start * std::cos(w * t), start * std::sin(w * t)};
  });
  const auto transfer = [&](double speed) {
    const std::complex<double> k = w / (speed * std::sqrt(std::complex<double>(1.0, 2.0 * 0.05)));
    return 1.0 / std::cos(k * height);
  };
  while (column.time() < 6.0) {
    column.step();
  }
  double error = 0.0;
  while (column.time() < 6.0 + 1.0 / frequency) {
    column.step();
    const double surface = 0.0;
    ColumnSample sample;
    column.sample({&surface, 1}, {&sample, 1});
    const auto wave = std::polar(1.0, w * column.time());
    error = std::max({error, std::abs(sample.vx - (transfer(150.0) * wave).real()),
                      std::abs(sample.vy - (transfer(300.0) * wave).imag())});
  }
  EXPECT_LT(error / std::abs(transfer(150.0)), 1e-3);
}

} // namespace
