// tremolo-domain: the process that owns particles. Started under the name of a source it is a free field: a
// periodic column of one cell. Otherwise it is the domain of the run: it builds the domain from the case,
// brings it to rest under gravity, replaces the supports by tractions, and shakes it through its boundary
// faces with what the coupler brings.

#include "coupler/participant.hpp"
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
#include <filesystem>
#include <optional>
#include <string>

namespace tremolo::mpm_domain {

namespace {

/// What a user should know of bodies that do not rest on their friction.
std::string told_of_slipping(const Domain& domain, const std::vector<std::size_t>& bodies) {
  std::string names;
  for (const std::size_t b : bodies)
    names += fmt::format("{}'{}'", names.empty() ? "" : ", ", domain.contact.bodies()[b].name());
  const bool one = bodies.size() == 1;
  return fmt::format(
      "soil and friction cannot hold {} {} under gravity: {} in place until the shaking starts, "
      "and {} from then on; more friction or a gentler slope would hold {}",
      one ? "structure" : "structures", names, one ? "it stays" : "they stay", one ? "moves" : "move",
      one ? "it" : "them");
}

/// Brings the domain to rest and returns the wall time it took, s.
double gravity_stage(Domain& domain, const scene::GravityStage& stage, coupler::DomainClient& client) {
  coupler::Stopwatch watch;
  watch.start();
  const GravitySettings settings{stage.residual, stage.max_time};
  const auto progress = [&](long step, double) {
    client.progress("gravity", static_cast<std::uint64_t>(step), 0.0, 0.0);
  };
  const Reactions reactions = relax_under_gravity(domain, settings, progress);
  if (reactions.unheld > 0)
    fmt::print("warning: the laws of {} of {} particles cannot hold the stress under gravity and have cut "
               "it: the soil "
               "there is not at rest; a gentler slope or stronger soil would be\n",
               reactions.unheld, domain.particle_count());
  if (reactions.slipping)
    fmt::print("warning: {}\n", told_of_slipping(domain, reactions.slipping_bodies));
  replace_constraints(domain, reactions);
  watch.stop();
  return watch.seconds();
}

void shake(Domain& domain, const scene::Case& scene, const scene::Plan& plan,
           const coupler::ParticipantOptions& options, coupler::DomainClient& client, double gravity_seconds,
           const results::CheckpointReader* saved) {
  Checkpoints checkpoints(scene.checkpoints);
  const double end = scene.shaking.duration;
  double waiting_seconds = 0.0;
  std::optional<CoupledFaces> coupled; // when the stepper has put supports behind the faces
  Stepper stepper(domain, 0.0, [&](long step, double time, auto v, auto field) {
    waiting_seconds = coupled->exchange(client, static_cast<std::uint64_t>(step), time, v, field);
  });
  coupled.emplace(domain, scene, plan);
  std::filesystem::path before;
  std::optional<coupler::DomainClient::FirstStep> first;
  if (saved != nullptr)
    before = results::set_aside(options.out / "run.h5");
  RunOutput output(options.out, scene, scene::to_json(scene, plan), domain, coupled->sources());
  try {
    if (saved != nullptr) {
      load_state(*saved, domain, stepper);
      output.take_over(before, *saved);
      std::filesystem::remove(before);
      first = {static_cast<std::uint64_t>(stepper.steps()), stepper.time()};
    }
    client.ready(coupled->faces(), 0.0, end, first);
    while (stepper.time() < end) {
      stepper.step();
      output.after_step(stepper);
      if (stepper.time() < end)
        checkpoints.after_step(client, domain, stepper, output);
      client.progress("shaking", static_cast<std::uint64_t>(stepper.steps()), stepper.time(), end);
    }
    output.finish(stepper, gravity_seconds, waiting_seconds);
  } catch (const std::exception& error) {
    output.abort(error.what());
    throw;
  }
  std::vector<coupler::PassTime> passes{{"gravity stage", gravity_seconds}};
  for (const Pass& pass : stepper.passes())
    passes.push_back({pass.name, pass.seconds});
  client.finish(passes, stepper.particle_updates());
}

void run(const coupler::ParticipantOptions& options) {
  const scene::Case scene = scene::load(options.case_file);
  const scene::Plan plan = scene::plan(scene);
  if (const auto source = std::ranges::find(plan.sources, options.name, &scene::SourceProcess::name);
      source != plan.sources.end())
    return serve_column(scene, plan, *source, options);
  coupler::DomainClient client(options);
  try {
    Domain domain(spec_from_case(scene, options.threads));
    const auto saved = coupler::saved_state(options);
    if (saved)
      load_rest_state(*saved, domain);
    const double gravity_seconds =
        scene.gravity && !saved ? gravity_stage(domain, *scene.gravity, client) : 0.0;
    shake(domain, scene, plan, options, client, gravity_seconds, saved.get());
  } catch (const std::exception& error) {
    client.abandon(error.what());
    throw;
  }
}

} // namespace
} // namespace tremolo::mpm_domain

int main(int argc, char** argv) {
  return tremolo::coupler::participant_main("tremolo-domain",
                                            "The Material Point Method domain of a tremolo run.", argc, argv,
                                            tremolo::mpm_domain::run);
}
