// tremolo-domain: the process that owns particles. Started under the name of a source it is a free field: a
// periodic column of one cell. Otherwise it is the domain of the run: it builds the domain from the case,
// brings it to rest under gravity, replaces the supports by tractions, and shakes it through its boundary
// faces with what the coupler brings.

#include "mpm_domain/process/domain_process.hpp"

#include "mpm_domain/boundary/matched_layer.hpp"
#include "mpm_domain/boundary/periodic_springs.hpp"
#include "mpm_domain/boundary/static_traction.hpp"
#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/process/checkpoints.hpp"
#include "mpm_domain/process/column_source.hpp"
#include "mpm_domain/process/coupled_faces.hpp"
#include "mpm_domain/process/run_output.hpp"
#include "mpm_domain/process/spec_from_case.hpp"
#include "scene/case.hpp"
#include "scene/plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

namespace tremolo::mpm_domain {

namespace {

/// Brings the domain to rest and returns the wall time it took, s.
double gravity_stage(mpm_domain::Domain& domain, const scene::GravityStage& stage,
                     coupler::DomainClient& client, std::FILE* log) {
  coupler::Stopwatch watch;
  watch.start();
  const mpm_domain::GravitySettings settings{stage.residual, stage.max_time};
  const auto progress = [&](long step, double) {
    client.progress("gravity", static_cast<std::uint64_t>(step), 0.0, 0.0);
  };
  const mpm_domain::Reactions reactions = mpm_domain::relax_under_gravity(domain, settings, progress);
  if (reactions.unheld > 0)
    fmt::print(log,
               "warning: the laws of {} of {} particles cannot hold the stress under gravity and have cut "
               "it: the soil "
               "there is not at rest; a gentler slope or stronger soil would be\n",
               reactions.unheld, domain.particle_count());
  mpm_domain::replace_constraints(domain, reactions);
  watch.stop();
  return watch.seconds();
}

void shake(mpm_domain::Domain& domain, const scene::Case& scene, const scene::Plan& plan,
           const coupler::ParticipantOptions& options, coupler::DomainClient& client, double gravity_seconds,
           const results::CheckpointReader* saved) {
  mpm_domain::Checkpoints checkpoints(scene.checkpoints, mpm_domain::faces_at_rest(domain),
                                      options.surroundings.log);
  mpm_domain::attach_matched_layers(domain);
  std::optional<mpm_domain::PeriodicSprings> springs;
  if (scene.boundary.sides == scene::Sides::periodic_springs)
    springs.emplace(domain);
  mpm_domain::CoupledFaces coupled(domain, scene, plan, springs ? springs->face_count() : 0);
  const double end = scene.shaking.duration;
  std::vector<eq6::FreeField> free_field(domain.faces.size());
  double waiting_seconds = 0.0;
  mpm_domain::Stepper stepper(
      domain, 0.0,
      [&](long step, double time, auto v, auto traction) {
        waiting_seconds =
            coupled.exchange(client, static_cast<std::uint64_t>(step), time, v, traction, free_field);
        if (springs)
          springs->pull(v, traction, free_field);
      },
      [&] { return std::span<const eq6::FreeField>(free_field); });
  std::filesystem::path before;
  std::optional<coupler::DomainClient::FirstStep> first;
  if (saved != nullptr)
    before = results::set_aside(options.out / "run.h5");
  mpm_domain::RunOutput output(options.out, scene, scene::to_json(scene, plan), domain, coupled.sources());
  try {
    if (saved != nullptr) {
      mpm_domain::load_state(*saved, domain, stepper);
      output.take_over(before, *saved);
      std::filesystem::remove(before);
      first = {static_cast<std::uint64_t>(stepper.steps()), stepper.time()};
    }
    client.ready(coupled.faces(), 0.0, end, first);
    while (stepper.time() < end) {
      stepper.step();
      output.after_step(stepper, free_field);
      if (stepper.time() < end)
        checkpoints.after_step(client, domain, stepper, output);
      client.progress("shaking", static_cast<std::uint64_t>(stepper.steps()), stepper.time(), end);
    }
    output.finish(stepper, free_field, gravity_seconds, waiting_seconds);
  } catch (const std::exception& error) {
    output.abort(error.what());
    throw;
  }
  std::vector<coupler::PassTime> passes{{"gravity stage", gravity_seconds}};
  for (const mpm_domain::Pass& pass : stepper.passes())
    passes.push_back({pass.name, pass.seconds});
  client.finish(passes, stepper.particle_updates());
}

void run(const coupler::ParticipantOptions& options) {
  const scene::Case scene = scene::load(options.case_file);
  const scene::Plan plan = scene::plan(scene);
  if (const auto source = std::ranges::find(plan.sources, options.name, &scene::SourceProcess::name);
      source != plan.sources.end())
    return mpm_domain::serve_column(scene, plan, *source, options);
  coupler::DomainClient client(options);
  try {
    mpm_domain::Domain domain(mpm_domain::spec_from_case(scene, options.threads));
    const auto saved = coupler::saved_state(options);
    if (saved)
      mpm_domain::load_faces(*saved, domain);
    const double gravity_seconds =
        scene.gravity && !saved ? gravity_stage(domain, *scene.gravity, client, options.surroundings.log)
                                : 0.0;
    shake(domain, scene, plan, options, client, gravity_seconds, saved.get());
  } catch (const std::exception& error) {
    client.abandon(error.what());
    throw;
  }
}

} // namespace

int domain_process(const coupler::CommandLine& command, const coupler::Surroundings& surroundings) {
  return coupler::participant_main("tremolo-domain", "The Material Point Method domain of a tremolo run.",
                                   command, surroundings, run);
}

} // namespace tremolo::mpm_domain
