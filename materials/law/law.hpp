#pragma once

// The one interface of constitutive laws, used by columns and domain alike. A law is a plain struct of
// parameters; what it does are free functions on blocks of points. Choosing the law costs one branch per
// block, not per point. Nobody outside this folder asks which law it is: traits() and the functions below
// answer instead. A law is added by its own files and its name in the list Laws; defaults.hpp says what it
// must bring.

#include "materials/elastic/linear_elastic.hpp"
#include "materials/hysteretic/iwan_shear.hpp"
#include "materials/hysteretic/masing_shear.hpp"
#include "materials/hysteretic/multi_yield_clay.hpp"
#include "materials/law/parameter.hpp"
#include "materials/law/points.hpp"
#include "materials/law/state_variable.hpp"
#include "materials/law/strength_line.hpp"
#include "materials/law/traits.hpp"
#include "materials/plastic/drucker_prager.hpp"
#include "materials/plastic/mohr_coulomb.hpp"
#include "materials/sand/pdmy03/pdmy03.hpp"
#include "materials/sand/pm4sand/pm4sand.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tremolo::materials {

using Laws = std::variant<LinearElastic, MohrCoulomb, MasingShear, IwanShear, DruckerPrager, MultiYieldClay,
                          Pm4Sand, Pdmy03>;

/// One of the laws. Its special members are those of the list, compiled once: in every file that copies a
/// soil they would be a tenth of the code.
class Law : public Laws {
public:
  using Laws::Laws;
  using Laws::operator=;
  Law();
  Law(const Law& other);
  Law(Law&& other) noexcept;
  Law& operator=(const Law& other);
  Law& operator=(Law&& other) noexcept;
  ~Law();
};

/// Traits of a law.
Traits traits(const Law& law);

/// The name of the law, e.g. "linear_elastic".
inline std::string_view name(const Law& law) {
  return traits(law).name;
}

/// The state variables of one point, in the order of its state block.
std::span<const StateVariable> state_variables(const Law& law);

/// Writes the state of points that have never been loaded from the stress they have now, e.g. the geostatic
/// one. May bring a stress that the law cannot hold back to where it can.
/// @throws std::invalid_argument for stresses that are not finite
void initialise(const Law& law, const Points& points);

/// Advances stress and state of all points by one step of strain and rotation. A point's result does not
/// depend on the others in the call.
/// @throws std::domain_error for an increment that the law cannot follow; the points of the call are
/// unchanged
void update(const Law& law, const Points& points);

/// The law's elastic constants at small strain; of a law whose stiffness depends on pressure those at its
/// reference pressure.
const Elasticity& elasticity(const Law& law);
/// Makes the law with another stress at rest, Elasticity::at_rest.
Law with_rest_coefficient(Law law, double coefficient);

/// An upper estimate of c_p over the points in their present stress and state, m/s: the elastic one, which
/// for flow that is not associated is the usual bound, not a proven one.
double p_wave_speed_bound(const Law& law, const Points& points);

/// The elastic stiffness of each point in its present stress and state over that of elasticity(law), 1.
/// Poisson's ratio is a parameter, so one number suffices for all moduli.
void stiffness_ratios(const Law& law, const Points& points, double* ratios);

/// update(), which gives stiffness_ratios() of the points before the step too: sands need them on their way.
void update_and_find_stiffness(const Law& law, const Points& points, double* ratios);

/// A law that files give by its fields and the elastic constants alone, with no field set; nothing for other
/// names.
std::optional<Law> law_of_fields(std::string_view name, const Elasticity& elastic = {});

/// A field of a law, where it stands.
struct FieldOfLaw {
  Parameter text;
  double* value;
};

/// The fields that files give; none of a law that is not given by fields.
std::vector<FieldOfLaw> fields(Law& law);

/// Every parameter in force and where its value comes from.
std::vector<ParameterValue> parameters(const Law& law);

/// The law to make an initial stress with, e.g. by gravity: held at its peak strength; elastic for the
/// hysteretic laws, whose strain is measured from the initial state, and for those whose stiffness depends on
/// pressure; itself if it does not soften.
Law without_softening(const Law& law);

/// The soil with its strength divided by a factor, c/F and tan(phi)/F or s_u/F, as a factor of safety wants
/// it: the law itself, or for laws that carry any load at rest another one of its strength; nothing for soil
/// without a strength.
/// @param factor  F, 1, > 0
std::optional<Law> with_reduced_strength(const Law& law, double factor);

/// The law of the same soil once shaking is over and it reconsolidates; itself for laws that know no such
/// condition.
Law after_shaking(const Law& law);
/// The law of such soil when it is shaken again, as it was before after_shaking().
Law shaken_again(const Law& law);

/// The law in cells of another size than it was calibrated with; itself if it does not soften.
/// @param cell_size, reference_size  m
Law for_cell_size(const Law& law, double cell_size, double reference_size);

/// The curve of a law whose shear stress follows from shear strain alone, by Masing's rules; nothing for the
/// others.
std::optional<Backbone> shear_backbone(const Law& law);

/// The relative density that a law of sand represents, 1; empty for other laws.
std::optional<double> relative_density(const Law& law);

/// The parameter that is fitted to a cyclic strength, 1; nothing for a law without one.
std::optional<double> contraction_rate(const Law& law);

/// The law with another contraction rate.
/// @throws std::invalid_argument for a law without one
Law with_contraction_rate(const Law& law, double rate);

/// Failure and other lines in the plane of p and q, in which trait in_plane says what p and q are.
std::vector<StrengthLine> strength_lines(const Law& law);

/// Cautions to users of the law, a sentence or two each.
std::vector<std::string> notes(const Law& law);

/// Refuses parameters outside their physical range.
/// @throws std::invalid_argument naming the parameter, its value and the allowed range
void validate(const Law& law);

} // namespace tremolo::materials
