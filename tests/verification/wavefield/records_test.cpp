// Motions in time through layers, against stored results: a Kelvin-Voigt column under a Ricker pulse, a real
// record as outcrop motion of three layers, and the surface accelerations and response spectra that DEEPSOIL
// v6.1 gives for its examples 2A and 4 (linear, and equivalent linear with the same damping at all strains).

#include "tests/support/layered_reference.hpp"
#include "tests/support/reference_table.hpp"
#include "wavefield/incident_motion.hpp"
#include "wavefield/layers/equivalent_linear.hpp"
#include "wavefield/layers/layered_field.hpp"
#include "wavefield/layers/transfer.hpp"
#include "wavefield/signal/fourier.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace {

using namespace tremolo::wavefield;

std::filesystem::path reference(const char* folder, const char* name) {
  return tremolo::testing::reference_folder() / folder / name;
}

std::vector<double> column(const std::vector<std::vector<double>>& rows, std::size_t index) {
  std::vector<double> values;
  values.reserve(rows.size());
  for (const auto& row : rows) {
    values.push_back(row[index]);
  }
  return values;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double difference = 0.0;
  double peak = 0.0;
  for (std::size_t i = 0; i < b.size(); ++i) {
    difference = std::max(difference, std::abs(a[i] - b[i]));
    peak = std::max(peak, std::abs(b[i]));
  }
  return difference / peak;
}

/// A motion through a transfer function of horizontal displacement, on a window of `length` samples.
std::vector<double> through(const LayeredHalfSpace& profile, double depth,
                            const std::vector<double>& incident, double dt, std::size_t length) {
  RealFourier fourier(length);
  const auto samples = fourier.samples();
  std::fill(std::copy(incident.begin(), incident.end(), samples.begin()), samples.end(), 0.0);
  fourier.forward();
  std::vector<double> frequencies;
  for (std::size_t k = 1; k < fourier.bins().size(); ++k) {
    frequencies.push_back(static_cast<double>(k) / (static_cast<double>(length) * dt));
  }
  const auto spectra = transfer(profile, WaveType::SV, 0.0, frequencies, std::array{depth});
  fourier.bins()[0] *= 2.0 / static_cast<double>(length);
  for (std::size_t k = 1; k < fourier.bins().size(); ++k) {
    fourier.bins()[k] *= spectra[k - 1].front().ux / static_cast<double>(length);
  }
  fourier.inverse();
  return {samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(incident.size())};
}

TEST(Column, OfOneKelvinVoigtLayerUnderARickerPulse) {
  const auto file = reference("waves", "column_uniform_kv_ricker.csv");
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << "no reference data at " << file;
  }
  const auto rows = tremolo::testing::read_table(file);
  const LayeredHalfSpace profile{
      .layers = {{.thickness = 30.0, .density = 1800.0, .vs = 200.0, .vp = 400.0, .damping = 0.02}},
      .half_space = {2200.0, 800.0, 1600.0},
      .damping = {DampingModel::kelvin_voigt, 200.0 / 120.0}};
  const LayeredField field(profile, {WaveType::SV, 0.0, 0.0, -30.0}, 0.0, ricker(3.0, 0.5, 1.0));
  const std::array<Point, 4> points{{{0.0, 0.0}, {0.0, -7.5}, {0.0, -15.0}, {0.0, -30.0}}};
  const TimeGrid grid{0.0, rows[1][0] - rows[0][0], rows.size()};
  const auto histories = field.sample(points, grid);
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_LT(largest_difference(histories[i].vx, column(rows, 1 + 2 * i)), 1e-9) << points[i].y;
    if (i > 0) {
      EXPECT_LT(largest_difference(histories[i].sxy, column(rows, 2 + 2 * i)), 1e-9) << points[i].y;
    }
  }
}

TEST(Record, AsOutcropMotionOfThreeLayers) {
  const auto file = reference("waves", "record_BLD090_layered3_ts.csv");
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << "no reference data at " << file;
  }
  const auto rows = tremolo::testing::read_table(file);
  const auto profile = tremolo::testing::layered3({DampingModel::hysteretic});
  const double dt = 0.02;
  const auto incident = incident_from_outcrop(profile, WaveType::SV, 0.0, column(rows, 1));
  const double surface = largest_difference(through(profile, 0.0, incident, dt, 16384), column(rows, 3));
  const double within = largest_difference(through(profile, 20.0, incident, dt, 16384), column(rows, 2));
  EXPECT_LT(surface, 1e-8);
  EXPECT_LT(within, 1e-8);
  std::printf("record through three layers: surface %.1e, within %.1e of the peak\n", surface, within);

  // And back: from the within motion to the incident one.
  const auto back =
      incident_from_within(profile, WaveType::SV, 0.0, through(profile, 20.0, incident, dt, 16384), dt);
  const std::vector<double> while_recorded(back.incident.begin() + static_cast<std::ptrdiff_t>(back.lead),
                                           back.incident.end());
  std::printf("from within: %.1e of the peak, noise amplified %.1f times at %.2f Hz\n",
              largest_difference(while_recorded, incident), back.largest_amplification, back.at_hz);
  EXPECT_LT(largest_difference(while_recorded, incident), 1e-4);
}

