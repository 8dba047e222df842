// Motions recorded in the ground taken down to the half-space: a damped layer in closed form, and back from
// what the layers themselves make of an incident motion.

#include "tests/support/layered_reference.hpp"
#include "wavefield/incident_motion.hpp"
#include "wavefield/layers/equivalent_linear.hpp"
#include "wavefield/layers/layered_field.hpp"
#include "wavefield/layers/transfer.hpp"
#include "wavefield/signal/fourier.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <vector>

namespace {

using namespace tremolo::wavefield;
using tremolo::testing::layered3;
using tremolo::testing::radians;
using Complex = std::complex<double>;

constexpr double pi = std::numbers::pi;
constexpr double dt = 0.01;

double peak(const std::vector<double>& motion) {
  double largest = 0.0;
  for (const double value : motion)
    largest = std::max(largest, std::abs(value));
  return largest;
}

double energy(const std::vector<double>& motion) {
  double sum = 0.0;
  for (const double value : motion)
    sum += value * value;
  return sum;
}

/// Largest difference to a motion that begins with the record and is zero outside of its samples, over the
/// peak of that.
double error(const Deconvolution& found, const std::vector<double>& expected) {
  double difference = 0.0;
  for (std::size_t i = 0; i < std::max(found.incident.size(), found.lead + expected.size()); ++i) {
    const double ours = i < found.incident.size() ? found.incident[i] : 0.0;
    const bool within = i >= found.lead && i - found.lead < expected.size();
    difference = std::max(difference, std::abs(ours - (within ? expected[i - found.lead] : 0.0)));
  }
  return difference / peak(expected);
}

// One damped layer on a half-space, time kernel exp(i w t), z down from the surface:
//
//     u(z) = cos(k z) per unit surface motion,   k^2 = rho w^2 / G*,   G* = G (1 + 2 i xi),
//     outcrop / surface = cos(k H) + i a sin(k H),   a = rho c* / (rho_r c_r*).
struct OneLayer {
  double thickness = 20.0;
  double density = 1800.0;
  double vs = 180.0;
  double damping = 0.05;
  double rock_density = 2200.0;
  double rock_vs = 760.0;
  double rock_damping = 0.01;

  LayeredHalfSpace profile() const {
    return {
        .layers = {{.thickness = thickness, .density = density, .vs = vs, .vp = 400.0, .damping = damping}},
        .half_space = {rock_density, rock_vs, 1500.0},
        .half_space_damping = rock_damping,
        .damping = {DampingModel::hysteretic}};
  }

  Complex outcrop_over_recorded(double frequency, double depth) const {
    const Complex c = vs * std::sqrt(Complex(1.0, 2.0 * damping));
    const Complex impedances =
        density * c / (rock_density * rock_vs * std::sqrt(Complex(1.0, 2.0 * rock_damping)));
    const Complex k = 2.0 * pi * frequency / c;
    return (std::cos(k * thickness) + Complex(0.0, 1.0) * impedances * std::sin(k * thickness)) /
           std::cos(k * depth);
  }
};

/// A Ricker pulse of 3 Hz at 2 s, of which nothing lies above the cutoff, and its spectrum, a series of
/// frequencies 1/80 Hz apart.
double pulse(double t) {
  const double a = std::pow(pi * 3.0 * (t - 2.0), 2);
  return (1.0 - 2.0 * a) * std::exp(-a);
}

double outcrop_in_closed_form(const OneLayer& layer, double depth, double t) {
  constexpr double step = 1.0 / 80.0;
  double sum = 0.0;
  for (double f = step; f < 21.0; f += step) {
    const double amplitude = 2.0 * f * f / (std::sqrt(pi) * 27.0) * std::exp(-std::pow(f / 3.0, 2));
    sum += 2.0 * step * amplitude *
           (layer.outcrop_over_recorded(f, depth) * std::polar(1.0, 2.0 * pi * f * (t - 2.0))).real();
  }
  return sum;
}

TEST(Deconvolution, OfOneDampedLayerIsTheClosedForm) {
  const OneLayer layer;
  std::vector<double> record(400);
  for (std::size_t i = 0; i < record.size(); ++i)
    record[i] = pulse(static_cast<double>(i) * dt);
  for (const double depth : {0.0, 6.0}) {
    const auto found = incident_from_record(layer.profile(), WaveType::SV, 0.0,
                                            {.samples = record, .dt = dt, .depth = depth, .cutoff = 20.0});
    double difference = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < found.incident.size(); ++i) {
      const double t = (static_cast<double>(i) - static_cast<double>(found.lead)) * dt;
      const double expected = outcrop_in_closed_form(layer, depth, t);
      difference = std::max(difference, std::abs(2.0 * found.incident[i] - expected));
      largest = std::max(largest, std::abs(expected));
    }
    EXPECT_LT(difference, 1e-9 * largest) << depth;
    std::printf("one layer, %g m: %.1e of the peak\n", depth, difference / largest);
    // The largest amplification is that of the closed form at the frequency that is named.
    const double weight = band_weight(found.at_hz, 20.0);
    EXPECT_NEAR(2.0 * found.largest_amplification,
                weight * std::abs(layer.outcrop_over_recorded(found.at_hz, depth)), 1e-9);
  }
}

