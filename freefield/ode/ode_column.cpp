#include "freefield/ode/ode_column.hpp"

#include "base/require.hpp"
#include "freefield/base_motion.hpp"
#include "freefield/ode/ode_backbone.hpp"
#include "freefield/ode/ode_polarisation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace tremolo::freefield {
namespace {

using materials::Elasticity;

void check(const Profile& profile, const OdeColumnSettings& settings) {
  validate(profile);
  const auto is_damped = [](const Layer& layer) { return layer.damping_ratio > 0.0; };
  if (std::any_of(profile.layers.begin(), profile.layers.end(), is_damped))
    validate(settings.damping);
  const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  require(positive(settings.time_step), "time step of the column", settings.time_step, "positive, in s");
  require(positive(settings.max_step), "longest step of the integrator", settings.max_step, "positive, in s");
  require(std::isfinite(settings.start_time), "start time of the column", settings.start_time, "finite");
  require(settings.relative_tolerance >= 1e-13 && settings.relative_tolerance <= 0.1, "relative tolerance",
          settings.relative_tolerance, "in [1e-13, 0.1]");
  require(positive(settings.absolute_tolerance), "absolute tolerance", settings.absolute_tolerance,
          "positive, in m/s");
}

enum class Wave { shear, dilation };

std::unique_ptr<OdePolarisation> polarisation(Wave wave, const Profile& profile,
                                              const OdeColumnSettings& settings,
                                              std::function<double(double)> input,
                                              std::function<double(double)> reference) {
  const auto modulus = [wave](const Elasticity& soil) {
    return wave == Wave::shear ? soil.shear_modulus() : soil.p_modulus();
  };
  const StaggeredGrid grid = staggered_grid(profile, settings.max_cell_size, settings.base);
  std::vector<OdeCell> cells;
  std::vector<OdeSoil::Cell> nonlinear;
  for (std::size_t e = 0; e < grid.mesh.elements(); ++e) {
    const Layer& layer = profile.layers[grid.mesh.element_layer[e]];
    const DampingCoefficients c = coefficients(settings.damping, layer.damping_ratio);
    cells.push_back({grid.mesh.length(e), layer.soil.density, modulus(layer.soil), c.alpha, c.beta,
                     relaxation(settings.damping, layer.damping_ratio)
                         .on_share(wave == Wave::shear ? 1.0 : layer.relaxing_share_p)});
    const auto backbone = shear_backbone(profile, grid.mesh.element_layer[e]);
    if (wave == Wave::shear && backbone)
      nonlinear.push_back({e, *backbone});
  }
  const double impedance = std::sqrt(profile.half_space.density * modulus(profile.half_space));
  return std::make_unique<OdePolarisation>(
      grid, std::move(cells), OdeBase{settings.base, impedance, std::move(input), std::move(reference)},
      OdeSoil(std::move(nonlinear)), settings);
}

} // namespace

OdeColumn::OdeColumn(const Profile& profile, const OdeColumnSettings& settings, InputVelocity input)
    : settings_(settings) {
  check(profile, settings);
  if (!input)
    throw std::invalid_argument("the column has no input motion");
  const auto reference = [input, base = settings.base, rise = rise_to_damped_soil(profile)](double time) {
    return reference_velocity(base, input, rise, time);
  };
  shear_ = polarisation(
      Wave::shear, profile, settings, [input](double time) { return input(time).x; },
      [reference](double time) { return reference(time).x; });
  dilation_ = polarisation(
      Wave::dilation, profile, settings, [input](double time) { return input(time).y; },
      [reference](double time) { return reference(time).y; });
  for (const Layer& layer : profile.layers)
    lateral_ratio_.push_back(layer.soil.lame() / layer.soil.p_modulus());
}

OdeColumn::~OdeColumn() = default;

double OdeColumn::time() const {
  return settings_.start_time + static_cast<double>(steps_) * settings_.time_step;
}

double OdeColumn::base_level() const {
  return shear_->mesh().node_y.front();
}

double OdeColumn::surface_level() const {
  return shear_->mesh().node_y.back();
}

void OdeColumn::step() {
  ++steps_;
  shear_->serve(time());
  dilation_->serve(time());
}

void OdeColumn::sample(std::span<const double> y, std::span<ColumnSample> samples) const {
  if (y.size() != samples.size()) {
    throw std::invalid_argument("number of samples is " + std::to_string(samples.size()) +
                                ", must be that of the levels, " + std::to_string(y.size()));
  }
  for (std::size_t i = 0; i < y.size(); ++i) {
    const auto side = from_below(y, i) ? ColumnMesh::Side::below : ColumnMesh::Side::above;
    const auto x = shear_->at(y[i], side);
    const auto v = dilation_->at(y[i], side);
    const double lateral = lateral_ratio_[x.layer];
    samples[i] = {.vx = x.velocity,
                  .vy = v.velocity,
                  .sxx = lateral * v.stress,
                  .syy = v.stress,
                  .sxy = x.stress,
                  .vx_rate = x.acceleration,
                  .vy_rate = v.acceleration,
                  .sxx_rate = lateral * v.stress_rate,
                  .syy_rate = v.stress_rate,
                  .sxy_rate = x.stress_rate,
                  .ux = x.displacement,
                  .uy = v.displacement,
                  .eyy = v.strain,
                  .gxy = x.strain};
  }
}

OdeStatistics OdeColumn::statistics() const {
  const OdeStatistics x = shear_->statistics();
  const OdeStatistics y = dilation_->statistics();
  return {x.steps + y.steps,
          x.rejections + y.rejections,
          x.convergence_failures + y.convergence_failures,
          x.right_hand_sides + y.right_hand_sides,
          x.implicit_sides + y.implicit_sides,
          x.jacobians + y.jacobians};
}

std::string OdeColumn::report() const {
  const OdeStatistics s = statistics();
  return fmt::format("{} steps, {} rejected, {} without convergence, {} + {} right-hand sides, {} Jacobians",
                     s.steps, s.rejections, s.convergence_failures, s.right_hand_sides, s.implicit_sides,
                     s.jacobians);
}

} // namespace tremolo::freefield
