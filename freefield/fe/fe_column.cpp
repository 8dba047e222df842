#include "freefield/fe/fe_column.hpp"

#include "base/require.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::freefield {
namespace {

/// Checks what the mesh and the column are about to be built from.
const Profile& checked(const Profile& profile, const Damping& damping) {
  validate(profile);
  if (std::ranges::any_of(profile.layers, [](const Layer& layer) { return layer.pores.has_value(); }))
    throw std::invalid_argument("a column of one phase takes no layers with pore water");
  const auto is_damped = [](const Layer& layer) { return layer.damping_ratio > 0.0; };
  if (std::any_of(profile.layers.begin(), profile.layers.end(), is_damped))
    validate(damping);
  return profile;
}

const FeColumnSettings& checked(const FeColumnSettings& settings) {
  require(settings.time_step > 0.0 && std::isfinite(settings.time_step), "time step of the column",
          settings.time_step, "positive, in s");
  require(std::isfinite(settings.start_time), "start time of the column", settings.start_time, "finite");
  require(settings.hht_alpha >= -1.0 / 3.0 && settings.hht_alpha <= 0.0, "alpha of Hilber, Hughes and Taylor",
          settings.hht_alpha, "in [-1/3, 0]");
  require(settings.integrator == Integrator::newmark || settings.hht_alpha == 0.0,
          "alpha of Hilber, Hughes and Taylor", settings.hht_alpha, "0 with central differences");
  require(settings.newton_tolerance >= 1e-14 && settings.newton_tolerance <= 1e-2,
          "tolerance of Newton's method", settings.newton_tolerance, "in [1e-14, 0.01]");
  return settings;
}

std::variant<LinearColumn, NonlinearColumn> march(const Profile& profile, const ColumnMesh& mesh,
                                                  const FeColumnSettings& settings) {
  const auto has_law = [](const Layer& layer) { return layer.law.has_value(); };
  if (std::any_of(profile.layers.begin(), profile.layers.end(), has_law))
    return NonlinearColumn(profile, mesh, settings);
  return LinearColumn(profile, mesh, settings);
}

} // namespace

double central_difference_limit(const Profile& profile, double max_element_size, const Damping& damping) {
  return central_difference_limit(profile, mesh_profile(checked(profile, damping), max_element_size),
                                  damping);
}

FeColumn::FeColumn(const Profile& profile, const FeColumnSettings& settings, InputVelocity input)
    : settings_(checked(settings)),
      mesh_(mesh_profile(checked(profile, settings.damping), settings.max_element_size)),
      input_(std::move(input)), soil_(march(profile, mesh_, settings)) {
  if (!input_)
    throw std::invalid_argument("the column has no input motion");
}

double FeColumn::time() const {
  return settings_.start_time + static_cast<double>(steps_) * settings_.time_step;
}

void FeColumn::step() {
  std::visit([&](auto& soil) { soil.step(input_, time()); }, soil_);
  ++steps_;
}

void FeColumn::sample(std::span<const double> y, std::span<ColumnSample> samples) const {
  if (y.size() != samples.size()) {
    throw std::invalid_argument("number of samples is " + std::to_string(samples.size()) +
                                ", must be that of the levels, " + std::to_string(y.size()));
  }
  for (std::size_t i = 0; i < y.size(); ++i) {
    const auto side = from_below(y, i) ? ColumnMesh::Side::below : ColumnMesh::Side::above;
    const ColumnMesh::Place place = mesh_.at(y[i], side);
    samples[i] = std::visit([&](const auto& soil) { return soil.sample(place); }, soil_);
  }
}

ColumnEnergy FeColumn::energy() const {
  return std::visit([](const auto& soil) { return soil.energy(); }, soil_);
}

NewtonCounts FeColumn::counts() const {
  return std::visit([](const auto& soil) { return soil.counts(); }, soil_);
}

std::string FeColumn::report() const {
  const NewtonCounts done = counts();
  const auto steps = fmt::format("{} steps of {:.4g} s", steps_, settings_.time_step);
  if (done.iterations == 0)
    return steps;
  return fmt::format("{}, {} Newton iterations, {} steps halved", steps, done.iterations, done.halved_steps);
}

} // namespace tremolo::freefield
