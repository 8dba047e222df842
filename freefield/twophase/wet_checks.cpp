#include "freefield/twophase/wet_checks.hpp"

#include "base/require.hpp"
#include "freefield/column_relaxation.hpp"
#include "freefield/column_soil.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::freefield {

void validate_march(const Profile& profile, const Damping& damping, double time_step, double start_time) {
  validate(profile);
  require(time_step > 0.0 && std::isfinite(time_step), "time step of the column", time_step,
          "positive, in s");
  require(std::isfinite(start_time), "start time of the column", start_time, "finite");
  if (std::ranges::any_of(profile.layers, [](const Layer& layer) { return layer.damping_ratio > 0.0; }))
    validate(damping);
  const bool flows = std::ranges::any_of(profile.layers, [](const Layer& layer) {
    return layer.pores && layer.pores->drainage == materials::Drainage::coupled;
  });
  require(!flows || profile.gravity > 0.0, "gravity where water flows", profile.gravity,
          "positive, in m/s2: hydraulic conductivity is made for it");
}

RestingColumn resting_column(const Profile& profile, double max_element_size, const Damping& damping) {
  validate(profile);
  RestingColumn column{mesh_profile(profile, max_element_size), {}, {}};
  const ColumnSoil soil(profile, column.mesh);
  SoilState state = soil.initial();
  soil.p_moduli(state, column.moduli);
  column.moduli = ColumnRelaxation(profile, column.mesh, damping, 0.0).unrelaxed(std::move(column.moduli));
  column.grid = wet_grid(profile, column.mesh, damping, false);
  return column;
}

void follow_clock(const materials::SoilClock& clock, double time, ColumnSoil& soil, WetGrid& grid) {
  if (!clock.has_rested(time))
    return;
  soil.rest(clock.rests(time));
  set_flow_speed(grid, clock.speed(time));
}

void require_pores(const WetGrid& grid, const ColumnMesh& mesh, double time) {
  constexpr double least = 0.01, most = 0.95;
  for (std::size_t e = 0; e < grid.elements.size(); ++e) {
    const WetElement& element = grid.elements[e];
    const double n = element.porosity();
    if (element.bulk_modulus > 0.0 && !(n >= least && n <= most))
      throw std::runtime_error(fmt::format("the soil of the free-field column has strained so much that its "
                                           "porosity is {:.4g} at y = {:.4g} m "
                                           "and {:.4g} s, from {:.4g}; it must stay in [{:g}, {:g}]",
                                           n, 0.5 * (mesh.node_y[e] + mesh.node_y[e + 1]), time,
                                           1.0 - element.grain_share, least, most));
  }
}

void require_stable(double time_step, double limit, double time) {
  if (time_step > limit)
    throw std::runtime_error(fmt::format(
        "the soil of the free-field column has become so stiff, with its pressure, that at {:.4g} s "
        "steps of {:.4g} s are no longer stable, the limit is {:.4g} s; choose a smaller step",
        time, time_step, limit));
}

void require_same_size(std::span<const double> y, std::span<const ColumnSample> samples) {
  if (y.size() != samples.size())
    throw std::invalid_argument("number of samples is " + std::to_string(samples.size()) +
                                ", must be that of the levels, " + std::to_string(y.size()));
}

std::string missing_energy(const WetEnergy& spent) {
  constexpr double nothing = 1e-6; // J/m2: a micrometre a second in a thousand metres of soil
  if (spent.given() <= nothing)
    return {};
  return fmt::format("; of the energy given, {:.4g} J/m2, {:.2g} % is missing", spent.given(),
                     100.0 * std::abs(spent.missing()) / spent.given());
}

} // namespace tremolo::freefield
