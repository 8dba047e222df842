#include "scene/plan/plan.hpp"

#include "mpm_domain/spec/bytes.hpp"
#include "scene/plan/boundary/springs.hpp"
#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/layers.hpp"
#include "scene/plan/output/intervals.hpp"
#include "scene/plan/output/output_size.hpp"
#include "scene/plan/sources.hpp"
#include "scene/plan/step/step_cost.hpp"
#include "scene/plan/wet_soils.hpp"
#include "scene/soils/domain_soils.hpp"
#include "scene/soils/viscous_damping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tremolo::scene {

namespace {

constexpr double pressure_bytes = 24.0; // while pressures are found

/// The soils of the domain whose law has a trait: "soil 'sand', soil 'clay'"; empty where there are none.
template <typename Trait>
std::string soils_with(const Case& scene, Trait materials::Traits::*trait, Trait value) {
  std::string text;
  for (const Soil& soil : one_of_each_name(domain_soils(scene)))
    if (materials::traits(soil.law).*trait == value)
      text += fmt::format("{}soil '{}'", text.empty() ? "" : ", ", soil.name);
  return text;
}

std::string soils_that_are(const Case& scene, materials::Response response) {
  return soils_with(scene, &materials::Traits::response, response);
}

std::string rest_text(const Case& scene) {
  std::string rests;
  for (const TimedStage& stage : scene.timed)
    if (stage.rest)
      rests += fmt::format("{} {} from {:g} to {:g} s", rests.empty() ? "[[stage]]" : ",", stage.name,
                           stage.start, stage.end());
  if (rests.empty())
    return "no [[stage]] of kind rest";
  const std::string soils = soils_with(scene, &materials::Traits::reconsolidates, true);
  return fmt::format("{}: {}", rests,
                     soils.empty() ? "no soil of the domain changes its law in the rest" : soils);
}

/// "soil 'sand' 2 % at 3 Hz"; empty where none is damped.
std::string soils_with_damping(const Case& scene) {
  std::string text;
  for (const Soil& soil : one_of_each_name(domain_soils(scene)))
    if (const double time = damping_time(scene.damping, soil.damping); time > 0.0)
      text += fmt::format("{}soil '{}' {:.3g} % at {:.3g} Hz", text.empty() ? "" : ", ", soil.name,
                          100.0 * soil.damping, soil.damping / (std::numbers::pi * time));
  return text;
}

/// "soil 'sand' 5 %, by 4 mechanisms within 1.3 % of it over 0.1 to 25 Hz"; empty where none is damped so.
std::string soils_with_constant_damping(const Case& scene) {
  if (scene.damping.model != DampingModel::constant)
    return {};
  std::string text;
  for (const Soil& soil : one_of_each_name(domain_soils(scene)))
    if (soil.damping > 0.0)
      text += fmt::format("soil '{}' {:.3g} %, ", soil.name, 100.0 * soil.damping);
  const materials::DampingBand& band = scene.damping.band;
  return text.empty() ? text
                      : fmt::format("{}by {} mechanisms within {:.2g} % of it over {:g} to {:g} Hz", text,
                                    band.mechanisms, 100.0 * materials::worst_error_of_ratio(band),
                                    band.lowest_hz, band.highest_hz);
}

bool any_softens(const Case& scene) {
  return std::ranges::any_of(domain_soils(scene),
                             [](const Soil& soil) { return materials::traits(soil.law).softening > 0.0; });
}

/// Largest number of state variables of a soil.
double state_size(const Case& scene) {
  std::size_t largest = 0;
  for (const Soil& soil : domain_soils(scene))
    largest = std::max(largest, materials::state_variables(soil.law).size());
  return static_cast<double>(largest);
}

/// Bytes of a particle that has some traits, besides its law's state.
double particle_bytes(mpm_domain::ParticleTraits traits) {
  return static_cast<double>(mpm_domain::bytes_per_particle(traits));
}

/// The soils of the domain below the water table with a choice of drainage, as soils_that_are().
std::string soils_drained_as(const Case& scene, materials::Drainage drainage) {
  std::string text;
  if (!scene.water)
    return text;
  const auto below = soils_below_table(scene);
  for (const Soil& soil : one_of_each_name(domain_soils(scene)))
    if (soil.pores && soil.pores->drainage == drainage &&
        std::ranges::any_of(below, [&](const Soil& other) { return other.name == soil.name; }))
      text += fmt::format("{}soil '{}'", text.empty() ? "" : ", ", soil.name);
  return text;
}

/// Why there is pore pressure, or none.
std::string pressure_text(const Case& scene, const std::string& flowing, const std::string& undrained) {
  if (!scene.water)
    return "no [water]";
  if (flowing.empty() && undrained.empty())
    return "no soil of the domain below the water table but drained";
  const std::string_view both = flowing.empty() || undrained.empty() ? "" : ", ";
  if (!scene.water->is_level())
    return fmt::format("{}{}{} below water: {}", flowing, both, undrained, table_text(*scene.water));
  return fmt::format("{}{}{} below the table at y = {} m", flowing, both, undrained, scene.water->level);
}

std::string listed(const std::vector<SourceProcess>& sources) {
  std::string text;
  for (const SourceProcess& source : sources)
    text += fmt::format("{}{} '{}'", text.empty() ? "" : ", ", program(source.field), source.name);
  return text;
}

std::string subcycling_text(const Case& scene) {
  return scene.time.subcycle ? "[time] subcycle = true: a step for each level of the mesh, the boundary "
                               "exchanged once in the coarsest's"
                             : "[time] subcycle = false: one step for all levels";
}

std::string sides_text(Sides sides) {
  switch (sides) {
  case Sides::free_field:
    break;
  case Sides::container:
    return "[boundary] sides = \"container\": smooth walls that move with the shaking table";
  case Sides::periodic:
    return "[boundary] sides = \"periodic\": the grid is wrapped, waves that leave at one side enter at the "
           "other";
  case Sides::periodic_springs:
    return "[boundary] sides = \"periodic_springs\": springs between the particles of both sides, rho h/(4 "
           "dt2) "
           "stiff; an error of first order in the cell size, which \"periodic\" has not";
  }
  return "[boundary] sides = \"free_field\"";
}

std::vector<Effect> plan_effects(const Case& scene, const std::vector<SourceProcess>& sources,
                                 const std::vector<PlannedStructure>& structures,
                                 const std::vector<PlannedLining>& linings) {
  const bool apic = scene.time.transfer == Transfer::apic;
  const bool deforming = scene.mesh.particle_boxes == ParticleBoxes::deforming;
  const std::string plastic_soils = soils_that_are(scene, materials::Response::plastic);
  const std::string hysteretic_soils = soils_that_are(scene, materials::Response::hysteretic);
  const std::string liquefying_soils = soils_that_are(scene, materials::Response::cyclic_mobility);
  const bool plastic = !plastic_soils.empty();
  const bool hysteretic = !hysteretic_soils.empty();
  const bool liquefies = !liquefying_soils.empty();
  const bool softening = any_softens(scene);
  const bool by_cell = scene.mesh.dilatation == Dilatation::cell && (plastic || hysteretic || liquefies);
  const auto& [sides, left, right, base] = scene.boundary;
  const bool layered = left.absorber == Absorber::matched_layer ||
                       right.absorber == Absorber::matched_layer || base.absorber == Absorber::matched_layer;
  const std::string springs = springs_text(scene);
  const double bare_bytes = particle_bytes({});
  const double affine_bytes = particle_bytes({.affine = true}) - bare_bytes;
  const double box_bytes = particle_bytes({.own_boxes = true}) - bare_bytes;
  const bool sharp = scene.mesh.dispersion == Dispersion::reduced;
  const double sharp_bytes = particle_bytes({.bilinear = true}) - bare_bytes;
  const std::string damped_soils = soils_with_damping(scene);
  const bool damped = !damped_soils.empty();
  const double damped_bytes = particle_bytes({.damped = true}) - bare_bytes;
  const std::string relaxing_soils = soils_with_constant_damping(scene);
  const bool relaxes = !relaxing_soils.empty();
  const auto mechanisms = static_cast<std::size_t>(scene.damping.band.mechanisms);
  const double relaxing_bytes =
      damped_bytes + static_cast<double>(mpm_domain::relaxation_fields(mechanisms).size() * sizeof(double));
  const std::string flowing_soils = soils_drained_as(scene, materials::Drainage::coupled);
  const std::string undrained_soils = soils_drained_as(scene, materials::Drainage::undrained);
  const bool flows = !flowing_soils.empty();
  const bool wet = flows || !undrained_soils.empty();
  const double wet_bytes = particle_bytes({.wet = true}) - bare_bytes + pressure_bytes;
  const double flow_bytes = particle_bytes({.affine = apic, .wet = true, .flowing = true}) -
                            particle_bytes({.affine = apic, .wet = true});
  const bool seeps = scene.water && !scene.water->is_level();
  const double head_bytes = particle_bytes({.seeping = true}) - bare_bytes;
  return {
      {"soil skeleton", true, "always: GIMP particles, plane strain", bare_bytes, cost::skeleton_ns},
      {"affine velocity", apic, fmt::format("[time] transfer = \"{}\"", name(scene.time.transfer)),
       apic ? affine_bytes : 0.0, 0.0},
      {"deforming boxes", deforming,
       fmt::format("[mesh] particle_boxes = \"{}\"", name(scene.mesh.particle_boxes)),
       deforming ? box_bytes : 0.0, deforming ? cost::boxes_ns : 0.0},
      {"reduced dispersion", sharp, fmt::format("[mesh] dispersion = \"{}\"", name(scene.mesh.dispersion)),
       sharp ? sharp_bytes : 0.0, sharp ? cost::dispersion_ns : 0.0},
      {"gravity", scene.gravity.has_value(),
       scene.gravity ? fmt::format("[[stage]] gravity, {} m/s2, then static tractions on the boundary faces",
                                   scene.gravity->acceleration)
                     : "no [[stage]] of kind gravity"},
      {"plasticity", plastic, plastic ? plastic_soils : "no soil has a yield surface",
       plastic && !hysteretic && !liquefies ? 8.0 * state_size(scene) : 0.0,
       cost::law_ns(scene, materials::Response::plastic)},
      {"hysteresis", hysteretic,
       hysteretic ? hysteretic_soils : "no soil has loops from the smallest strain on",
       hysteretic && !liquefies ? 8.0 * state_size(scene) : 0.0,
       cost::law_ns(scene, materials::Response::hysteretic)},
      {"cyclic mobility", liquefies, liquefies ? liquefying_soils : "no soil is sand that liquefies",
       liquefies ? 8.0 * state_size(scene) : 0.0, cost::law_ns(scene, materials::Response::cyclic_mobility)},
      {"reconsolidation", scene.fastest_rest() != nullptr, rest_text(scene)},
      {"mean dilatation", by_cell,
       by_cell ? "soil that yields sees the mean change of volume of its cell"
               : "no soil yields, or [mesh] dilatation = \"particle\"",
       by_cell ? 40.0 : 0.0, by_cell ? cost::dilatation_ns : 0.0},
      {"strain softening", softening,
       softening ? "a [soil] with softening > 0" : "no soil has softening > 0"},
      {"oblique incidence", scene.is_oblique(),
       fmt::format("[motion] angle_deg = {}", scene.motion.angle_deg) +
           (scene.vertical ? fmt::format(", [motion.vertical] angle_deg = {}", scene.vertical->angle_deg)
                           : "")},
      {"free field", true, "[boundary]: " + listed(sources)},
      {"periodic sides", sides == Sides::periodic || sides == Sides::periodic_springs, sides_text(sides)},
      {"shaking table", scene.boundary.base_is_rigid(),
       scene.boundary.base_is_rigid() ? "[boundary.base] model = \"shaking_table\", " + sides_text(sides)
                                      : "the base of the model lies on ground"},
      {"matched layers", layered,
       layered ? "[boundary]: absorber = \"matched_layer\""
               : "no side of [boundary] has absorber = \"matched_layer\""},
      {"springs", !springs.empty(),
       springs.empty() ? "no dashpots, or [boundary] spring = false" : "beside the dashpots, " + springs},
      {"material damping", scene.damping.model != DampingModel::none,
       fmt::format("[damping] model = \"{}\"", name(scene.damping.model))},
      {"viscous damping", damped,
       damped ? damped_soils + ", in the domain; shortens the step"
              : "no soil of the domain has viscous damping",
       damped ? damped_bytes : 0.0, damped ? cost::damping_ns : 0.0},
      {"constant damping", relaxes,
       relaxes ? relaxing_soils + ", in the domain" : "no soil of the domain is damped by mechanisms",
       relaxes ? relaxing_bytes : 0.0, relaxes ? cost::mechanism_ns * scene.damping.band.mechanisms : 0.0},
      {"pore pressure", wet, pressure_text(scene, flowing_soils, undrained_soils), wet ? wet_bytes : 0.0,
       wet ? cost::pressure_ns : 0.0},
      {"flow of pore water", flows,
       flows ? flowing_soils + ": water has a velocity of its own" : "no soil of the domain lets water flow",
       flows ? flow_bytes : 0.0, flows ? cost::flow_ns : 0.0},
      {"seepage force", seeps,
       seeps ? table_text(*scene.water) : "no [water] line or seepage: one head everywhere",
       seeps ? head_bytes : 0.0, seeps ? cost::seepage_ns : 0.0},
      {"contact", !structures.empty(), contact_text(structures)},
      {"linings", !linings.empty(), linings_effect_text(linings)},
      {"props", !scene.props.empty(), props_effect_text(scene)},
      {"sub-cycling", scene.time.subcycle, subcycling_text(scene)},
      {"run-ahead exchange", scene.coupling.mode == ExchangeMode::window,
       fmt::format("[coupling] mode = \"{}\"", name(scene.coupling.mode))},
  };
}

} // namespace