/// The motion at a depth (m) of layered3 under a Ricker velocity pulse that is incident 20 m down.
std::vector<double> recorded(const LayeredHalfSpace& profile, WaveType wave, double degrees, double depth,
                             std::size_t count) {
  const LayeredField field(profile, {wave, radians(degrees), 0.0, -20.0}, 0.0, ricker(3.0, 2.0, 0.1));
  const Point point{0.0, -depth, Side::above};
  const History h = field.sample({&point, 1}, {0.0, dt, count})[0];
  return wave == WaveType::SV ? h.vx : h.vy;
}

TEST(Deconvolution, IsTheWayBackFromSurfaceAndSensor) {
  std::vector<double> incident(400);
  for (std::size_t i = 0; i < incident.size(); ++i)
    incident[i] = ricker(3.0, 2.0, 0.1).velocity(static_cast<double>(i) * dt);
  double worst = 0.0;
  for (const auto& damping : {Damping{DampingModel::hysteretic}, Damping{DampingModel::kelvin_voigt, 3.0}})
    for (const auto& [wave, degrees] :
         {std::pair(WaveType::SV, 0.0), std::pair(WaveType::SV, 20.0), std::pair(WaveType::P, 0.0)})
      for (const double depth : {0.0, 4.0}) {
        const LayeredHalfSpace profile = layered3(damping);
        const auto record = recorded(profile, wave, degrees, depth, 2000);
        const auto found = incident_from_record(
            profile, wave, radians(degrees), {.samples = record, .dt = dt, .depth = depth, .cutoff = 14.0});
        const double off = error(found, incident);
        EXPECT_LT(off, 1e-6) << depth << " m, " << degrees << " degrees";
        worst = std::max(worst, off);
      }
  std::printf("back from surface and sensor: %.1e of the peak\n", worst);
}

TEST(Deconvolution, OfElasticLayersNeedsNoDampingAtTheSurface) {
  const LayeredHalfSpace profile = layered3({});
  const auto record = recorded(profile, WaveType::SV, 0.0, 0.0, 3000);
  std::vector<double> incident(400);
  for (std::size_t i = 0; i < incident.size(); ++i)
    incident[i] = ricker(3.0, 2.0, 0.1).velocity(static_cast<double>(i) * dt);
  const auto found =
      incident_from_record(profile, WaveType::SV, 0.0, {.samples = record, .dt = dt, .cutoff = 20.0});
  EXPECT_LT(error(found, incident), 1e-6);
}

/// White noise of 10 s at full strength from the first sample to the last.
std::vector<double> noise() {
  std::mt19937 random(7);
  std::vector<double> samples(1000);
  for (double& value : samples)
    value = static_cast<double>(random()) / 2147483648.0 - 1.0;
  return samples;
}

