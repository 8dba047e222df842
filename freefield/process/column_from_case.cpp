#include "freefield/process/column_from_case.hpp"

#include "freefield/base_motion.hpp"
#include "freefield/marched/base_impedance.hpp"
#include "freefield/marched/marched_column.hpp"
#include "freefield/ode/ode_column.hpp"
#include "freefield/process/incident_input.hpp"
#include "freefield/twophase/two_phase_column.hpp"
#include "scene/plan/layers.hpp"
#include "scene/plan/wave/motion.hpp"
#include "scene/plan/wave/slowness.hpp"
#include "scene/soils/viscous_damping.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <fmt/format.h>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tremolo::freefield {

namespace {

/// Share of central differences' stability limit that a column takes if the case names no step.
constexpr double fraction_of_limit = 0.8;
/// The column at an angle errs the less, the nearer to the limit its steps are.
constexpr double fraction_at_an_angle = 0.9;
/// Factor by which the soil's stiffness may grow: if it depends on pressure, it may double in dilation.
double stiffening(const Profile& profile) {
  const auto follows = [](const Layer& layer) {
    return layer.law && materials::traits(*layer.law).follows_pressure;
  };
  return std::ranges::any_of(profile.layers, follows) ? 2.0 : 1.0;
}

materials::Law with_constants(materials::Law law, const materials::Elasticity& elastic) {
  std::visit([&](auto& known) { known.elastic = elastic; }, law);
  return law;
}

/// A column's treatment of soil below the water table.
enum class Water { in_total_stress, two_phases };

/// A layer as a column takes it: in two phases the skeleton and its pores, otherwise grains and water
/// together.
Layer layer_from_case(const scene::Case& scene, const scene::Layer& layer, double element_size, Water water) {
  Layer made{layer.thickness, layer.elastic, layer.damping};
  made.relaxing_share_p = scene::relaxing_share_p(scene, layer);
  if (!layer.soil)
    return made;
  const scene::Soil& soil = scene.soils[*layer.soil];
  if (water == Water::two_phases && layer.wet) {
    made.soil = materials::elasticity(soil.column_law); // with the saturated density
    made.pores = soil.pores;
  }
  if (materials::traits(soil.column_law).response == materials::Response::elastic)
    return made;
  made.law = soil.softening_size
                 ? materials::for_cell_size(soil.column_law, element_size, *soil.softening_size)
                 : soil.column_law;
  if (scene.water)
    made.law = with_constants(std::move(*made.law), made.soil);
  return made;
}

/// The base of the column: that of the model where it lies below the layers, unless the motion is that of the
/// top of the half-space.
Profile profile_from_case(const scene::Case& scene, const scene::SourceProcess& source, double element_size,
                          Water water) {
  Profile profile{source.surface, {}, scene.halfspace};
  if (scene.water)
    profile.water = WaterTable{scene::water_level(scene, source), scene.water->fluid};
  profile.gravity = scene.gravity ? scene.gravity->acceleration : 0.0;
  for (const scene::Layer& layer : scene::layers(scene, source))
    profile.layers.push_back(layer_from_case(scene, layer, element_size, water));
  const bool has_model = scene.mesh.size > 0.0;
  const double missing = has_model ? profile.base_level() - scene.mesh.box.y_min : 0.0;
  if (missing > 0.0 && scene.motion.kind != motion::MotionKind::within)
    profile.layers.push_back({missing, scene.halfspace, 0.0});
  return profile;
}

Damping damping_from_case(const scene::Case& scene) {
  if (scene.damping.model == scene::DampingModel::rayleigh)
    return RayleighDamping{scene.damping.frequencies[0], scene.damping.frequencies[1]};
  if (scene.damping.model == scene::DampingModel::constant)
    return ConstantDamping{scene.damping.reference_hz.value_or(1.0), scene.damping.band};
  return KelvinVoigtDamping{scene.damping.reference_hz.value_or(1.0)}; // without it no layer has a ratio
}

/// At oblique incidence the base moves as v(t - s x).
ColumnInput rigid_input(const scene::Case& scene, const scene::MotionInput& wave, double x) {
  const scene::Motion motion = scene::motion(wave);
  const bool shear = wave.wave == scene::Wave::sv;
  const double delay = scene::slowness_x(scene, wave) * (x - wave.reference.x);
  return {BaseKind::rigid,
          [motion, shear, delay](double time) {
            const double v = motion.velocity(time - delay);
            return shear ? Velocity{v, 0.0} : Velocity{0.0, v};
          },
          motion.begin() + delay, motion.highest_frequency()};
}

ColumnInput input_from_case(const scene::Case& scene, const scene::SourceProcess& source, double x,
                            double base) {
  if (scene.motion.kind != motion::MotionKind::within)
    return incident_input(scene, source, x, base);
  ColumnInput input = rigid_input(scene, scene.motion, x);
  return scene.vertical ? sum(std::move(input), rigid_input(scene, *scene.vertical, x)) : input;
}

/// The step that the case gives, or a fraction of the limit of central differences, s.
/// @param limit  (growth of the soil's stiffness) -> that limit, s
template <typename Limit>
double time_step(const scene::Case& scene, const Profile& profile, double fraction, const Limit& limit) {
  if (!scene.fe.dt)
    return fraction * limit(stiffening(profile));
  if (const double most = limit(1.0); !(*scene.fe.dt < most))
    throw std::invalid_argument(fmt::format("[fe] 'dt' = {} s, must be below {:.4g} s, the limit of central "
                                            "differences for this column; without 'dt' it chooses its own",
                                            *scene.fe.dt, most));
  return *scene.fe.dt;
}

/// Settings common to all columns of finite elements.
template <typename Settings>
Settings element_settings(const scene::Case& scene, const ColumnInput& input) {
  Settings settings;
  settings.max_element_size = scene.fe.element_size;
  settings.damping = damping_from_case(scene);
  settings.base = input.base;
  settings.clock = scene.clock();
  return settings;
}

/// Any soil, and water with velocities of its own.
std::unique_ptr<Column> two_phase_column(const scene::Case& scene, const Profile& profile,
                                         const ColumnInput& input, double start) {
  auto settings = element_settings<TwoPhaseSettings>(scene, input);
  settings.time_step = time_step(scene, profile, fraction_of_limit, [&](double growth) {
    return two_phase_step_limit(profile, settings.max_element_size, settings.damping, growth);
  });
  settings.start_time = start - 2.0 * settings.time_step;
  return std::make_unique<TwoPhaseColumn>(profile, settings, input.velocity);
}

/// Any soil and its water under a wave at an angle.
std::unique_ptr<Column> marched_column(const scene::Case& scene, const Profile& profile,
                                       const ColumnInput& input, double start) {
  auto settings = element_settings<MarchedSettings>(scene, input);
  settings.slowness_x = scene::slowness_x(scene, scene.motion);
  settings.time_step = time_step(scene, profile, fraction_at_an_angle, [&](double growth) {
    return marched_step_limit(profile, settings.max_element_size, settings.slowness_x, settings.damping,
                              growth);
  });
  settings.start_time = start - 2.0 * settings.time_step;
  return std::make_unique<MarchedColumn>(profile, settings, input.velocity);
}

OdeMethod method_of(scene::OdeMethod method) {
  switch (method) {
  case scene::OdeMethod::adams:
    return OdeMethod::adams;
  case scene::OdeMethod::bdf:
    return OdeMethod::bdf;
  case scene::OdeMethod::erk:
    return OdeMethod::explicit_runge_kutta;
  case scene::OdeMethod::imex:
    return OdeMethod::imex;
  }
  throw std::logic_error("an integration method without a name");
}

std::unique_ptr<Column> ode_column(const scene::Case& scene, const Profile& profile, const ColumnInput& input,
                                   double start) {
  OdeColumnSettings settings;
  settings.max_cell_size = scene.ode.cell_size;
  settings.method = method_of(scene.ode.method);
  settings.relative_tolerance = scene.ode.relative_tolerance;
  settings.absolute_tolerance = scene.ode.absolute_tolerance;
  settings.damping = damping_from_case(scene);
  settings.base = input.base;
  // Motions end in practice at a third of their highest frequency: cubic interpolation between the states
  // then errs by 5e-6.
  constexpr double states_per_period = 10.0;
  settings.time_step = 1.0 / (states_per_period * input.highest_frequency);
  settings.max_step = 1.0 / input.highest_frequency;
  settings.start_time = start - 2.0 * settings.time_step;
  return std::make_unique<OdeColumn>(profile, settings, input.velocity);
}

} // namespace

