#include "materials/law/law.hpp"

#include "materials/law/defaults.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace tremolo::materials {
namespace {

/// Whether a law has all that has no default. Without this check a function that a law lacks would be the one
/// for any law, which calls itself.
template <class L>
concept Complete = requires(const L& law) {
  static_cast<const Elasticity&>(law.elastic);
  static_cast<Traits (*)(const L&)>(traits);
  static_cast<std::span<const StateVariable> (*)(const L&)>(state_variables);
  static_cast<void (*)(const L&, const Points&)>(update);
  static_cast<void (*)(const L&)>(validate);
  static_cast<std::vector<ParameterValue> (*)(const L&)>(parameters);
};

template <class... Each>
constexpr bool all_complete(std::type_identity<std::variant<Each...>> /*laws*/) {
  return (Complete<Each> && ...);
}
static_assert(all_complete(std::type_identity<Laws>{}),
              "a law lacks one of the functions in law/defaults.hpp");

/// Whether files give a law by its fields.
template <class L>
concept GivenByFields = requires(const L& law) {
  static_cast<std::span<const LawField<L>> (*)(const L&)>(fields);
};

template <class L>
void take_if_named(std::string_view wanted, const Elasticity& elastic, std::optional<Law>& found) {
  if constexpr (GivenByFields<L>)
    if (const L law{.elastic = elastic}; traits(law).name == wanted)
      found = law;
}

template <class... Each>
std::optional<Law> first_named(std::string_view wanted, const Elasticity& elastic,
                               std::type_identity<std::variant<Each...>> /*laws*/) {
  std::optional<Law> found;
  (take_if_named<Each>(wanted, elastic, found), ...);
  return found;
}

} // namespace

static_assert(std::is_nothrow_move_constructible_v<Laws> && std::is_nothrow_move_assignable_v<Laws>);
Law::Law() = default;
Law::Law(const Law& other) = default;
Law::Law(Law&& other) noexcept = default;
Law& Law::operator=(const Law& other) = default;
Law& Law::operator=(Law&& other) noexcept = default;
Law::~Law() = default;

Traits traits(const Law& law) {
  return std::visit([](const auto& one) { return traits(one); }, law);
}

std::span<const StateVariable> state_variables(const Law& law) {
  return std::visit([](const auto& one) { return state_variables(one); }, law);
}

void initialise(const Law& law, const Points& points) {
  const auto variables = state_variables(law);
  for (std::size_t i = 0; i < points.count; ++i) {
    for (const double stress : {points.sxx[i], points.syy[i], points.szz[i], points.sxy[i]}) {
      if (!std::isfinite(stress)) {
        throw std::invalid_argument(
            fmt::format("initial stress of point {}: {:g} Pa is not finite", i, stress));
      }
    }
    for (std::size_t k = 0; k < variables.size(); ++k)
      points.state[i * variables.size() + k] = variables[k].initial;
  }
  using defaults::initialise;
  std::visit([&](const auto& one) { initialise(one, points); }, law);
}

void update(const Law& law, const Points& points) {
  std::visit([&](const auto& one) { update(one, points); }, law);
}

const Elasticity& elasticity(const Law& law) {
  return std::visit([](const auto& one) -> const Elasticity& { return one.elastic; }, law);
}

Law with_rest_coefficient(Law law, double coefficient) {
  std::visit([coefficient](auto& one) { one.elastic.at_rest = coefficient; }, law);
  return law;
}

double p_wave_speed_bound(const Law& law, const Points& points) {
  using defaults::p_wave_speed_bound;
  return std::visit([&](const auto& one) { return p_wave_speed_bound(one, points); }, law);
}

void stiffness_ratios(const Law& law, const Points& points, double* ratios) {
  using defaults::stiffness_ratios;
  std::visit([&](const auto& one) { stiffness_ratios(one, points, ratios); }, law);
}

void update_and_find_stiffness(const Law& law, const Points& points, double* ratios) {
  using defaults::update_and_find_stiffness;
  std::visit([&](const auto& one) { update_and_find_stiffness(one, points, ratios); }, law);
}

std::optional<Law> law_of_fields(std::string_view name, const Elasticity& elastic) {
  return first_named(name, elastic, std::type_identity<Laws>{});
}

std::vector<FieldOfLaw> fields(Law& law) {
  return std::visit(
      []<class L>(L& one) {
        std::vector<FieldOfLaw> all;
        if constexpr (GivenByFields<L>)
          for (const auto& [text, field] : fields(one))
            all.push_back({text, &(one.*field)});
        return all;
      },
      static_cast<Laws&>(law));
}

std::vector<ParameterValue> parameters(const Law& law) {
  return std::visit([](const auto& one) { return parameters(one); }, law);
}

Law without_softening(const Law& law) {
  using defaults::without_softening;
  return std::visit([](const auto& one) -> Law { return without_softening(one); }, law);
}

std::optional<Law> with_reduced_strength(const Law& law, double factor) {
  using defaults::with_reduced_strength;
  return std::visit(
      [factor](const auto& one) -> std::optional<Law> { return with_reduced_strength(one, factor); }, law);
}

Law after_shaking(const Law& law) {
  using defaults::after_shaking;
  return std::visit([](const auto& one) -> Law { return after_shaking(one); }, law);
}

Law shaken_again(const Law& law) {
  using defaults::shaken_again;
  return std::visit([](const auto& one) -> Law { return shaken_again(one); }, law);
}

Law for_cell_size(const Law& law, double cell_size, double reference_size) {
  using defaults::for_cell_size;
  return std::visit([&](const auto& one) -> Law { return for_cell_size(one, cell_size, reference_size); },
                    law);
}

std::optional<Backbone> shear_backbone(const Law& law) {
  using defaults::shear_backbone;
  return std::visit([](const auto& one) { return shear_backbone(one); }, law);
}

std::optional<double> relative_density(const Law& law) {
  using defaults::relative_density;
  return std::visit([](const auto& one) { return relative_density(one); }, law);
}

std::optional<double> contraction_rate(const Law& law) {
  using defaults::contraction_rate;
  return std::visit([](const auto& one) { return contraction_rate(one); }, law);
}

Law with_contraction_rate(const Law& law, double rate) {
  using defaults::with_contraction_rate;
  return std::visit([&](const auto& one) -> Law { return with_contraction_rate(one, rate); }, law);
}

std::vector<StrengthLine> strength_lines(const Law& law) {
  using defaults::strength_lines;
  return std::visit([](const auto& one) { return strength_lines(one); }, law);
}

std::vector<std::string> notes(const Law& law) {
  using defaults::notes;
  return std::visit([](const auto& one) { return notes(one); }, law);
}

void validate(const Law& law) {
  std::visit([](const auto& one) { validate(one); }, law);
}

} // namespace tremolo::materials
