#include "mpm_domain/process/come_to_rest.hpp"

#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_stages.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/process/coupled_faces.hpp"
#include "mpm_domain/process/output/stage_frames.hpp"
#include "mpm_domain/process/spec_from_case.hpp"
#include "mpm_domain/ranks/communicator.hpp"
#include "results/run_checksums.hpp"
#include "scene/plan/stages/stages.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

/// Warning about bodies that friction alone does not hold at rest.
std::string slipping_text(const Domain& domain, const std::vector<std::size_t>& bodies) {
  std::string names;
  for (const std::size_t b : bodies)
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", domain.contact.bodies()[b].name());
  if (bodies.empty())
    return "soil and friction cannot hold the linings under gravity: they stick to the soil until the "
           "shaking starts, and slide from then on; more friction would hold them";
  const bool one = bodies.size() == 1;
  return fmt::format(
      "soil and friction cannot hold {} {} under gravity: {} in place until the shaking starts, "
      "and {} from then on; more friction or a gentler slope would hold {}",
      one ? "structure" : "structures", names, one ? "it stays" : "they stay", one ? "moves" : "move",
      one ? "it" : "them");
}

/// "'clay' (120 particles, x = 3 to 12.5 m, y = -4 to -1 m)", with commas.
std::string cut_text(const std::vector<CutStress>& cut) {
  std::string text;
  for (const CutStress& of : cut)
    text += fmt::format("{}'{}' ({} particle{}, x = {:.4g} to {:.4g} m, y = {:.4g} to {:.4g} m)",
                        text.empty() ? "" : ", ", of.soil, of.particles, of.particles == 1 ? "" : "s",
                        of.low.x, of.high.x, of.low.y, of.high.y);
  return text;
}

/// "structure 'tower' has moved by 0.4 mm in x and -12 mm in y and turned by 0.01 degrees", with commas.
std::string ways_text(const std::vector<StructureWay>& ways) {
  std::string text;
  for (const StructureWay& structure : ways)
    text += fmt::format("{}'{}' has moved by {:.3g} mm in x and {:.3g} mm in y and turned by {:.3g} degrees",
                        text.empty() ? "structure " : ", ", structure.name, 1e3 * structure.way.x,
                        1e3 * structure.way.y, structure.turn * 180.0 / std::numbers::pi);
  return text;
}

/// "'strut' -120 kN/m", with commas.
std::string forces_of_props(const Domain& domain) {
  std::string text;
  for (const Props::Placed& prop : domain.props.all())
    text +=
        fmt::format("{}'{}' {:.4g} kN/m", text.empty() ? "" : ", ", prop.name, 1e-3 * prop.spring.force());
  return text;
}

void report(const Domain& domain, const Reactions& reactions) {
  if (domain.props.any())
    fmt::print("note: when the shaking starts, props have the forces {} (tension positive)\n",
               forces_of_props(domain));
  if (!reactions.ways.empty())
    fmt::print("note: {} in the stages before the shaking, in which frames show where it has gone; its "
               "motion in run.h5 counts from where it was placed\n",
               ways_text(reactions.ways));
  if (!reactions.cut.empty())
    fmt::print("warning: the laws of these soils cannot hold the stress at rest and have cut it: {} of "
               "{} particles; the soil there is not at rest, a gentler slope or stronger soil would be\n",
               cut_text(reactions.cut), reactions.particles);
  if (reactions.slipping)
    fmt::print("warning: {}\n", slipping_text(domain, reactions.slipping_bodies));
}

/// Leaves a frame of ground that has found no rest: its velocities show where it moves. All ranks call it.
/// @returns the sentence that says so
std::string leave_frame(Domain& domain, const RunOfCase& run, const NotAtRest& failure) {
  take_velocities_of_nodes(domain);
  write_stage_frame(run.options.out, case_of_stage(run.scene, failure.stage), domain, failure.what());
  const std::string stage =
      failure.stage == 0 ? "" : fmt::format("stage '{}': ", scene::stages(run.scene)[failure.stage].name);
  return fmt::format("{}{}; the frame in run.h5 shows where the ground moves", stage, failure.what());
}