std::unique_ptr<Column> column_from_case(const scene::Case& scene, const scene::SourceProcess& source,
                                         double x_line, double needed_from) {
  const auto made = [&](double size, auto make, Water water) {
    const Profile profile = profile_from_case(scene, source, size, water);
    const ColumnInput input = input_from_case(scene, source, x_line, profile.base_level());
    return make(scene, profile, input, std::min(needed_from, input.begin));
  };
  switch (source.field.model) {
  case scene::SourceModel::fe:
    return made(scene.fe.element_size, scene.motion.angle_deg == 0.0 ? two_phase_column : marched_column,
                Water::two_phases);
  case scene::SourceModel::ode:
    return made(scene.ode.cell_size, ode_column, Water::in_total_stress);
  default:
    throw std::invalid_argument(fmt::format("model \"{}\" is not a column", scene::name(source.field.model)));
  }
}

namespace {

/// The motion that one wave alone gives the rock.
RockMotion rock_motion(const scene::Case& scene, const scene::MotionInput& wave, const Profile& profile,
                       const wavefield::LayeredHalfSpace& ground) {
  const double slowness = scene::slowness_x(scene, wave);
  if (wave.kind == motion::MotionKind::within)
    return [slowness, base = rigid_input(scene, wave, 0.0).velocity](double x, double time) {
      return base(time - slowness * x);
    };
  const BaseImpedance base = base_impedance(scene.halfspace, slowness);
  const Eigen::Matrix2d outcrop = base.outgoing.inverse() * base.incident;
  return [outcrop, rise = rise_to_damped_soil(profile, slowness),
          input = incident_input(wave, ground, 0.0, profile.base_level()).velocity,
          slowness](double x, double time) {
    const double here = time - slowness * x;
    const Eigen::Vector2d v = outcrop * Eigen::Vector2d(input(here - rise.x).x, input(here - rise.y).y);
    return Velocity{v.x(), v.y()};
  };
}

} // namespace

RockMotion rock_motion(const scene::Case& scene, const scene::SourceProcess& source) {
  const Profile profile = profile_from_case(scene, source, scene.fe.element_size, Water::two_phases);
  const auto ground = wavefield::ground_from_case(scene, scene::layers(scene, source));
  std::vector<RockMotion> waves;
  for (const scene::MotionInput* wave : scene.plane_waves())
    waves.push_back(rock_motion(scene, *wave, profile, ground));
  return [waves](double x, double time) {
    Velocity sum;
    for (const RockMotion& wave : waves) {
      const Velocity v = wave(x, time);
      sum = {sum.x + v.x, sum.y + v.y};
    }
    return sum;
  };
}

} // namespace tremolo::freefield
