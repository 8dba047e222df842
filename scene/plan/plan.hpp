#pragma once

// The plan of a case: which effects it calls for and why, which processes serve its free fields, and what the
// run costs. Nobody switches effects by hand.

#include "scene/case.hpp"
#include "scene/plan/levels.hpp"
#include "scene/plan/lining/linings.hpp"
#include "scene/plan/prop/props.hpp"
#include "scene/plan/step/step_limit.hpp"
#include "scene/plan/structures.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace tremolo::scene {

struct Effect {
  std::string name;
  bool on = false;
  std::string why;                   ///< what in the case calls for it, or what would
  double bytes_per_particle = 0.0;   ///< on top of the others
  double ns_per_particle_step = 0.0; ///< single thread, on top of the others; 0 where it is not per particle
};

/// The data that a source process sends to a side.
struct Served {
  Side side = Side::left;
  BaseForm field = BaseForm::total; ///< lateral sides always take the total field
};

/// A free-field process. Equal free fields share one.
struct SourceProcess {
  std::string name; ///< the sides it serves, e.g. "left-base"
  FreeFieldModel field;
  double surface = 0.0;        ///< y of the free surface, m
  std::optional<Side> profile; ///< whose own layers lie under it; without one, Case::profile
  std::vector<Served> serves;
};

/// "tremolo-wave", "tremolo-column", ...; a program of the user by its path.
std::string program(const FreeFieldModel& field);

struct Plan {
  std::vector<Effect> effects;
  std::vector<SourceProcess> sources;
  std::string base; ///< in words: what the base uses

  std::vector<PlannedStructure> structures;
  std::vector<PlannedLining> linings;
  std::vector<PlannedProp> props;
  std::vector<Level> levels; ///< of the mesh, coarse to fine
  std::size_t particles = 0;
  std::size_t cells = 0;       ///< of all levels, see Level
  StepLimit limit;             ///< of the time step
  double critical_dt = 0.0;    ///< limit.dt, s
  double dt = 0.0;             ///< s
  std::int64_t steps = 0;      ///< of shaking and rest
  std::int64_t frames = 0;     ///< particle frames written
  double memory_bytes = 0.0;   ///< of the domain process
  double output_bytes = 0.0;   ///< of run.h5 and run.xdmf, at most
  double estimated_time = 0.0; ///< wall-clock of these steps on one thread, s
};

Plan plan(const Case& scene);

/// Layers of nonlinear soil that the model of a source takes as linear elastic, a sentence for each soil.
std::vector<std::string> linearised_soils(const Case& scene, const SourceProcess& source);

/// The source that serves a side.
/// @throws std::invalid_argument for a periodic side
const SourceProcess& source_of(const Plan& plan, Side side);

/// Who serves the base.
struct BaseSources {
  std::string left;                 ///< at the left end, or everywhere
  std::optional<std::string> right; ///< at the right end, of a base that is blended from two
};
BaseSources base_sources(const Case& scene, const Plan& plan);

/// The plan as text for people.
std::string explain(const Case& scene, const Plan& plan);

/// The warnings and notes on a case, a line each; empty where there are none. `check`, `explain` and `run`
/// print them alike.
std::string remarks_text(const Case& scene);

/// The plan and the remarks as JSON, for result files.
std::string to_json(const Case& scene, const Plan& plan);

} // namespace tremolo::scene
