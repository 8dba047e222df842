#pragma once

// A saturated elastic column of the domain on its base, periodic, under a layer of dry soil whose weight is
// the load. The layer is as stiff as the column and thin; it is drained, since it is dry.

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/step/stepper.hpp"

#include <algorithm>
#include <memory>

namespace tremolo::test_support {

struct SaturatedColumn {
  double height = 1.0; ///< of the saturated soil, m
  double cell = 0.05;  ///< m
  double p_modulus = 1e7;
  double poisson = 0.0;
  double load = 1e4; ///< q, weight of the dry layer, Pa; no layer if 0
  materials::PoreSpace pores{.porosity = 0.4, .grain_density = 2650.0, .permeability = 1e-3};
  materials::PoreFluid fluid{};
  mpm_domain::Scheme scheme{};
  int cells_wide = 1;

  materials::Elasticity skeleton() const {
    const double young = p_modulus * (1.0 + poisson) * (1.0 - 2.0 * poisson) / (1.0 - poisson);
    return {materials::saturated_density(pores, fluid), young, poisson};
  }

  mpm_domain::Spec spec() const {
    constexpr double gravity = 9.81;
    mpm_domain::Spec spec;
    const double width = cell * cells_wide;
    const double layer = load > 0.0 ? 2.0 * cell : 0.0;
    spec.box = {0.0, -height, width, layer};
    spec.cell_size = cell;
    spec.gravity = gravity;
    spec.sides = mpm_domain::Sides::periodic;
    spec.scheme = scheme;
    spec.water = {0.0, fluid};
    mpm_domain::Soil soil{.name = "saturated", .law = materials::LinearElastic{skeleton()}};
    soil.pores = pores;
    spec.soils.push_back(soil);
    spec.regions = {{0, {{0.0, -height}, {width, -height}, {width, 0.0}, {0.0, 0.0}}}};
    if (load > 0.0) {
      materials::Elasticity dry = skeleton();
      dry.density = load / (gravity * layer);
      spec.soils.push_back({.name = "load", .law = materials::LinearElastic{dry}});
      spec.regions.push_back({1, {{0.0, 0.0}, {width, 0.0}, {width, layer}, {0.0, layer}}});
    }
    return spec;
  }

  /// At rest under gravity and load.
  std::unique_ptr<mpm_domain::Domain> at_rest() const {
    auto domain = std::make_unique<mpm_domain::Domain>(spec());
    mpm_domain::replace_constraints(*domain,
                                    mpm_domain::relax_under_gravity(*domain, {}, [](long, double) {}));
    return domain;
  }
};

/// Nothing moves beyond the faces.
inline mpm_domain::FreeFieldSource at_rest_source() {
  return [](long, double, std::span<const Vector>, std::span<eq6::FreeField> field) {
    std::ranges::fill(field, eq6::FreeField{});
  };
}

/// Gives the pore water an excess pressure (Pa) and takes it off the effective stress: total stress stays.
template <typename Excess>
void load_water(mpm_domain::Domain& domain, const Excess& excess) {
  for (mpm_domain::Particles& set : domain.sets)
    if (set.traits.wet)
      for (std::size_t k = 0; k < set.size(); ++k) {
        const double p = excess(set.y[k]);
        set.pore_pressure[k] += p;
        set.sxx[k] += p;
        set.syy[k] += p;
        set.szz[k] += p;
      }
}

} // namespace tremolo::test_support
