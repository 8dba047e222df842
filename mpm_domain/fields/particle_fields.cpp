#include "mpm_domain/fields/particle_fields.hpp"

#include <algorithm>
#include <cstdint>

namespace tremolo::mpm_domain {

const std::vector<ParticleFieldDescription>& particle_field_table() {
  using F = ParticleFields;
  using enum FieldTrait;
  using enum OnCut;
  static const std::vector<ParticleFieldDescription> table{
      {"x", "m", "place", always, moved, "", &F::x},
      {"y", "m", "place", always, moved, "", &F::y},
      {"vx", "m/s", "velocity, half a step before place and stress", always, moved, "velocity", &F::vx},
      {"vy", "m/s", "velocity, half a step before place and stress", always, moved, "velocity", &F::vy},
      {"sxx", "Pa", "Cauchy stress, tension positive", always, copied, "stress", &F::sxx},
      {"syy", "Pa", "Cauchy stress, tension positive", always, copied, "stress", &F::syy},
      {"szz", "Pa", "Cauchy stress out of the plane, tension positive", always, copied, "stress", &F::szz},
      {"sxy", "Pa", "Cauchy stress", always, copied, "stress", &F::sxy},
      {"mass", "kg/m", "mass per metre out of the plane", always, shared, "", &F::mass},
      {"volume", "m2", "volume per metre out of the plane", always, shared, "volume", &F::volume},
      {"x_initial", "m", "place at the start", always, moved, "", &F::x_initial},
      {"y_initial", "m", "place at the start", always, moved, "", &F::y_initial},
      {"bxx", "m2/s", "affine momentum over mass, B", affine, moved, "", &F::bxx},
      {"bxy", "m2/s", "affine momentum over mass, B", affine, moved, "", &F::bxy},
      {"byx", "m2/s", "affine momentum over mass, B", affine, moved, "", &F::byx},
      {"byy", "m2/s", "affine momentum over mass, B", affine, moved, "", &F::byy},
      {"cross_x", "m3/s", "bilinear momentum over mass", bilinear, moved, "", &F::cross_x},
      {"cross_y", "m3/s", "bilinear momentum over mass", bilinear, moved, "", &F::cross_y},
      {"box_xx", "m2", "moments M of the box", own_boxes, shared, "", &F::box_xx},
      {"box_xy", "m2", "moments M of the box", own_boxes, shared, "", &F::box_xy},
      {"box_yy", "m2", "moments M of the box", own_boxes, shared, "", &F::box_yy},
      {"viscous_xx", "Pa", "stress of damping, tension positive", damped, copied, "", &F::viscous_xx},
      {"viscous_yy", "Pa", "stress of damping, tension positive", damped, copied, "", &F::viscous_yy},
      {"viscous_xy", "Pa", "stress of damping", damped, copied, "", &F::viscous_xy},
      {"pore_pressure", "Pa", "pore pressure, were there no cavitation", wet, copied, "", &F::pore_pressure},
      {"pressure_at_rest", "Pa", "pore pressure before the shaking", wet, copied, "", &F::pressure_at_rest},
      {"vertical_at_rest", "Pa", "effective syy of the cell before the shaking", wet, copied, "",
       &F::vertical_at_rest},
      {"wx", "m/s", "velocity of the pore water", flowing, moved, "", &F::wx},
      {"wy", "m/s", "velocity of the pore water", flowing, moved, "", &F::wy},
      {"wbxx", "m2/s", "affine momentum over mass of the water", flowing_affine, moved, "", &F::wbxx},
      {"wbxy", "m2/s", "affine momentum over mass of the water", flowing_affine, moved, "", &F::wbxy},
      {"wbyx", "m2/s", "affine momentum over mass of the water", flowing_affine, moved, "", &F::wbyx},
      {"wbyy", "m2/s", "affine momentum over mass of the water", flowing_affine, moved, "", &F::wbyy},
      {"head", "m", "head of the undisturbed water", seeping, copied, "", &F::head},
      {"head_slope_x", "1", "gradient of this head", seeping, copied, "", &F::head_slope_x},
      {"head_slope_y", "1", "gradient of this head", seeping, copied, "", &F::head_slope_y},
  };
  return table;
}

std::vector<ParticleFieldDescription> relaxation_fields(std::size_t mechanisms) {
  std::vector<ParticleFieldDescription> fields;
  for (std::size_t j = 1; j <= mechanisms; ++j)
    for (const char* component : {"xx", "yy", "xy"})
      fields.push_back({.name = "relaxing_" + std::to_string(j) + "_" + component,
                        .unit = "Pa",
                        .meaning = "stress of a relaxation mechanism, tension positive",
                        .trait = FieldTrait::damped,
                        .on_cut = OnCut::copied});
  return fields;
}

std::size_t bytes_per_particle(ParticleTraits traits) {
  const auto fields = std::ranges::count_if(
      particle_field_table(), [&](const ParticleFieldDescription& line) { return traits.have(line.trait); });
  return static_cast<std::size_t>(fields) * sizeof(double) + 2 * sizeof(std::uint32_t); // id and its place
}

} // namespace tremolo::mpm_domain
