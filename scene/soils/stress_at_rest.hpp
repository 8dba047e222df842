#pragma once

// The fraction of its strength that a soil mobilises under its own weight. At rest the ground has sigma_v
// and, in both horizontal directions, K0 sigma_v, that is in the invariants of the law's failure line q_f(p)
//
//     q = |1 - K0| sigma_v,      p = (1 + 2 K0)/3 sigma_v, or (1 + K0)/2 sigma_v of laws in the plane,
//
// and of Rankine's friction sin(phi_m) = |1 - K0|/(1 + K0). The law's active and passive limits are the K0 at
// which q = q_f.

#include "materials/law/law.hpp"
#include "scene/soils/ground_column.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tremolo::scene {

/// The K0 between which the strength of a law is enough under a vertical effective stress (Pa): active and
/// passive limit, the latter infinite where no K0 is too large. Nothing for laws without a failure line,
/// which carry any load.
struct RestLimits {
  double active = 0.0;
  double passive = 0.0;
};
std::optional<RestLimits> rest_limits(const materials::Law& law, double vertical_stress);

/// phi_m, degrees.
double mobilised_angle_deg(double k0);

/// The point at which a soil mobilises most of its strength at rest: the lower end of a piece of ground.
struct RestingSoil {
  std::size_t soil = 0;
  double y = 0.0;               ///< m
  double vertical_stress = 0.0; ///< effective, Pa
  double mobilised = 0.0;       ///< q/q_f
  bool is_given = false;        ///< K0 is the soil's rest_coefficient, not poisson/(1 - poisson)

  bool is_beyond() const { return mobilised > 1.0 + 1e-6; }
};

/// The worst place of each soil that has a failure line, one a name, over some columns.
/// @param above_bottom  height above the lower end of a piece at which it is evaluated, m
std::vector<RestingSoil> resting_soils(const Case& scene, const std::vector<GroundColumn>& columns,
                                       double above_bottom = 0.0);

/// Columns of the domain: at both sides and through the middle of each region.
std::vector<GroundColumn> columns_of_domain(const Case& scene);

/// The layers of the free fields, of those alone that a model computes if one is named.
std::vector<GroundColumn> free_fields_at_rest(const Case& scene,
                                              std::optional<SourceModel> model = std::nullopt);

/// The columns of the domain and of the free fields.
std::vector<GroundColumn> columns_at_rest(const Case& scene);

/// Path of the key that gives K0, or else of the soil.
std::string rest_path(const Case& scene, const RestingSoil& resting);

/// "K0 = 9.9 asks for 1.3 times the strength of soil 's' at y = -10 m, under 81 kPa of vertical effective
/// stress, and mobilises 54 degrees; it holds K0 of 0.29 to 3.6".
std::string text(const Case& scene, const RestingSoil& resting);

/// A hint, beginning with "; ", at a strength that is probably in another unit; empty if there is none.
std::string strength_doubt(const Case& scene, const RestingSoil& resting);

} // namespace tremolo::scene
