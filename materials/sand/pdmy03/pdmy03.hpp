#pragma once

// Pressure-dependent multi-yield law for sand and its cyclic mobility, parameter set "03",
//
//     Khosravifar, Elgamal, Lu & Li (2018), Soil Dyn. Earthq. Eng. 110, 43-52,
//     Yang, Elgamal & Parra (2003), J. Geotech. Geoenviron. Eng. 129(12), 1119-1127.
//
// N nested cones f_i = 3/2 |s - h c_i|^2 - (M_i h)^2 with a common apex at the mean stress p_res share the
// stress-strain curve of the soil among them: h = sigma_m - p_res, H = -h, stiffness grows as (H/H_r)^d. The
// deviatoric flow is associated; the volumetric one contracts below the phase transformation line and on
// unloading, and dilates above it (pdmy03_flow.hpp), with perfectly plastic shear strain in between that
// grows from cycle to cycle. Cones move with the stress (pdmy03_surfaces.hpp) and live in the axes of the
// material.
//
// Tension positive, strains as fractions. "Octahedral" shear strain is (2/sqrt 3)|e|, stress |s|/sqrt 3.

#include "base/words.hpp"
#include "materials/elastic/elasticity.hpp"
#include "materials/elastic/linear_elastic.hpp"
#include "materials/law/parameter.hpp"
#include "materials/law/points.hpp"
#include "materials/law/state_variable.hpp"
#include "materials/law/strength_line.hpp"
#include "materials/law/traits.hpp"
#include "materials/plastic/mohr_coulomb.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tremolo::materials {

/// Relation of the friction angle to the circular cones.
enum class Pdmy03Cone {
  triaxial_compression, ///< M = 6 sin(phi)/(3 - sin(phi)), the one the recommended sets are meant for
  triaxial_extension,   ///< M = 6 sin(phi)/(3 + sin(phi))
  plane_strain          ///< M = sqrt(3) sin(phi): phi is then the angle mobilised in the plane
};
constexpr auto words(Pdmy03Cone) {
  return word_table<Pdmy03Cone>({{Pdmy03Cone::triaxial_compression, "triaxial_compression"},
                                 {Pdmy03Cone::triaxial_extension, "triaxial_extension"},
                                 {Pdmy03Cone::plane_strain, "plane_strain"}});
}

/// One point of a modulus reduction curve as measured in simple shear.
struct ModulusReduction {
  double shear_strain = 0.0;  ///< engineering shear strain
  double modulus_ratio = 0.0; ///< G/Gmax at the reference pressure
};

inline constexpr std::size_t most_pdmy03_surfaces = 40;

/// Input by the user. Without `relative_density` every value that has no default must be given; with it, the
/// recommended set of that density supplies the missing ones.
struct Pdmy03Input {
  std::optional<double> relative_density; ///< one of 0.33, 0.57, 0.74, 0.87; nothing between them

  std::optional<double> density;                    ///< of the saturated soil, kg/m3
  std::optional<double> shear_modulus;              ///< G_r at the reference pressure, Pa
  std::optional<double> bulk_modulus;               ///< B_r at the reference pressure, Pa
  std::optional<double> friction;                   ///< rad, for the cone below
  std::optional<double> phase_transformation;       ///< rad
  std::array<std::optional<double>, 5> contraction; ///< c_a, c_b, c_c, c_d, c_e
  std::array<std::optional<double>, 3> dilation;    ///< d_a, d_b, d_c

  std::optional<double> peak_shear_strain;    ///< octahedral, at the reference pressure; default 0.1
  std::optional<double> reference_pressure;   ///< p_r, Pa; default 101 kPa
  std::optional<double> pressure_exponent;    ///< d; default 0.5
  std::optional<double> surfaces;             ///< N; default 20
  std::optional<double> liquefaction_1;       ///< share of dilation in the perfectly plastic zone; default 1
  std::optional<double> liquefaction_2;       ///< share of its translation; default 0
  std::optional<double> atmospheric_pressure; ///< p_a, Pa; default 101 kPa
  std::optional<double> zero_pressure_strength; ///< S0, Pa; default 1.73 kPa

  std::optional<Pdmy03Cone> cone; ///< triaxial_compression
  /// Replaces the hyperbola: strength, friction angle and number of surfaces then follow from it.
  std::vector<ModulusReduction> modulus_reduction;
};

/// Origin of a value in force.
enum class Pdmy03Origin : unsigned char { given, table, fallback, curve };

