#include "materials/hysteretic/backbone/curves.hpp"

#include "materials/hysteretic/backbone/backbone.hpp"
#include "materials/law/parameter_check.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::materials {
namespace {

double interpolated(const std::vector<double>& strain, const std::vector<double>& value, double amplitude) {
  if (!(amplitude > strain.front()))
    return value.front();
  if (amplitude >= strain.back())
    return value.back();
  const auto next = std::upper_bound(strain.begin(), strain.end(), amplitude);
  const auto i = static_cast<std::size_t>(next - strain.begin());
  const double fraction = std::log(amplitude / strain[i - 1]) / std::log(strain[i] / strain[i - 1]);
  return value[i - 1] + fraction * (value[i] - value[i - 1]);
}

constexpr double pascal_per_atm = 101325.0;

// Darendeli (2001), table 9.2; phi[0] is not used.
constexpr double phi[] = {0.0,    0.0352,  0.0010,  0.3246, 0.3483, 0.9190, 0.8005,
                          0.0129, -0.1069, -0.2889, 0.2919, 0.6329, -0.0057};

/// Masing damping of the curve with exponent a from that of the hyperbola, both in per cent.
double masing_percent(double hyperbolic_percent) {
  constexpr double a = phi[5];
  constexpr double c1 = -1.1143 * a * a + 1.8618 * a + 0.2523;
  constexpr double c2 = 0.0805 * a * a - 0.0710 * a - 0.0095;
  constexpr double c3 = -0.0005 * a * a + 0.0002 * a + 0.0003;
  return ((c3 * hyperbolic_percent + c2) * hyperbolic_percent + c1) * hyperbolic_percent;
}

std::vector<double> ten_a_decade() {
  std::vector<double> strains;
  for (int k = -60; k <= -10; ++k)
    strains.push_back(std::pow(10.0, k / 10.0));
  return strains;
}

} // namespace

double SoilCurves::modulus_ratio_at(double amplitude) const {
  return interpolated(strain, modulus_ratio, amplitude);
}

double SoilCurves::damping_ratio_at(double amplitude) const {
  return interpolated(strain, damping_ratio, amplitude);
}

void validate(const SoilCurves& curves) {
  const std::size_t rows = curves.strain.size();
  if (rows < 2 || curves.modulus_ratio.size() != rows || curves.damping_ratio.size() != rows) {
    throw std::invalid_argument(fmt::format(
        "a soil curve has {} strains, {} modulus ratios and {} damping ratios; it must have as many "
        "of each, at least 2",
        rows, curves.modulus_ratio.size(), curves.damping_ratio.size()));
  }
  for (std::size_t i = 0; i < rows; ++i) {
    const auto named = [&](const char* quantity) {
      return fmt::format("row {} of the soil curve: {}", i + 1, quantity);
    };
    check_range(named("strain (a ratio, not per cent)"), curves.strain[i], std::numeric_limits<double>::min(),
                1.0);
    check_range(named("G/Gmax"), curves.modulus_ratio[i], std::numeric_limits<double>::min(),
                i == 0 ? 1.0 : curves.modulus_ratio[i - 1]);
    check_range(named("damping ratio (not per cent)"), curves.damping_ratio[i], 0.0, 1.0);
    if (i > 0 && !(curves.strain[i] > curves.strain[i - 1])) {
      throw std::invalid_argument(fmt::format("{} = {:g} must be above that of the row before, {:g}",
                                              named("strain"), curves.strain[i], curves.strain[i - 1]));
    }
  }
}

double Darendeli::reference_strain() const {
  const double percent = (phi[1] + phi[2] * plasticity_index * std::pow(overconsolidation_ratio, phi[3])) *
                         std::pow(mean_effective_stress / pascal_per_atm, phi[4]);
  return 0.01 * percent;
}

double Darendeli::least_damping() const {
  const double percent = (phi[6] + phi[7] * plasticity_index * std::pow(overconsolidation_ratio, phi[8])) *
                         std::pow(mean_effective_stress / pascal_per_atm, phi[9]) *
                         (1.0 + phi[10] * std::log(frequency));
  return 0.01 * percent;
}

double Darendeli::modulus_ratio_at(double amplitude) const {
  return Backbone{1.0, reference_strain(), 1.0, phi[5]}.secant(amplitude);
}

double Darendeli::damping_ratio_at(double amplitude) const {
  const double hyperbolic = 100.0 * masing_damping({1.0, reference_strain(), 1.0, 1.0}, amplitude);
  const double b = phi[11] + phi[12] * std::log(cycles);
  return least_damping() + 0.01 * b * std::pow(modulus_ratio_at(amplitude), 0.1) * masing_percent(hyperbolic);
}

void validate(const Darendeli& soil) {
  check_range("plasticity_index", soil.plasticity_index, 0.0, 200.0);
  check_range("overconsolidation_ratio", soil.overconsolidation_ratio, 1.0, 50.0);
  check_range("mean_effective_stress", soil.mean_effective_stress, 100.0, 1e8);
  check_range("frequency", soil.frequency, 0.1, 100.0);
  check_range("cycles", soil.cycles, 1.0, 1e4);
}

SoilCurves darendeli_curves(const Darendeli& soil, std::span<const double> strains) {
  validate(soil);
  SoilCurves curves;
  curves.strain = strains.empty() ? ten_a_decade() : std::vector<double>(strains.begin(), strains.end());
  for (const double strain : curves.strain) {
    curves.modulus_ratio.push_back(soil.modulus_ratio_at(strain));
    curves.damping_ratio.push_back(soil.damping_ratio_at(strain));
  }
  validate(curves);
  return curves;
}

} // namespace tremolo::materials
