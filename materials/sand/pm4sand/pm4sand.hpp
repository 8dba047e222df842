#pragma once

// PM4Sand version 3.1 of Boulanger & Ziotopoulou (2017), Report UCD/CGM-17/01, in plane strain: a
// stress-ratio controlled, critical-state compatible bounding surface model for sand that liquefies. Stresses
// enter through the in-plane invariants only,
//
//     p = (sxx + syy)/2,    s = sigma - p I,    r = s/p,    M_cur = sqrt(2) |r|        (compression
//     positive),
//
// and the surfaces are cones about the back stress ratio alpha (yield, radius m), M_b (bounding) and M_d
// (dilatancy), which meet M = 2 sin(phi_cv) at the critical state xi_R = 0. The rates stand in
// pm4sand_rates.hpp, the integration in pm4sand_integration.hpp, the start from a given stress in
// pm4sand_initial.hpp.
//
// What the report leaves open is done as follows. Tensors are kept in axes that turn with the material
// (material_axes.hpp), so that its rule for small reversals, which looks at the horizontal plane, is
// objective. sigma_zz = nu (sxx + syy) is reported and plays no part; strain out of plane is not taken. Where
// the soil is pulled apart the effective stress stays at a floor of p_min/5 and the opening is counted:
// recompression begins when it has closed.

#include "materials/elastic/elasticity.hpp"
#include "materials/elastic/linear_elastic.hpp"
#include "materials/law/parameter.hpp"
#include "materials/law/points.hpp"
#include "materials/law/state_variable.hpp"
#include "materials/law/strength_line.hpp"
#include "materials/law/traits.hpp"
#include "materials/plastic/mohr_coulomb.hpp"

#include <bitset>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace tremolo::materials {

/// The parameters as a user gives them, named as in the report; what is left out follows from the others.
/// Their names in files, meanings, ranges and defaults stand in pm4sand_parameters().
struct Pm4SandInput {
  std::optional<double> density;          ///< kg/m3; needed
  std::optional<double> relative_density; ///< D_R, apparent, as a fraction; needed
  std::optional<double> G_o;              ///< needed
  std::optional<double> h_po;             ///< needed
  std::optional<double> p_A;              ///< Pa
  std::optional<double> e_max;
  std::optional<double> e_min;
  std::optional<double> n_b;
  std::optional<double> n_d;
  std::optional<double> phi_cv; ///< rad
  std::optional<double> poisson;
  std::optional<double> Q;
  std::optional<double> R;
  std::optional<double> m;
  std::optional<double> h_o;
  std::optional<double> A_do;
  std::optional<double> z_max;
  std::optional<double> c_z;
  std::optional<double> c_eps;
  std::optional<double> C_GD;
  std::optional<double> C_DR;
  std::optional<double> C_kaf;
  std::optional<double> F_sed_min;
  std::optional<double> p_sedo; ///< Pa
  std::optional<double> tolerance;
  bool post_shake = false; ///< reduced stiffness of reconsolidation after shaking
};

/// Rules for dividing a step into sub-steps.
struct Pm4Integration {
  double largest_strain = 1e-3;  ///< largest strain component of a sub-step
  double tolerance = 1e-4;       ///< relative error of a sub-step in stress, back stress and fabric
  double smallest_strain = 1e-7; ///< of a sub-step that is taken whatever its error
};

/// PM4Sand with every parameter in force. Make it with pm4sand(); h_po and post_shake may be changed after.
struct Pm4Sand {
  /// The constant-stiffness stage of gravity: G = G_o p_A with nu; and the density.
  Elasticity elastic;
  double relative_density = 0.0; ///< D_R at the start
  double G_o = 0.0;
  double h_po = 0.0;
  double p_A = 0.0; ///< Pa
  double e_max = 0.0;
  double e_min = 0.0;
  double n_b = 0.0;
  double n_d = 0.0;
  double phi_cv = 0.0; ///< rad
  double Q = 0.0;
  double R = 0.0;
  double m = 0.0;
  double h_o = 0.0;
  std::optional<double> A_do;  ///< where given; else a state variable made by initialise()
  std::optional<double> z_max; ///< where given; else a state variable made by initialise()
  double c_z = 0.0;
  double c_eps = 0.0;
  double C_GD = 0.0;
  double C_DR = 0.0;
  double C_kaf = 0.0;
  double F_sed_min = 0.0;
  double p_sedo = 0.0; ///< Pa
  bool post_shake = false;
  Pm4Integration integration;
  double M = 0.0;            ///< critical state line in M_cur, 2 sin(phi_cv)
  double bulk_ratio = 0.0;   ///< K/G
  double density_rate = 0.0; ///< of D_R with volumetric strain, (1 + e_0)/(e_max - e_min)
  std::bitset<32> given = 0; ///< which parameters were given, in the order of pm4sand_parameters()
};

/// The law with all defaults computed from what is given.
/// @throws std::invalid_argument naming the parameter, its value and the allowed range
Pm4Sand pm4sand(const Pm4SandInput& input);

/// The soil in its post-shaking, reconsolidating condition.
Pm4Sand after_shaking(Pm4Sand law);
Pm4Sand shaken_again(Pm4Sand law);

/// The parameters of the input, in the order of the reference.
std::span<const InputField<Pm4SandInput>> pm4sand_parameters();

/// Every parameter: value, unit, meaning, and "given" or the rule it follows from.
std::vector<ParameterValue> parameters(const Pm4Sand& law);

/// The state block of a point.
std::span<const StateVariable> state_variables(const Pm4Sand& law);

/// Writes the state of points that have never been loaded from the stress they have now, any K_0 and static
/// shear. A stress outside the bounding surface, or with p < p_min, is held by an offset that the law adds
/// back to what it reports for ever. Writes sigma_zz = nu (sxx + syy).
void initialise(const Pm4Sand& law, const Points& points);

Traits traits(const Pm4Sand& law);

/// The strength lines at the initial density.
std::vector<StrengthLine> strength_lines(const Pm4Sand& law);

/// The elastic soil to make an initial stress with: stiffness and memory begin with that stress.
LinearElastic without_softening(const Pm4Sand& law);

/// Drained sand at its critical state, tan(phi_cv)/F without cohesion and dilation, to which it is elastic.
std::optional<MohrCoulomb> with_reduced_strength(const Pm4Sand& law, double factor);

std::optional<double> relative_density(const Pm4Sand& law);

/// h_po
std::optional<double> contraction_rate(const Pm4Sand& law);
Pm4Sand with_contraction_rate(Pm4Sand law, double rate);

/// Advances stress, state and plastic work of all points by one step.
/// @throws std::domain_error for strain increments above 0.02, and for stress or state that is not finite:
/// nothing has been changed; or for a point whose stress would not stay finite: that point has not been
void update(const Pm4Sand& law, const Points& points);

/// sqrt((K + 4G/3)/rho) at the largest pressure over the points, or at p_min of their state where that is
/// more, with the undegraded G, m/s. Pressure can multiply in dilation: ask again as the points move.
double p_wave_speed_bound(const Pm4Sand& law, const Points& points);

/// G over G_o p_A of each point, as pressure, stress ratio and fabric leave it.
void stiffness_ratios(const Pm4Sand& law, const Points& points, double* ratios);
/// The first sub-step of an update begins with them.
void update_and_find_stiffness(const Pm4Sand& law, const Points& points, double* ratios);

/// @throws std::invalid_argument naming the parameter, its value and the allowed range
void validate(const Pm4Sand& law);

} // namespace tremolo::materials
