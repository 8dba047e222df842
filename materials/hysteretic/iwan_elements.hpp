#pragma once

// Elastoplastic von Mises bodies in parallel, each on its share of the deviatoric strain (Iwan 1967, J. Appl.
// Mech. 34, 612-617; Prevost 1977),
//
//     sigma = sigma_m I + sum_i s_i + ...,    s_i = 2 G_i dev(eps - eps_p,i),    sqrt(s_i : s_i / 2) <=
//     tau_i.
//
// In the space of total stress these are nested von Mises surfaces with kinematic hardening: the surface at
// which body i yields moves with the stresses of the bodies that have yielded before. Each s_i is rotated
// with the material (objective_rate.hpp), then the elastic trial s_i + 2 G_i d_dev is scaled back to its
// radius: exact for each body, whatever the step.
//
// With less damping in loops (loop_reduction.hpp) the deviatoric stress sum_i s_i becomes
//
//     F sum_i s_i + (1 - F) 2 G_m e,    gamma_m = largest sqrt(2 e : e) so far,
//
// e the deviatoric strain since the elements were unloaded, turned with the material: in simple shear the
// curves of Phillips & Hashash (2009).

#include "materials/elastic/elasticity.hpp"
#include "materials/hysteretic/backbone/loop_reduction.hpp"
#include "materials/law/points.hpp"
#include "materials/law/state_variable.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace tremolo::materials {

/// One elastoplastic element.
struct IwanElement {
  double shear_modulus = 0.0; ///< G_i, Pa
  double strength = 0.0;      ///< tau_i, largest sqrt(s:s/2), Pa
};

/// Elements come in groups of this size, which a processor moves at once.
inline constexpr std::size_t iwan_group = 4;

/// Largest number of elements that a law may have.
inline constexpr std::size_t most_iwan_elements = 60;

/// A vertex of a monotonic curve of shear stress against engineering shear strain.
struct CurveVertex {
  double strain = 0.0; ///< 1
  double stress = 0.0; ///< Pa
};

/// The elements whose sum is the polygon from the origin through the vertices, level after the last one. Each
/// vertex gives one element; the slope of the first side is the sum of their moduli.
/// @param vertices  strains growing, slopes of the sides falling and positive
std::vector<IwanElement> parallel_elements(std::span<const CurveVertex> vertices);

/// Shear stress of the elements under monotonic simple shear from the unloaded state, Pa, odd in the strain.
double monotonic_stress(std::span<const IwanElement> elements, double strain);

/// Advances stress, element stresses and plastic work of all points by one step. State of a point, Pa: group
/// after group of elements the four s_xx, the four s_yy, the four s_xy. Where loops are reduced, e_xx, e_yy,
/// e_xy and gamma_m stand before them.
void update(const Elasticity& elastic, std::span<const IwanElement> elements, const LoopReduction& loops,
            const Points& points);

/// The state block of a point with this many elements.
std::span<const StateVariable> iwan_state_variables(std::size_t elements, const LoopReduction& loops);

/// Refuses a number of elements that is no multiple of iwan_group in [iwan_group, most_iwan_elements].
/// @throws std::invalid_argument naming the number and the allowed range
void check_element_count(std::size_t count);

/// Refuses elements that are not positive, or whose moduli do not add up to the elastic one.
/// @throws std::invalid_argument naming the parameter, its value and the allowed range
void validate(const Elasticity& elastic, std::span<const IwanElement> elements);

} // namespace tremolo::materials
