#include "materials/sand/pdmy03/pdmy03_surfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::materials {
namespace {

/// A point of the backbone at the reference pressure.
struct BackbonePoint {
  double strain = 0.0;
  double stress = 0.0; ///< Pa
};

double residual_pressure(const Pdmy03& law, double failure_ratio) {
  return std::max(2.0 * law.zero_pressure_strength / failure_ratio, 1e-4 * law.atmospheric_pressure);
}

/// Moduli of surfaces 0 (the elastic core) to N, the last one perfectly plastic.
void set_moduli(Pdmy03& law, std::span<const BackbonePoint> points) {
  const double elastic = 2.0 * law.elastic.shear_modulus();
  law.tangent_modulus[0] = elastic;
  for (std::size_t i = 1; i < law.surfaces; ++i) {
    const double tangent =
        2.0 * (points[i].stress - points[i - 1].stress) / (points[i].strain - points[i - 1].strain);
    law.tangent_modulus[i] = tangent;
    law.plastic_modulus[i] = elastic * tangent / (elastic - tangent);
  }
}

void check_curve(std::span<const ModulusReduction> curve) {
  constexpr std::size_t fewest = 3;
  if (curve.size() < fewest || curve.size() > most_pdmy03_surfaces) {
    throw std::invalid_argument(fmt::format("modulus_reduction has {} points; it needs {} to {}",
                                            curve.size(), fewest, most_pdmy03_surfaces));
  }
  ModulusReduction last = {0.0, 1.0};
  double slope = 1.0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const auto [strain, ratio] = curve[i];
    const bool ordered = strain > last.shear_strain && strain < 1.0 && ratio > 0.0 && ratio < 1.0;
    const double next =
        (ratio * strain - last.modulus_ratio * last.shear_strain) / (strain - last.shear_strain);
    if (!ordered || !(next > 0.0) || !(next <= slope)) {
      throw std::invalid_argument(
          fmt::format("modulus_reduction, point {}: shear strain {:g} with G/Gmax {:g}; strains must grow "
                      "below 1, ratios lie "
                      "between 0 and 1, and the stress gamma G/Gmax must grow ever more slowly",
                      i + 1, strain, ratio));
    }
    last = curve[i];
    slope = next;
  }
}

} // namespace

double cone_ratio(Pdmy03Cone cone, double friction) {
  const double sine = std::sin(friction);
  switch (cone) {
  case Pdmy03Cone::triaxial_extension:
    return 6.0 * sine / (3.0 + sine);
  case Pdmy03Cone::plane_strain:
    return std::sqrt(3.0) * sine;
  case Pdmy03Cone::triaxial_compression:
    break;
  }
  return 6.0 * sine / (3.0 - sine);
}

double cone_friction(Pdmy03Cone cone, double ratio) {
  double sine = 3.0 * ratio / (6.0 + ratio);
  if (cone == Pdmy03Cone::triaxial_extension)
    sine = 3.0 * ratio / (6.0 - ratio);
  else if (cone == Pdmy03Cone::plane_strain)
    sine = ratio / std::sqrt(3.0);
  if (!(sine > 0.0 && sine < 1.0)) {
    throw std::invalid_argument(fmt::format(
        "modulus_reduction ends at a strength of q/p' = {:g}, which no friction angle has", ratio));
  }
  return std::asin(sine);
}

void build_surfaces(Pdmy03& law, std::size_t count) {
  const double failure = cone_ratio(law.cone, law.friction);
  law.surfaces = count;
  law.residual_pressure = residual_pressure(law, failure);
  law.transformation_ratio = cone_ratio(law.cone, law.phase_transformation);
  const double height = law.reference_pressure + law.residual_pressure;
  const double strength = std::sqrt(2.0) * height * failure / 3.0;
  const double shear = law.elastic.shear_modulus();
  const double elastic_strength = shear * law.peak_shear_strain;
  if (!(elastic_strength > strength)) {
    throw std::invalid_argument(fmt::format("peak_shear_strain = {:g}: even elastically this strain does not "
                                            "reach the strength of {:g} Pa; it must "
                                            "be above {:g}",
                                            law.peak_shear_strain, strength, strength / shear));
  }
  const double reference_strain = law.peak_shear_strain * strength / (elastic_strength - strength);
  std::array<BackbonePoint, most_pdmy03_surfaces> points{};
  for (std::size_t i = 1; i <= count; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(count);
    const double stress = part * strength;
    law.ratio[i] = part * failure;
    points[i - 1] = {stress * reference_strain / (shear * reference_strain - stress), stress};
  }
  set_moduli(law, std::span(points).first(count));
}

void build_surfaces(Pdmy03& law, std::span<const ModulusReduction> curve) {
  check_curve(curve);
  const double shear = law.elastic.shear_modulus();
  const auto stress = [&](const ModulusReduction& point) {
    return shear * point.modulus_ratio * point.shear_strain;
  };
  // M_f H_r = sqrt 3 tau_N with H_r = p_r + 2 S0/M_f
  const double failure =
      (std::sqrt(3.0) * stress(curve.back()) - 2.0 * law.zero_pressure_strength) / law.reference_pressure;
  law.friction = cone_friction(law.cone, failure);
  law.surfaces = curve.size();
  law.residual_pressure = residual_pressure(law, failure);
  law.transformation_ratio = cone_ratio(law.cone, law.phase_transformation);
  const double height = law.reference_pressure + law.residual_pressure;
  std::array<BackbonePoint, most_pdmy03_surfaces> points{};
  for (std::size_t i = 1; i <= curve.size(); ++i) {
    points[i - 1] = {curve[i - 1].shear_strain, stress(curve[i - 1])};
    law.ratio[i] = std::sqrt(3.0) * points[i - 1].stress / height;
  }
  set_moduli(law, std::span(points).first(curve.size()));
}

} // namespace tremolo::materials
