// tremolo-domain: the process that owns particles. Started under the name of a source it is a free field: a
// periodic column of one cell. Otherwise it is the domain of the run: it builds the domain from the case,
// brings it to rest under gravity, replaces the supports by tractions, and shakes it through its boundary
// faces with what the coupler brings.
//
// mpirun may have started it as several ranks (docs/ranks.md). They fill the domain together, bring it to
// rest and shake it; none of them ever has all of it. Only rank 0 knows the coupler and writes results; it
// runs on the machine of the run, the others there or on machines that share its folder.

#include "coupler/participant.hpp"
#include "mpm_domain/process/checkpoints.hpp"
#include "mpm_domain/process/column_from_case.hpp"
#include "mpm_domain/process/column_source.hpp"
#include "mpm_domain/process/come_to_rest.hpp"
#include "mpm_domain/process/coupled_faces.hpp"
#include "mpm_domain/process/output/frames/soil_frame.hpp"
#include "mpm_domain/process/output/run_output.hpp"
#include "mpm_domain/process/output/sliding_mass_output.hpp"
#include "mpm_domain/process/ranks/particles_at_start.hpp"
#include "mpm_domain/process/ranks/rank_inputs.hpp"
#include "mpm_domain/process/ranks/shared_memory.hpp"
#include "mpm_domain/process/ranks/small_pages.hpp"
#include "mpm_domain/process/spec_from_case.hpp"
#include "mpm_domain/ranks/mpi_communicator.hpp"
#include "mpm_domain/state.hpp"
#include "mpm_domain/transfer/snapshot.hpp"
#include "scene/case.hpp"
#include "scene/plan/output/intervals.hpp"
#include "scene/plan/plan.hpp"
#include "scene/plan/stages/stages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <unistd.h>

namespace tremolo::mpm_domain {

namespace {

/// Rank 0 asks the coupler for the free field.
FreeFieldSource coupled_source(CoupledFaces& faces, coupler::DomainClient* client, double& waiting_seconds) {
  return [&faces, client, &waiting_seconds](long step, double time, auto v, auto field) {
    if (client != nullptr)
      waiting_seconds = faces.exchange(*client, static_cast<std::uint64_t>(step), time, v, field);
  };
}

/// The end of a run: its last stage, and the simulated time then, s.
struct StageEnd {
  std::string stage;
  double time = 0.0;
};

/// The end of a stage; without a name, of the last one. A run that ends after a static stage other than the
/// last one does not come here.
StageEnd end_of(const scene::Case& scene, const std::string& stage) {
  const auto timed = std::ranges::find(scene.timed, stage, &scene::TimedStage::name);
  if (timed != scene.timed.end())
    return {stage, scene.clock().simulated_time(timed->end())};
  return {stage, stage.empty() ? scene.end() : 0.0};
}

/// Additional duties of rank 0: it talks to the coupler and writes the results.
class RankZeroDriver {
public:
  RankZeroDriver(coupler::DomainClient& client, const scene::Case& scene, const scene::Plan& plan,
                 const coupler::ParticipantOptions& options, Domain& domain, std::span<const Particles> start,
                 const Snapshot& snapshot, const CoupledFaces& faces, const StageEnd& stop)
      : client_(client), scene_(scene), domain_(domain), snapshot_(snapshot), end_(scene.end()), stop_(stop),
        output_(options.out, scene, scene::to_json(scene, plan), domain, start, snapshot, faces.sources()),
        checkpoints_(scene) {}