std::vector<std::string> linearised_soils(const Case& scene, const SourceProcess& source) {
  if (!in_frequency_domain(source.field.model))
    return {};
  const bool iterated = traits(source.field.model).soil == SoilTreatment::equivalent_linear;
  const auto& ground = layers(scene, source);
  std::vector<std::string> notes;
  for (std::size_t i = 0; i < scene.soils.size(); ++i) {
    const Soil& soil = scene.soils[i];
    const bool known =
        materials::traits(soil.law).response == materials::Response::elastic || (iterated && soil.curves);
    if (known || std::ranges::find(ground, std::optional(i), &Layer::soil) == ground.end())
      continue;
    auto note = fmt::format("'{}': model \"{}\" takes layers of soil '{}' as linear elastic", source.name,
                            name(source.field.model), soil.name);
    if (notes.empty() || notes.back() != note) // slices of one soil have its name
      notes.push_back(std::move(note));
  }
  return notes;
}

/// Bytes of a node.
double node_bytes(const Case& scene) {
  const bool flows = !soils_drained_as(scene, materials::Drainage::coupled).empty();
  return static_cast<double>(
      mpm_domain::bytes_per_node({.wet = scene.water.has_value(),
                                  .flowing = flows,
                                  .sharp = scene.mesh.dispersion == Dispersion::reduced,
                                  .seeping = scene.water && !scene.water->is_level()}));
}

