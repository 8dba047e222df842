#include "mpm_domain/gravity/strength_reduction.hpp"

#include "mpm_domain/gravity/gravity_stage.hpp"

#include <algorithm>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

/// Unbalanced over applied force at which a model counts as at rest. One that fails keeps some thousandths.
constexpr double rest_residual = 1e-4;

/// Periods of a layer of the model's depth after which one that still moves has failed, unless its residual
/// is below this share of what it was half-way.
constexpr double patience = 60.0;
constexpr double falling = 0.8;

/// Depth of the skin of which trials say that it ravels, in cells.
constexpr double skin = 2.0;

constexpr double bracket_step = 1.25;

Spec with_factor(Spec spec, double factor) {
  for (Soil& soil : spec.soils) {
    soil.law = materials::with_reduced_strength(soil.law, factor).value_or(soil.law);
    for (materials::Law& law : soil.finer_laws)
      law = materials::with_reduced_strength(law, factor).value_or(law);
  }
  return spec;
}

double layer_period(const Spec& spec) {
  double slowest = materials::elasticity(spec.soils.front().law).s_wave_speed();
  for (const Soil& soil : spec.soils)
    slowest = std::min(slowest, materials::elasticity(soil.law).s_wave_speed());
  return 4.0 * (spec.box.y_max - spec.box.y_min) / slowest;
}

/// Trials of a model, and what they have said so far.
class Trials {
public:
  Trials(const Spec& spec, const TrialProgress& progress)
      : spec_(spec), progress_(progress), time_(patience * layer_period(spec)) {
    if (reducible_soils(spec).reduced.empty())
      throw std::invalid_argument("no soil of this model has a strength to be divided by a factor");
  }

  void make(double factor) {
    StrengthTrial trial{.factor = factor};
    auto failure = relax(trial, 0.0);
    if (is_skin(failure.soil)) {
      failure = relax(trial, skin);
      trial.ravels = trial.stands;
    }
    if (!trial.stands) {
      found_.mechanism = failure.soil;
      found_.structures = failure.structures;
    }
    (trial.stands ? found_.stands : found_.fails) = factor;
    progress_(trial);
  }
  const FactorOfSafety& found() const { return found_; }

private:
  /// The moving soil in a trial that fails.
  struct Failure {
    std::vector<MovingPoint> soil;
    std::vector<std::string> structures;
  };

  /// @param left_out  depth of the skin that does not count, in cells
  Failure relax(StrengthTrial& trial, double left_out) const {
    Domain domain(with_factor(spec_, trial.factor));
    Failure failure;
    try {
      const Reactions reactions = relax_under_gravity(
          domain, {.residual = rest_residual, .max_time = time_, .skin = left_out, .falling = falling},
          [&](long, double residual) { trial.residual = residual; });
      trial.stands = !reactions.slipping;
      for (const std::size_t body : reactions.slipping_bodies)
        failure.structures.push_back(domain.contact.bodies()[body].name());
    } catch (const NotAtRest&) {
      trial.stands = false;
    }
    if (!trial.stands)
      failure.soil = mechanism_of(domain);
    return failure;
  }

  bool is_skin(const std::vector<MovingPoint>& mechanism) const {
    const auto extent = extent_of(mechanism);
    return extent && extent->rows <= skin * spec_.particles_per_cell;
  }

  const Spec& spec_;
  const TrialProgress& progress_;
  double time_; ///< after which one that still moves has failed, s; more where its residual falls
  FactorOfSafety found_;
};

} // namespace

ReducibleSoils reducible_soils(const Spec& spec) {
  ReducibleSoils soils;
  for (const Soil& soil : spec.soils) {
    auto& names = materials::with_reduced_strength(soil.law, 1.0) ? soils.reduced : soils.kept;
    if (names.empty() || names.back() != soil.name) // slices of one soil have its name
      names.push_back(soil.name);
  }
  // A model that may fail only in a part has its soils twice (held_soil.hpp).
  std::erase_if(soils.kept, [&](const std::string& name) {
    return std::ranges::find(soils.reduced, name) != soils.reduced.end();
  });
  return soils;
}

FactorOfSafety factor_of_safety(const Spec& spec, double tolerance, const TrialProgress& progress) {
  Trials trials(spec, progress);
  const FactorOfSafety& found = trials.found();
  trials.make(1.0);
  while (!found.fails && *found.stands < largest_factor)
    trials.make(std::min(*found.stands * bracket_step, largest_factor));
  while (!found.stands && *found.fails > least_factor)
    trials.make(std::max(*found.fails / bracket_step, least_factor));
  while (found.stands && found.fails && *found.fails > (1.0 + tolerance) * *found.stands)
    trials.make(0.5 * (*found.stands + *found.fails));
  return found;
}

FactorOfSafety try_factor(const Spec& spec, double factor, const TrialProgress& progress) {
  Trials trials(spec, progress);
  trials.make(factor);
  return trials.found();
}

} // namespace tremolo::mpm_domain
