#include "mpm_domain/process/column_from_case.hpp"

#include "freefield/process/column_from_case.hpp"
#include "freefield/process/incident_input.hpp"
#include "mpm_domain/process/spec_from_case.hpp"
#include "scene/plan/layers.hpp"
#include "scene/soils/viscous_damping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

/// Adds a layer of the column between two levels.
void add_layer(Spec& spec, const materials::Law& law, const std::optional<materials::PoreSpace>& pores,
               const scene::Case& scene, double ratio, double top, double bottom) {
  const double left = spec.box.x_min;
  const double right = spec.box.x_max;
  spec.regions.push_back({spec.soils.size(), {{left, bottom}, {right, bottom}, {right, top}, {left, top}}});
  spec.soils.push_back({std::to_string(spec.soils.size() + 1),
                        law,
                        {},
                        scene::damping_time(scene.damping, ratio),
                        pores,
                        scene::relaxation(scene.damping, ratio),
                        scene::mass_damping(scene, ratio)});
}

Spec column_spec(const scene::Case& scene, const scene::SourceProcess& source) {
  Spec spec = spec_from_case(scene, 1);
  spec.refine.clear();
  spec.scheme.subcycle = false;
  spec.box.x_max = spec.box.x_min + spec.cell_size;
  spec.box.y_max = source.surface;
  if (spec.water)
    spec.water = {.level = scene::water_level(scene, source), .fluid = spec.water->fluid};
  spec.soils.clear();
  spec.regions.clear();
  spec.structures.clear();
  spec.sections.clear();
  spec.props.clear();
  spec.linings.clear();
  spec.loads.clear();
  spec.structure_loads.clear();
  spec.earthworks.clear();
  spec.matched_sides.clear();
  spec.springs.clear();
  const double half_space = scene::base_level(source.surface, scene::layers(scene, source));
  spec.box.y_min -=
      spec.cell_size * std::ceil(std::max(0.0, spec.box.y_min - half_space) / spec.cell_size - 1e-9);
  double top = source.surface;
  for (const scene::Layer& layer : scene::layers(scene, source)) {
    const scene::Soil* const soil = layer.soil ? &scene.soils[*layer.soil] : nullptr;
    add_layer(spec, soil != nullptr ? soil->law : materials::LinearElastic{layer.elastic},
              soil != nullptr ? soil->pores : std::nullopt, scene, layer.damping, top, top - layer.thickness);
    top -= layer.thickness;
  }
  if (top > spec.box.y_min)
    add_layer(spec, materials::LinearElastic{scene.halfspace}, std::nullopt, scene, 0.0, top, spec.box.y_min);
  return spec;
}

/// v_ref of the ground of a source; zero where nothing is damped in proportion to mass, and on a shaking
/// table, from which the domain is seen.
std::function<Vector(double, double)> rock_motion_below(const scene::Case& scene,
                                                        const scene::SourceProcess& source) {
  if (scene.boundary.base_is_rigid() || !(scene::mass_damping(scene, 1.0) > 0.0))
    return [](double, double) { return Vector{}; };
  return [motion = freefield::rock_motion(scene, source)](double x, double time) {
    const freefield::Velocity v = motion(x, time);
    return Vector{v.x, v.y};
  };
}

/// Velocity and stress of the incident wave at the base: sxy = -rho c_s vx, syy = -rho c_p vy, sxx = lambda/M
/// syy.
IncidentWave incident_wave(const materials::Elasticity& ground, const freefield::InputVelocity& velocity) {
  return [ground, velocity](double time) -> eq6::FreeField {
    const freefield::Velocity v = velocity(time);
    const double syy = -ground.density * ground.p_wave_speed() * v.y;
    return {{v.x, v.y},
            {ground.lame() / ground.p_modulus() * syy, syy, -ground.density * ground.s_wave_speed() * v.x}};
  };
}

class SampledColumn final : public freefield::Column {
public:
  explicit SampledColumn(PeriodicColumnSpec spec)
      : width_(spec.domain.box.x_max - spec.domain.box.x_min), column_(std::move(spec)) {}

  void step() override { column_.step(); }
  double time() const override { return column_.time(); }
  double time_step() const override { return column_.time_step(); }
  double base_level() const override { return column_.levels().front(); }
  double surface_level() const override { return column_.levels().back(); }
  void sample(std::span<const double> y, std::span<freefield::ColumnSample> samples) const override;
  std::string report() const override;

private:
  freefield::ColumnSample at(double y) const;