Plan plan(const Case& scene) {
  Plan result;
  result.sources = plan_sources(scene);
  result.structures = plan_structures(scene);
  result.linings = plan_linings(scene);
  result.props = plan_props(scene);
  result.effects = plan_effects(scene, result.sources, result.structures, result.linings);
  result.base = describe_base(scene, result.sources);
  result.levels = levels(scene);
  result.limit = step_limit(scene, result.levels);
  result.critical_dt = result.limit.dt;
  result.dt = scene.time.dt.value_or(scene.time.fraction * result.critical_dt);
  result.steps = std::llround(std::ceil(scene.end() / result.dt));

  double particles = 0.0;
  double cells = 0.0;
  double nodes = 0.0;
  double updates = 0.0;
  double steps = 1.0; // of a level in one of the coarsest
  for (Level& level : result.levels) {
    level.dt = result.dt / steps;
    updates += steps * level.particles;
    if (scene.time.subcycle)
      steps *= 2.0;
    particles += level.particles;
    cells += level.cells;
    nodes += level.nodes;
  }
  result.particles = static_cast<std::size_t>(particles);
  result.cells = static_cast<std::size_t>(cells);

  double bytes = 0.0;
  double ns = 0.0;
  for (const Effect& effect : result.effects) {
    bytes += effect.bytes_per_particle;
    ns += effect.ns_per_particle_step;
  }
  result.memory_bytes = particles * bytes + nodes * node_bytes(scene);
  double step_ns = updates * ns + cost::boundary_ns(scene);
  for (const PlannedStructure& structure : result.structures) {
    result.memory_bytes += structure.bytes;
    step_ns += structure.contact_nodes * contact_node_cost_ns;
  }
  for (const PlannedLining& lining : result.linings)
    step_ns += lining.segments * lining_segment_cost_ns;
  result.estimated_time = static_cast<double>(result.steps) * step_ns * 1e-9;
  result.frames = most_frames(scene, result.dt);
  result.output_bytes = output_bytes(scene, result);
  return result;
}

} // namespace tremolo::scene