// DEEPSOIL's soil: 20 m, 20 kN/m3, Vs 500 m/s; rock 25 kN/m3, Vs 760 m/s, 2 %.
LayeredHalfSpace deepsoil(double damping) {
  constexpr double g = 9.80665;
  return {.layers = {{.thickness = 20.0, .density = 20e3 / g, .vs = 500.0, .vp = 1000.0, .damping = damping}},
          .half_space = {25e3 / g, 760.0, 1520.0},
          .half_space_damping = 0.02,
          .damping = {DampingModel::hysteretic}};
}

/// Pseudo-acceleration of a 5 % oscillator for piecewise linear input (Nigam and Jennings 1969).
double pseudo_acceleration(const std::vector<double>& acceleration, double dt, double period) {
  const double damping = 0.05;
  const double w = 2.0 * std::numbers::pi / period;
  const double wd = w * std::sqrt(1.0 - damping * damping);
  const double decay = std::exp(-damping * w * dt);
  const double s = std::sin(wd * dt);
  const double c = std::cos(wd * dt);
  double u = 0.0;
  double v = 0.0;
  double peak = 0.0;
  for (std::size_t i = 1; i < acceleration.size(); ++i) {
    // u'' + 2 xi w u' + w^2 u = -a0 - slope t; the particular solution is linear in t.
    const double slope = (acceleration[i] - acceleration[i - 1]) / dt;
    const double b = -slope / (w * w);
    const double a = -(acceleration[i - 1]) / (w * w) - 2.0 * damping * b / w;
    const double c1 = u - a;
    const double c2 = (v - b + damping * w * c1) / wd;
    u = decay * (c1 * c + c2 * s) + a + b * dt;
    v = decay * ((c2 * wd - damping * w * c1) * c - (c1 * wd + damping * w * c2) * s) + b;
    peak = std::max(peak, std::abs(u));
  }
  return w * w * peak;
}

struct DeepsoilErrors {
  double acceleration, spectrum;
};

DeepsoilErrors compare_with_deepsoil(const LayeredHalfSpace& profile, const char* surface,
                                     const char* spectrum) {
  const auto input = tremolo::testing::read_table(
      reference("records/deepsoil_v61_from_pystrata", "ChiChi_input_outcrop.csv"));
  const auto expected =
      tremolo::testing::read_table(reference("records/deepsoil_v61_from_pystrata", surface));
  const auto psa = tremolo::testing::read_table(reference("records/deepsoil_v61_from_pystrata", spectrum));
  const double dt = 0.005;
  const auto incident = incident_from_outcrop(profile, WaveType::SV, 0.0, column(input, 1));
  const auto computed = through(profile, 0.0, incident, dt, 16384);
  double spectral = 0.0;
  for (const auto& row : psa) {
    spectral = std::max(spectral, std::abs(pseudo_acceleration(computed, dt, row[0]) / row[1] - 1.0));
  }
  return {largest_difference(computed, column(expected, 1)), spectral};
}

TEST(Deepsoil, Example2ALinear) {
  if (!std::filesystem::exists(reference("records/deepsoil_v61_from_pystrata", "ds-example-2a-le_psa.csv"))) {
    GTEST_SKIP() << "no reference data";
  }
  const auto error =
      compare_with_deepsoil(deepsoil(0.0), "ds-example-2a-le_surface_acc.csv", "ds-example-2a-le_psa.csv");
  std::printf("DEEPSOIL 2A: acceleration %.1e of the peak, spectrum %.1e\n", error.acceleration,
              error.spectrum);
  EXPECT_LT(error.acceleration, 2e-5);
  EXPECT_LT(error.spectrum, 0.01);
}

TEST(Deepsoil, Example4EquivalentLinear) {
  if (!std::filesystem::exists(reference("records/deepsoil_v61_from_pystrata", "ds-example-4-eql_psa.csv"))) {
    GTEST_SKIP() << "no reference data";
  }
  auto input = tremolo::testing::read_table(
      reference("records/deepsoil_v61_from_pystrata", "ChiChi_input_outcrop.csv"));
  const LayeredHalfSpace first_guess = deepsoil(0.02);
  auto incident = incident_from_outcrop(first_guess, WaveType::SV, 0.0, column(input, 1));
  for (double& value : incident) {
    value *= 9.80665;
  }
  const StrainCurves same_at_all_strains{[](double) { return 1.0; }, [](double) { return 0.05; }};
  const auto result =
      equivalent_linear(first_guess, std::vector{same_at_all_strains}, WaveType::SV, 0.0, {incident, 0.005});
  EXPECT_EQ(result.iterations.size(), 2U);
  const auto error =
      compare_with_deepsoil(result.profile, "ds-example-4-eql_surface_acc.csv", "ds-example-4-eql_psa.csv");
  std::printf("DEEPSOIL 4: acceleration %.1e of the peak, spectrum %.1e\n", error.acceleration,
              error.spectrum);
  EXPECT_LT(error.acceleration, 0.01);
  EXPECT_LT(error.spectrum, 0.01);
}

} // namespace