  RunOutput& output() { return output_; }
  /// Says what the snapshot must hold after a step.
  Snapshot::Extent needs(const Stepper& stepper) {
    saves_ = stepper.time() < end_ && (checkpoints_.due(stepper.steps()) || stepper.time() >= stop_.time);
    Snapshot::Extent needs = output_.needs(stepper);
    needs.all = needs.all || saves_;
    return needs;
  }
  void after_step(const Stepper& stepper) {
    output_.after_step(stepper);
    if (saves_)
      save(stepper);
    const scene::TimedStage& stage = scene::stage_at(scene_, stepper.time_of_soil(stepper.time()));
    const scene::TimedStage& before =
        scene::stage_at(scene_, stepper.time_of_soil(stepper.time() - stepper.dt()));
    if (&stage != &before)
      fmt::print("note: the {} begins at {:.6g} s, after step {}\n", stage.name,
                 stepper.time_of_soil(stepper.time()), stepper.steps());
    client_.progress(stage.name, static_cast<std::uint64_t>(stepper.steps()), stepper.time(), end_);
  }
  /// Makes a checkpoint.
  void save(const Stepper& stepper) {
    checkpoints_.save(client_, domain_, snapshot_.all(), stepper, output_);
  }
  /// Says what the snapshot must hold for the last state.
  Snapshot::Extent needs_to_finish(const Stepper& stepper) const {
    if (ends_early())
      return {.all = stepper.steps() == 0};
    return output_.needs_to_finish(stepper);
  }
  void write_last(const Stepper& stepper) {
    if (!ends_early())
      output_.write_last(stepper);
    else if (stepper.steps() == 0)
      output_.write_before_shaking(stepper);
  }
  void finish(const Stepper& stepper, double gravity_seconds, double waiting_seconds) {
    if (ends_early()) {
      const std::string reason = ended_after(stop_.stage);
      fmt::print("note: {}\n", reason);
      abort(reason);
    } else {
      if (const auto lacking = output_.finish(stepper, gravity_seconds, waiting_seconds))
        fmt::print(stderr, "warning: {}\n", *lacking);
      warn();
    }
    std::vector<coupler::PassTime> passes{{"gravity stage", gravity_seconds}};
    for (const PassTime& pass : stepper.times())
      passes.push_back({pass.name, pass.seconds});
    client_.finish(passes, stepper.particle_updates());
  }
  void abort(const std::string& reason) {
    output_.abort(reason);
    warn();
  }

private:
  /// Whether the run is to end after a stage that is not its last.
  bool ends_early() const { return stop_.time < end_; }

  /// Reports what a user should know of the whole run.
  void warn() const {
    if (const auto note = output_.note())
      fmt::print("note: {}\n", *note);
    if (const auto warning = output_.warning())
      fmt::print("warning: {}\n", *warning);
  }

