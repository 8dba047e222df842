#include "mpm_domain/gravity/strength_reduction.hpp"

#include "mpm_domain/gravity/gravity_stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

/// Unbalanced over applied force at which a model counts as at rest. One that fails keeps some thousandths.
constexpr double rest_residual = 1e-4;

/// Periods of a layer of the model's depth after which one that still moves has failed.
constexpr double patience = 60.0;

constexpr double bracket_step = 1.25;
constexpr double least_factor = 0.1;
constexpr double largest_factor = 10.0;

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

/// The place of the equivalent plastic strain in a law's state, or nothing.
std::optional<std::size_t> plastic_strain_place(const materials::Law& law) {
  const auto variables = materials::state_variables(law);
  const auto found =
      std::ranges::find(variables, "equivalent_plastic_strain", &materials::StateVariable::name);
  if (found == variables.end())
    return std::nullopt;
  return static_cast<std::size_t>(found - variables.begin());
}

/// How the soil of a domain moves whose gravity stage has found no rest.
std::vector<MovingPoint> mechanism_of(Domain& domain) {
  take_velocities_of_nodes(domain);
  std::vector<MovingPoint> points;
  double fastest = 0.0;
  for (const Particles& set : domain.sets_of_soil()) {
    const auto strain = plastic_strain_place(set.law);
    for (std::size_t k = 0; k < set.size(); ++k) {
      points.push_back({{set.x[k], set.y[k]},
                        2.0 * set.half_size,
                        {set.vx[k], set.vy[k]},
                        strain ? set.state[k * set.state_size + *strain] : 0.0});
      fastest = std::max(fastest, std::hypot(set.vx[k], set.vy[k]));
    }
  }
  for (MovingPoint& point : points)
    point.velocity = {point.velocity.x / fastest, point.velocity.y / fastest};
  return points;
}

} // namespace

ReducibleSoils reducible_soils(const Spec& spec) {
  ReducibleSoils soils;
  for (const Soil& soil : spec.soils) {
    auto& names = materials::with_reduced_strength(soil.law, 1.0) ? soils.reduced : soils.kept;
    if (names.empty() || names.back() != soil.name) // slices of one soil have its name
      names.push_back(soil.name);
  }
  return soils;
}

FactorOfSafety factor_of_safety(const Spec& spec, double tolerance, const TrialProgress& progress) {
  if (reducible_soils(spec).reduced.empty())
    throw std::invalid_argument(
        "no soil of this model has a cohesion and a friction angle to be divided by a factor");
  const double time = patience * layer_period(spec);
  FactorOfSafety safety{.stands = 0.0, .fails = 0.0, .mechanism = {}};
  const auto stands = [&](double factor) {
    StrengthTrial trial{.factor = factor};
    const auto note = [&](long, double residual) { trial.residual = residual; };
    Domain domain(with_factor(spec, factor));
    try {
      trial.stands =
          !relax_under_gravity(domain, {.residual = rest_residual, .max_time = time}, note).slipping;
    } catch (const NotAtRest&) {
      trial.stands = false;
    }
    if (!trial.stands)
      safety.mechanism = mechanism_of(domain);
    (trial.stands ? safety.stands : safety.fails) = factor;
    progress(trial);
    return trial.stands;
  };
  double factor = 1.0;
  if (stands(factor))
    while (stands(factor *= bracket_step))
      if (factor >= largest_factor)
        throw std::runtime_error(
            fmt::format("the model carries its weight with its strength divided by {:.3g}: "
                        "its soil does not fail, allowed are factors from {} to {}",
                        factor, least_factor, largest_factor));
  while (safety.stands == 0.0)
    if (!stands(factor /= bracket_step) && factor <= least_factor)
      throw std::runtime_error(
          fmt::format("the model fails with its strength multiplied by {:.3g}: it is not the "
                      "strength that is missing, allowed are factors from {} to {}",
                      1.0 / factor, least_factor, largest_factor));
  while (safety.fails > (1.0 + tolerance) * safety.stands)
    stands(0.5 * (safety.stands + safety.fails));
  return safety;
}

} // namespace tremolo::mpm_domain