  double width_; ///< m
  PeriodicColumn column_;
};

std::string SampledColumn::report() const {
  std::string text = fmt::format("{} rows of particles, {} steps of {:.3g} s or parts of it",
                                 column_.levels().size() - 2, column_.steps(), time_step());
  constexpr double nothing = 1e-6; // J/m2: a micrometre a second in a thousand metres of soil
  const EnergyLedger& energy = column_.energy();
  const double given = energy.input + energy.dashpots + energy.static_ + energy.gravity;
  if (given > nothing * width_)
    text += fmt::format("; of the energy given, {:.4g} J/m2, {:.2g} % is missing, and {:.2g} % went between "
                        "particles and grid",
                        given / width_, 100.0 * std::abs(energy.residual()) / given,
                        100.0 * std::abs(energy.transfer) / given);
  return text;
}

void SampledColumn::sample(std::span<const double> y, std::span<freefield::ColumnSample> samples) const {
  constexpr double rounding = 1e-6; // m
  if (y.size() != samples.size())
    throw std::invalid_argument("a column needs one sample a level");
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (!(y[i] >= base_level() - rounding && y[i] <= surface_level() + rounding))
      throw std::invalid_argument(fmt::format("level y = {} m is outside the column, {} to {} m", y[i],
                                              base_level(), surface_level()));
    samples[i] = at(y[i]);
  }
}

freefield::ColumnSample SampledColumn::at(double y) const {
  const std::vector<double>& levels = column_.levels();
  const auto found = std::upper_bound(levels.begin() + 1, levels.end() - 1, y);
  const auto above = static_cast<std::size_t>(found - levels.begin());
  const ColumnPoint& a = column_.points()[above - 1];
  const ColumnPoint& b = column_.points()[above];
  const double s = (y - levels[above - 1]) / (levels[above] - levels[above - 1]);
  const auto join = [s](double below, double over) { return below + s * (over - below); };
  return {.vx = join(a.velocity.x, b.velocity.x),
          .vy = join(a.velocity.y, b.velocity.y),
          .sxx = join(a.stress.xx, b.stress.xx),
          .syy = join(a.stress.yy, b.stress.yy),
          .sxy = join(a.stress.xy, b.stress.xy),
          .vx_rate = join(a.acceleration.x, b.acceleration.x),
          .vy_rate = join(a.acceleration.y, b.acceleration.y),
          .sxx_rate = join(a.stress_rate.xx, b.stress_rate.xx),
          .syy_rate = join(a.stress_rate.yy, b.stress_rate.yy),
          .sxy_rate = join(a.stress_rate.xy, b.stress_rate.xy),
          .ux = join(a.displacement.x, b.displacement.x),
          .uy = join(a.displacement.y, b.displacement.y),
          .eyy = join(a.eyy, b.eyy),
          .gxy = join(a.gxy, b.gxy),
          .pore_pressure = column_.pore_pressure_at(y)};
}

} // namespace

PeriodicColumnSpec periodic_column_spec(const scene::Case& scene, const scene::SourceProcess& source,
                                        double x_line) {
  if (!(scene.mesh.size > 0.0))
    throw std::invalid_argument(
        fmt::format("{}: model \"mpm\" has the cells of the domain: [mesh] size and box are needed",
                    scene.file.string()));
  Spec spec = column_spec(scene, source);
  spec.rock_motion = rock_motion_below(scene, source);
  const auto input = freefield::incident_input(scene, source, x_line, spec.box.y_min);
  auto incident = incident_wave(scene.halfspace, input.velocity);
  return {spec, scene.halfspace, std::move(incident), input.begin, scene.time.dt};
}

std::function<Vector(double, double)> rock_motion(const scene::Case& scene, const scene::Plan& plan) {
  const auto side = scene.boundary.has_lateral_fields() ? scene::Side::left : scene::Side::base;
  return rock_motion_below(scene, scene::source_of(plan, side));
}

std::unique_ptr<freefield::Column> column_from_case(const scene::Case& scene,
                                                    const scene::SourceProcess& source, double x_line,
                                                    double needed_from) {
  PeriodicColumnSpec spec = periodic_column_spec(scene, source, x_line);
  spec.start_time = std::min(spec.start_time, needed_from);
  return std::make_unique<SampledColumn>(std::move(spec));
}

} // namespace tremolo::mpm_domain