/// A rank that ends takes the first one along, which has a frame to write.
void wait_for_first(Communicator& ranks) {
  double sign = 0.0;
  ranks.follow_first({&sign, 1});
}

/// Makes the checkpoint from which the run can continue, and ends the run. The sources are needed for that
/// alone. All ranks call it.
void end_after_stage(const Domain& domain, StaticStages& stages, const RunOfCase& run, double seconds) {
  const std::size_t last = stages.over() - 1;
  const std::string reason = ended_after(scene::stages(run.scene)[last].name);
  stages.show([&](Domain& model) {
    write_stage_frame(run.options.out, case_of_stage(run.scene, last), model, reason);
  });
  AllParticles particles(stages.model());
  particles.show({}, [&] {
    run.client->ready(CoupledFaces(domain, run.scene, run.plan).faces(), 0.0, run.scene.end());
    run.client->checkpoint(0.0, [&](results::CheckpointWriter& file) {
      stages.save(particles, file);
      file.write_text(std::string(results::checksums_name),
                      results::checksum_text({})); // all is written anew
    });
  });
  if (run.client == nullptr)
    return;
  fmt::print("note: {}\n", reason);
  run.client->finish({{"gravity stage", seconds}}, 0.0);
}

/// Leaves a frame of each stage where there are several. All ranks call it.
void leave_stage_frame(StaticStages& stages, const RunOfCase& run) {
  const std::size_t last = stages.over() - 1;
  stages.show([&](Domain& model) {
    write_stage_frame(stage_folder(run.options.out, run.scene, last), case_of_stage(run.scene, last), model,
                      fmt::format("the frame of the stage '{}'", scene::stages(run.scene)[last].name));
  });
}

} // namespace

std::string ended_after(const std::string& stage) {
  return fmt::format("ended after the stage '{}', as was asked; tremolo resume goes on", stage);
}

std::size_t static_stage_count(const scene::Case& scene) {
  return scene.gravity ? 1 + scene::static_stages(scene).size() : 0;
}

bool is_before_shaking(const scene::Case& scene, const results::CheckpointReader& saved) {
  return StaticStages::read_count(saved) < static_stage_count(scene);
}

AtRest come_to_rest(Domain& domain, const RunOfCase& run, const results::CheckpointReader* saved,
                    const std::string& until) {
  coupler::Stopwatch watch;
  watch.start();
  const scene::GravityStage& gravity = *run.scene.gravity;
  const std::vector<scene::PlannedStage> planned = scene::stages(run.scene);
  const auto progress = [&](std::size_t stage, long step, double residual) {
    if (run.client != nullptr)
      run.client->progress(planned[stage].name, static_cast<std::uint64_t>(step), 0.0, 0.0, residual);
  };
  const std::vector<StaticStage> then = static_settings(run.scene);
  StaticStages stages(domain, {gravity.residual, gravity.max_time}, then, progress);
  if (saved != nullptr)
    stages.restore(*saved);
  try {
    while (!stages.are_over()) {
      stages.next();
      if (!then.empty())
        leave_stage_frame(stages, run);
      if (planned[stages.over() - 1].name != until || stages.are_over())
        continue;
      watch.stop();
      end_after_stage(domain, stages, run, watch.seconds());
      return {.seconds = watch.seconds(), .ended = true};
    }
  } catch (const NotAtRest& failure) {
    const std::string reason = leave_frame(failure.model ? *failure.model : domain, run, failure);
    if (run.ranks != nullptr)
      wait_for_first(*run.ranks);
    throw std::runtime_error(reason);
  }
  const Reactions reactions = stages.finish();
  if (run.client != nullptr)
    report(domain, reactions);
  replace_constraints(domain, reactions);
  watch.stop();
  return {.seconds = watch.seconds()};
}

} // namespace tremolo::mpm_domain