  coupler::DomainClient& client_;
  const scene::Case& scene_;
  Domain& domain_;
  const Snapshot& snapshot_;
  double end_;
  StageEnd stop_;
  RunOutput output_;
  Checkpoints checkpoints_;
  bool saves_ = false;
};

/// Whether a rest that ends at a pressure has reached it. All ranks call it and get one answer.
bool pressure_is_gone(const Stepper& stepper, const scene::Case& scene) {
  constexpr long steps_between = 100; // looking at all particles costs a tenth of a step
  const scene::TimedStage& last = scene.timed.back();
  return last.rest && last.rest->until_ratio && stepper.steps() % steps_between == 0 &&
         stepper.time_of_soil(stepper.time()) >= last.start &&
         largest_pressure_ratio(stepper.domain()) <= *last.rest->until_ratio;
}

/// Steps to the end, and writes what is due. All ranks take part in what the first one writes.
void step_to_end(Domain& domain, Stepper& stepper, Snapshot& snapshot, RankZeroDriver* driver,
                 const scene::Case& scene, double stop) {
  const auto quantities = [&] {
    domain.boundary.tell_first(domain); // it may be to save a checkpoint
    return SoilFrame(domain, stepper, scene).quantities();
  };
  const auto show = [&](Snapshot::Extent wanted, const std::function<void()>& write) {
    snapshot.show(wanted, quantities, write);
  };
  if (!(stepper.time() < stop))
    show({.all = true}, [&] { driver->save(stepper); });
  while (stepper.time() < stop && !pressure_is_gone(stepper, scene)) {
    stepper.step();
    show(driver != nullptr ? driver->needs(stepper) : Snapshot::Extent{},
         [&] { driver->after_step(stepper); });
  }
  if (driver != nullptr && stepper.time() < stop)
    fmt::print("note: the {} ends at {:.6g} s: no excess pore pressure ratio is above {:g}\n",
               scene.timed.back().name, stepper.time_of_soil(stepper.time()),
               *scene.timed.back().rest->until_ratio);
  show(driver != nullptr ? driver->needs_to_finish(stepper) : Snapshot::Extent{},
       [&] { driver->write_last(stepper); });
}

/// @param client  null on all ranks but the first
void shake(Domain& domain, const scene::Case& scene, const scene::Plan& plan,
           const coupler::ParticipantOptions& options, coupler::DomainClient* client, double gravity_seconds,
           const results::CheckpointReader* saved, const StageEnd& stop) {
  const double end = scene.end();
  double waiting_seconds = 0.0;
  CoupledFaces coupled(domain, scene, plan);
  std::filesystem::path before;
  if (saved != nullptr && client != nullptr)
    before = results::set_aside(options.out / "run.h5");
  Snapshot snapshot(domain);
  std::vector<Particles> found;
  if (domain.share)
    found = particles_at_start(domain, scene);
  std::optional<RankZeroDriver> driver;
  std::vector<ParticleName> followed;
  if (client != nullptr) {
    driver.emplace(*client, scene, plan, options, domain, domain.share ? found : domain.sets, snapshot,
                   coupled, stop);
    followed = driver->output().followed();
  }
  try {
    if (saved != nullptr)
      restore(domain, *saved);
    snapshot.follow(followed, in_sliding_masses(scene, domain));
    Stepper stepper(domain, 0.0, coupled_source(coupled, client, waiting_seconds));
    std::optional<coupler::DomainClient::FirstStep> first;
    if (saved != nullptr) {
      stepper.restore(*saved);
      first = {static_cast<std::uint64_t>(stepper.steps()), stepper.time()};
    }
    if (driver && saved != nullptr) {
      driver->output().take_over(before, *saved);
      std::filesystem::remove(before);
    }
    if (client != nullptr)
      client->ready(coupled.faces(), 0.0, end, first);
    step_to_end(domain, stepper, snapshot, driver ? &*driver : nullptr, scene, stop.time);
    domain.boundary.tell_first(domain);
    if (driver)
      driver->finish(stepper, gravity_seconds, waiting_seconds);
  } catch (const std::exception& error) {
    if (driver)
      driver->abort(error.what());
    throw;
  }
}

void run_share(const coupler::ParticipantOptions& options, const scene::Case& scene, const scene::Plan& plan,
               coupler::DomainClient* client, Communicator* ranks, const std::string& until) {
  if (ranks != nullptr)
    require_same_inputs(*ranks, scene, plan, options);
  Spec spec = spec_from_case(scene, options.threads);
  spec.rock_motion = rock_motion(scene, plan);
  auto saved = coupler::saved_state(options);
  Domain domain(spec, ranks);
  const bool before_shaking = saved && is_before_shaking(scene, *saved);
  if (saved && !before_shaking)
    domain.boundary.restore_rest(domain, *saved);
  double gravity_seconds = 0.0;
  if (scene.gravity && (!saved || before_shaking)) {
    const AtRest rest = come_to_rest(domain, {scene, plan, options, client, ranks}, saved.get(), until);
    if (rest.ended)
      return;
    gravity_seconds = rest.seconds;
  }
  if (before_shaking) { // there is nothing of the shaking to go on from
    saved.reset();
    if (client != nullptr)
      std::filesystem::remove(options.out / "run.h5");
  }
  shake(domain, scene, plan, options, client, gravity_seconds, saved.get(), end_of(scene, until));
}

std::string this_machine() {
  std::array<char, 256> name{};
  ::gethostname(name.data(), name.size() - 1);
  return name.data();
}

/// Work of all ranks except the first.
void run_as_helper(const coupler::ParticipantOptions& options, Communicator& ranks,
                   const std::string& until) {
  try {
    const scene::Case scene = scene::load(options.case_file);
    run_share(options, scene, scene::plan(scene), nullptr, &ranks, until);
  } catch (const std::exception& error) {
    fmt::print(stderr, "rank {} of the domain, on {}: {}\n", ranks.rank(), this_machine(), error.what());
    // If all ranks fail with one error, the first rank reports it.
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    throw;
  }
}

/// @param count  number of ranks requested from mpirun
std::unique_ptr<Communicator> joined_ranks(int count) {
  if (count == 1)
    return nullptr;
  use_shared_memory_of_run();
  use_small_pages();
  auto ranks = join_ranks();
  if (const int found = ranks ? ranks->size() : 1; found != count)
    throw std::runtime_error(fmt::format("this is one of {} ranks that mpirun has started, but MPI finds {}: "
                                         "mpirun must be of the Open MPI that "
                                         "tremolo was built with",
                                         count, found));
  return ranks;
}

void run(const coupler::ParticipantOptions& options, int rank_count, const std::string& until) {
  const std::unique_ptr<Communicator> ranks = joined_ranks(rank_count);
  if (ranks && ranks->rank() > 0)
    return run_as_helper(options, *ranks, until);
  const scene::Case scene = scene::load(options.case_file);
  const scene::Plan plan = scene::plan(scene);
  if (const auto source = std::ranges::find(plan.sources, options.name, &scene::SourceProcess::name);
      source != plan.sources.end())
    return serve_column(scene, plan, *source, options);
  coupler::DomainClient client(options);
  try {
    run_share(options, scene, plan, &client, ranks.get(), until);
  } catch (const std::exception& error) {
    client.abandon(error.what());
    throw;
  }
}

} // namespace
} // namespace tremolo::mpm_domain

int main(int argc, char** argv) {
  std::string ranks = "1";
  std::string until;
  return tremolo::coupler::participant_main(
      "tremolo-domain", "The Material Point Method domain of a tremolo run.", argc, argv,
      [&](const tremolo::coupler::ParticipantOptions& options) {
        tremolo::mpm_domain::run(options, std::stoi(ranks), until);
      },
      {{"--ranks", "how many ranks share the domain, this one being one of them", ranks},
       {"--until", "name of the stage that it ends after", until}});
}