/// An incident motion through a transfer function, on a window four times as long.
std::vector<double> through(const LayeredHalfSpace& profile, const std::vector<double>& incident) {
  RealFourier fourier(fast_length(4 * incident.size()));
  const auto samples = fourier.samples();
  std::fill(std::copy(incident.begin(), incident.end(), samples.begin()), samples.end(), 0.0);
  fourier.forward();
  const auto bins = fourier.bins();
  const double length = static_cast<double>(samples.size());
  std::vector<double> frequencies;
  for (std::size_t k = 1; k < bins.size(); ++k)
    frequencies.push_back(static_cast<double>(k) / (length * dt));
  const auto transfers = transfer(profile, WaveType::SV, 0.0, frequencies, std::array{0.0});
  bins[0] *= 2.0 / length;
  for (std::size_t k = 1; k < bins.size(); ++k)
    bins[k] *= transfers[k - 1].front().ux / length;
  fourier.inverse();
  return {samples.begin(), samples.end()};
}

TEST(Deconvolution, GivesTheRecordBelowTheCutoffAndStillnessBeforeAndAfter) {
  const LayeredHalfSpace profile = layered3({DampingModel::hysteretic});
  const auto record = noise();
  const RecordedMotion given{.samples = record, .dt = dt, .cutoff = 15.0};
  const auto found = incident_from_record(profile, WaveType::SV, 0.0, given);
  const auto surface = through(profile, found.incident);
  const auto expected = band_limited(given);
  double difference = 0.0;
  double outside = 0.0;
  const std::size_t filter = 300; // its answer has died out
  for (std::size_t i = 0; i < surface.size(); ++i) {
    const bool within = i >= found.lead && i - found.lead < expected.size();
    if (within)
      difference = std::max(difference, std::abs(surface[i] - expected[i - found.lead]));
    else if (i + filter < found.lead || i > found.lead + expected.size() + filter)
      outside = std::max(outside, std::abs(surface[i]));
  }
  EXPECT_LT(difference, 1e-5 * peak(expected));
  EXPECT_LT(outside, 1e-5 * peak(expected));
  EXPECT_GT(found.lead, 10U); // the wave needs 0.11 s from the top of the half-space to the surface
  // White noise goes up to 50 Hz, the record to 16.9 Hz in the middle of the roll-off.
  EXPECT_NEAR(energy(expected) / energy(record), 16.875 / 50.0, 0.05);
  std::printf("noise: %.1e within, %.1e outside\n", difference / peak(expected), outside / peak(expected));
}

TEST(Deconvolution, TakesNothingAboveTheCutoff) {
  EXPECT_EQ(band_weight(15.0, 15.0), 1.0);
  EXPECT_NEAR(band_weight(15.001, 15.0), 1.0, 1e-8);
  EXPECT_NEAR(band_weight(1.125 * 15.0, 15.0), 0.5, 1e-12);
  EXPECT_NEAR(band_weight(1.2499 * 15.0, 15.0), 0.0, 1e-8);
  EXPECT_EQ(band_weight(1.25 * 15.0, 15.0), 0.0);
  const LayeredHalfSpace profile = layered3({DampingModel::hysteretic});
  auto record = recorded(profile, WaveType::SV, 0.0, 0.0, 2000);
  const auto clean = incident_from_record(profile, WaveType::SV, 0.0, {record, dt, 0.0, 12.0});
  for (std::size_t i = 0; i < record.size(); ++i) {
    const double t = static_cast<double>(i) * dt;
    record[i] += 0.05 * std::exp(-std::pow((t - 5.0) / 0.5, 2)) * std::sin(2.0 * pi * 25.0 * t);
  }
  const auto found = incident_from_record(profile, WaveType::SV, 0.0, {record, dt, 0.0, 12.0});
  const std::vector<double> expected(clean.incident.begin() + static_cast<std::ptrdiff_t>(clean.lead),
                                     clean.incident.end());
  EXPECT_LT(error({found.incident, found.lead, 0.0, 0.0}, expected), 1e-5);
}

LayeredHalfSpace soft_ground() {
  return {.layers = {{.thickness = 4.0, .density = 1700.0, .vs = 120.0, .vp = 300.0, .damping = 0.02},
                     {.thickness = 6.0, .density = 1800.0, .vs = 180.0, .vp = 450.0, .damping = 0.02},
                     {.thickness = 10.0, .density = 1900.0, .vs = 260.0, .vp = 600.0, .damping = 0.02}},
          .half_space = {2100.0, 700.0, 1400.0},
          .half_space_damping = 0.01,
          .damping = {DampingModel::hysteretic}};
}