/// The parameters in force, resolved. Made by pdmy03().
struct Pdmy03 {
  Elasticity elastic;            ///< G_r, B_r as they stand, also for a stage of gravity
  double relative_density = 0.0; ///< of the recommended set; 0: none was requested
  double friction = 0.0;
  double phase_transformation = 0.0;
  std::array<double, 5> contraction{};
  std::array<double, 3> dilation{};
  double peak_shear_strain = 0.0;
  double reference_pressure = 0.0;
  double pressure_exponent = 0.0;
  double liquefaction_1 = 0.0;
  double liquefaction_2 = 0.0;
  double atmospheric_pressure = 0.0;
  double zero_pressure_strength = 0.0;
  Pdmy03Cone cone = Pdmy03Cone::triaxial_compression;
  bool cone_given = false;

  // Derived values (pdmy03_surfaces.hpp); index i is the surface, 0 the elastic core.
  std::size_t surfaces = 0;
  double residual_pressure = 0.0;                                 ///< p_res, Pa
  double transformation_ratio = 0.0;                              ///< eta_PT
  std::array<double, most_pdmy03_surfaces + 1> ratio{};           ///< M_i
  std::array<double, most_pdmy03_surfaces + 1> plastic_modulus{}; ///< H'_i at the reference pressure, Pa
  std::array<double, most_pdmy03_surfaces + 1> tangent_modulus{}; ///< elastoplastic, twice d tau/d gamma, Pa

  static constexpr std::size_t origin_count = 21;
  std::array<Pdmy03Origin, origin_count> origins{}; ///< in the order of parameters()
};

/// The law with everything that was not given taken from the recommended set of the density, or the defaults.
/// @throws std::invalid_argument naming what is missing or out of range; for a density without a set it names
/// the four that have one
Pdmy03 pdmy03(const Pdmy03Input& input);

/// The numbers of the input, in the order of the reference.
std::span<const InputField<Pdmy03Input>> pdmy03_parameters();

/// The recommended set of one density, as input to change or complete.
/// @throws std::invalid_argument for a density other than 0.33, 0.57, 0.74, 0.87: sets are not interpolated
Pdmy03Input pdmy03_recommended(double relative_density);

Traits traits(const Pdmy03& law);

std::vector<StrengthLine> strength_lines(const Pdmy03& law);

/// The elastic soil to make an initial stress with: stiffness and memory begin with that stress.
LinearElastic without_softening(const Pdmy03& law);

/// Drained sand of its friction angle, whatever the cone, tan(phi)/F without cohesion and dilation, to which
/// it is elastic.
std::optional<MohrCoulomb> with_reduced_strength(const Pdmy03& law, double factor);

/// Relative density of the recommended set, 1; empty if no set was requested.
std::optional<double> relative_density(const Pdmy03& law);

/// Advances stress, state and plastic work of all points by one step, in sub-increments of 1e-5 strain.
/// @throws std::domain_error for an increment above pdmy03_largest_increment, and for stress or state that is
/// not finite; nothing has been changed
void update(const Pdmy03& law, const Points& points);

/// Largest strain component of one step; it takes some thousand sub-increments.
inline constexpr double pdmy03_largest_increment = 0.05;

/// Sets the state of points that have been loaded elastically to the stress they have: every surface that the
/// stress lies outside of is moved to touch it, and the strain of that elastic loading is remembered. Tension
/// is cut, and a stress outside the failure cone is scaled back onto it.
void initialise(const Pdmy03& law, const Points& points);

/// @throws std::invalid_argument naming the parameter, its value and the allowed range
void validate(const Pdmy03& law);

/// The state block of one point; its length depends on the number of surfaces.
std::span<const StateVariable> state_variables(const Pdmy03& law);

/// c_p with the stiffness at the largest effective pressure of the points, m/s. The flow is not associated:
/// the usual bound, not a proven one, and dilation can raise it several times within a few cycles.
double p_wave_speed_bound(const Pdmy03& law, const Points& points);

/// F of each point, ((p' + p_res)/(p_r + p_res))^d.
void stiffness_ratios(const Pdmy03& law, const Points& points, double* ratios);

/// Every value in force, with unit, meaning and origin.
std::vector<ParameterValue> parameters(const Pdmy03& law);

/// Cautions to users of these parameters, e.g. about the strength of a triaxial compression cone in plane
/// strain, one sentence or two each.
std::vector<std::string> notes(const Pdmy03& law);

} // namespace tremolo::materials
