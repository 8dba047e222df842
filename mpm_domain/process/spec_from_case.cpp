#include "mpm_domain/process/spec_from_case.hpp"

#include "mesh/cell_size.hpp"
#include "scene/plan/boundary/springs.hpp"
#include "scene/plan/layers.hpp"
#include "scene/plan/lining/beam_outline.hpp"
#include "scene/plan/section/section_cuts.hpp"
#include "scene/plan/stages/stages.hpp"
#include "scene/plan/structures.hpp"
#include "scene/soils/viscous_damping.hpp"

#include <algorithm>
#include <iterator>
#include <variant>

namespace tremolo::mpm_domain {

namespace {

/// Softening goes with the size of the cells that it happens in.
std::vector<materials::Law> finer_laws(const scene::Soil& soil, const scene::Mesh& mesh) {
  if (!soil.softening_size || mesh.refine.empty())
    return {};
  const int finest = std::ranges::max(mesh.refine, {}, &scene::Refinement::level).level;
  std::vector<materials::Law> laws;
  for (int level = 1; level <= finest; ++level)
    laws.push_back(
        materials::for_cell_size(soil.law, mesh::cell_size(mesh.size, level), *soil.softening_size));
  return laws;
}

GroundWater copy_of(const scene::GroundWater& water) {
  GroundWater copy{
      .level = water.level, .fluid = water.fluid, .line = water.line, .still_wet = water.still_wet};
  if (water.seepage)
    copy.seepage = {water.seepage->left, water.seepage->right};
  return copy;
}

std::optional<GroundWater> water_of(const std::optional<scene::GroundWater>& water) {
  return water ? std::optional(copy_of(*water)) : std::nullopt;
}

/// Friction and adhesion against each soil.
template <class Body>
void copy_contact(const std::vector<scene::SoilContact>& soils, Body& copy) {
  for (const scene::SoilContact& against : soils) {
    copy.friction.push_back(against.friction);
    copy.adhesion.push_back(against.adhesion);
  }
}

Structure structure_of(const scene::Structure& structure) {
  Structure copy{.name = structure.name,
                 .outline = structure.outline.corners,
                 .hole = structure.hole ? structure.hole->corners : std::vector<Vector>{},
                 .density = structure.density,
                 .stiffness = structure.stiffness,
                 .friction_between = structure.friction};
  copy_contact(structure.against, copy);
  return copy;
}

Lining lining_of(const scene::Lining& lining, double cell_size) {
  const scene::BeamOutline outline = scene::beam_outline(lining, cell_size);
  Lining copy{.name = lining.name,
              .outline = outline.corners,
              .thickness = lining.thickness,
              .section = lining.section,
              .hinges = outline.hinges,
              .friction = {},
              .adhesion = {}};
  copy_contact(lining.against, copy);
  return copy;
}

Section section_of(const scene::Case& scene, const scene::Section& section) {
  Section copy{section.name, scene.structures[*section.structure].name, {}};
  for (const scene::SectionCut& cut : scene::cuts_of(scene, section))
    copy.cuts.push_back({cut.line.from, cut.line.to});
  return copy;
}

std::vector<Prop> props_of(const std::vector<scene::Prop>& props) {
  const auto end = [](const scene::Prop::End& of) { return PropFastening{of.structure, of.position}; };
  std::vector<Prop> copies;
  for (const scene::Prop& prop : props)
    copies.push_back(
        {prop.name, end(prop.from), end(prop.to), prop.stiffness, prop.prestress, prop.yield, prop.bears});
  return copies;
}

std::vector<Region> regions_of(const std::vector<scene::Region>& regions) {
  std::vector<Region> copies;
  for (const scene::Region& region : regions)
    copies.push_back({region.soil, region.polygon, region.cuts});
  return copies;
}

std::vector<Structure> structures_of(const std::vector<scene::Structure>& structures) {
  std::vector<Structure> copies;
  std::ranges::transform(structures, std::back_inserter(copies), structure_of);
  return copies;
}

} // namespace

std::vector<StaticStage> static_settings(const scene::Case& scene) {
  std::vector<StaticStage> stages;
  std::size_t on_surface = 0;
  std::size_t on_structures = 0;
  for (const scene::BeforeShaking& stage : scene::static_stages(scene)) {
    const auto settings = [&](const scene::StaticStage& of) {
      return StageSettings{scene::ramp_of(scene, of), of.residual, of.max_time,
                           UndrainedSoils{of.undrained, of.undrained_soils()}};
    };
    if (const auto* load = std::get_if<const scene::LoadStage*>(&stage))
      stages.emplace_back(LoadSettings{settings(**load),
                                       (*load)->on_structure() ? on_structures++ : on_surface++,
                                       (*load)->on_structure()});
    else {
      const auto& construction = *std::get<const scene::ConstructionStage*>(stage);
      stages.emplace_back(
          ConstructionSettings{settings(construction), regions_of(construction.before.regions),
                               structures_of(construction.before.structures),
                               water_of(construction.before.water), props_of(construction.before.props)});
    }
  }
  return stages;
}

Spec spec_from_case(const scene::Case& scene, int threads) {
  Spec spec;
  spec.box = {scene.mesh.box.x_min, scene.mesh.box.y_min, scene.mesh.box.x_max, scene.mesh.box.y_max};
  spec.cell_size = scene.mesh.size;
  spec.particles_per_cell = scene.mesh.particles_per_cell;
  spec.gravity = scene.gravity ? scene.gravity->acceleration : 0.0;
  for (const scene::Refinement& refine : scene.mesh.refine)
    spec.refine.push_back(
        {{refine.box.x_min, refine.box.y_min, refine.box.x_max, refine.box.y_max}, refine.level});
  spec.boxes = scene.mesh.particle_boxes;
  for (const scene::Soil& soil : scene.soils)
    spec.soils.push_back({soil.name, soil.law, finer_laws(soil, scene.mesh),
                          scene::damping_time(scene.damping, soil.damping), soil.pores,
                          scene::relaxation(scene.damping, soil.damping),
                          scene::mass_damping(scene, soil.damping)});
  spec.water = water_of(scene.water);
  spec.regions = regions_of(scene.regions);
  spec.structures = structures_of(scene.structures);
  spec.props = props_of(scene.props);
  for (const scene::Section& section : scene.sections)
    spec.sections.push_back(section_of(scene, section));
  for (const scene::Lining& lining : scene.linings)
    spec.linings.push_back(lining_of(lining, scene::contact_cell_size(scene)));
  spec.cut_at_edges = !scene.structures.empty() ||
                      std::ranges::any_of(scene.constructions, [](const scene::ConstructionStage& stage) {
                        return !stage.before.structures.empty();
                      });
  spec.clock = scene.clock();
  const auto growth = [&](double start, double ramp) {
    return Growth{spec.clock.simulated_time(start), ramp};
  };
  for (const scene::LoadStage& load : scene.loads) {
    const auto grows = load.start ? std::optional(growth(*load.start, *load.ramp)) : std::nullopt;
    if (load.on_structure())
      spec.structure_loads.push_back({load.structure, load.force, grows});
    else
      spec.loads.push_back({load.x_min, load.x_max, load.pressure, load.shear, grows});
  }
  for (const scene::Earthwork& work : scene.earthworks)
    spec.earthworks.push_back(
        {growth(work.start, work.ramp), regions_of(work.placed), regions_of(work.removed)});
  spec.normals = scene.mesh.contact_normals;
  spec.scheme = {.transfer = scene.time.transfer,
                 .order = scene.time.order,
                 .fraction = scene.time.fraction,
                 .dt = scene.time.dt,
                 .subcycle = scene.time.subcycle,
                 .dilatation = scene.mesh.dilatation,
                 .dispersion = scene.mesh.dispersion};
  const auto& [sides, left, right, base] = scene.boundary;
  spec.sides = sides;
  spec.rigid_base = scene.boundary.base_is_rigid();
  if (left.absorber == scene::Absorber::matched_layer)
    spec.matched_sides.push_back(Side::left);
  if (right.absorber == scene::Absorber::matched_layer)
    spec.matched_sides.push_back(Side::right);
  if (base.absorber == scene::Absorber::matched_layer)
    spec.matched_sides.push_back(Side::base);
  spec.layer_cells = scene.mesh.layer_cells;
  for (const Side side : {Side::left, Side::right, Side::base})
    if (const auto springs = scene::springs(scene, side))
      spec.springs.push_back({side, springs->across, springs->along, springs->centre, springs->lags,
                              side == Side::base && base.form == scene::BaseForm::incident});
  spec.below_base = scene::ground_below_base(scene);
  spec.threads = threads;
  return spec;
}

} // namespace tremolo::mpm_domain