StrainCurves hyperbolic(double reference_strain) {
  return {[=](double strain) { return 1.0 / (1.0 + strain / reference_strain); },
          [=](double strain) {
            return 0.015 + 0.18 * (strain / reference_strain) / (1.0 + strain / reference_strain);
          }};
}

/// m/s2, of which nothing lies above 15 Hz.
std::vector<double> shaking() {
  std::vector<double> acceleration(1500);
  for (std::size_t i = 0; i < acceleration.size(); ++i) {
    const double t = static_cast<double>(i) * dt - 5.0;
    acceleration[i] = std::exp(-std::pow(t / 1.2, 2)) *
                      (std::sin(9.0 * t) + 0.7 * std::sin(23.0 * t + 1.0) + 0.3 * std::sin(51.0 * t));
  }
  return acceleration;
}

TEST(Deconvolution, FindsTheModuliOfTheEquivalentLinearWayUp) {
  const std::vector<StrainCurves> curves{hyperbolic(8e-4), hyperbolic(1.1e-3), hyperbolic(1.5e-3)};
  const auto incident = shaking();
  for (const double tolerance : {1e-3, 1e-8}) {
    const EquivalentLinearOptions options{.tolerance = tolerance, .max_iterations = 200};
    const auto up = equivalent_linear(soft_ground(), curves, WaveType::SV, 0.0,
                                      IncidentAcceleration{incident, dt}, options);
    auto surface = through(up.profile, incident);
    surface.resize(3000);
    const RecordedMotion record{.samples = surface, .dt = dt, .cutoff = 15.0};
    const auto down =
        equivalent_linear_under_record(soft_ground(), curves, WaveType::SV, 0.0, record, options);
    ASSERT_TRUE(up.converged && down.converged);
    double modulus = 0.0;
    for (std::size_t j = 0; j < curves.size(); ++j) {
      modulus =
          std::max(modulus, std::abs(std::pow(down.profile.layers[j].vs / up.profile.layers[j].vs, 2) - 1));
      EXPECT_NEAR(down.profile.layers[j].damping, up.profile.layers[j].damping,
                  10.0 * tolerance * up.profile.layers[j].damping);
      EXPECT_LT(up.profile.layers[j].vs, 0.95 * soft_ground().layers[j].vs); // it did soften
    }
    const auto found = incident_from_record(down.profile, WaveType::SV, 0.0, record);
    const double off = error(found, incident);
    EXPECT_LT(modulus, 10.0 * tolerance);
    EXPECT_LT(off, std::max(10.0 * tolerance, 1e-6));
    const auto strains = largest_strains(down.profile, WaveType::SV, 0.0, record);
    for (std::size_t j = 0; j < strains.size(); ++j)
      EXPECT_NEAR(strains[j], down.iterations.back().largest_strain[j], 10.0 * tolerance * strains[j]);
    std::printf("tolerance %.0e: moduli %.1e, motion %.1e, %zu passes up, %zu down\n", tolerance, modulus,
                off, up.iterations.size(), down.iterations.size());
  }
}

TEST(Deconvolution, RunsAwayWhereNoMotionFromBelowGivesTheRecord) {
  const std::vector<StrainCurves> curves{hyperbolic(8e-4), hyperbolic(1.1e-3), hyperbolic(1.5e-3)};
  auto record = shaking();
  for (double& value : record)
    value *= 40.0;
  EXPECT_THAT(
      [&] {
        equivalent_linear_under_record(soft_ground(), curves, WaveType::SV, 0.0,
                                       {.samples = record, .dt = dt, .cutoff = 15.0},
                                       {.max_iterations = 200, .allow_non_convergence = true});
      },
      ::testing::ThrowsMessage<std::runtime_error>(
          ::testing::AllOf(::testing::HasSubstr("the equivalent linear analysis runs away: the soil from "),
                           ::testing::HasSubstr("a lower cutoff asks for less"))));
}

} // namespace
