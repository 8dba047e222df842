#pragma once

// A support behind faces of the domain, replacing or supplementing the dashpots of Eq. (6): it absorbs the
// waves that the domain scatters, or carries static loads into the ground beyond. supports.cpp lists the
// kinds that there are. One is made for a domain at rest, claims its faces, and from then on is moved by each
// exchange of the free field and exerts tractions,
//
//     own      on the soil by its own motion: its work is that of dashpots
//     driven   on the soil by the free field: its work is input
//     spring   of springs whose far ends move with the free field, f^spr: f^spr . v^ff is input
//
// The first two belong to clock 0, whose ticks they give impulses at; that of springs is held over the step
// of its face, as the moving part of Eq. (6) is. Whatever else a support does in a step is a pass of its own.

#include "mpm_domain/boundary/boundary_faces.hpp"
#include "mpm_domain/fields/saved_numbers.hpp"
#include "mpm_domain/passes/pass.hpp"
#include "mpm_domain/tiles/worker_pool.hpp"

#include <span>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

/// The exchange of a step, at its first tick. Spans are over all faces.
struct Exchange {
  const Ground& ground;
  WorkerPool& workers;
  std::span<const BoundaryFace> faces;
  std::span<const FaceSoil> soil;    ///< empty unless there is pore water or ranks share the ground
  double time = 0.0;                 ///< s
  double dt = 0.0;                   ///< of the step that begins, s
  std::span<const Vector> seen;      ///< v^m as dashpots see it (face_motion.hpp), m/s
  std::span<const Vector> seen_mean; ///< its mean over the ticks since the last exchange, m/s
  std::span<const Vector> mean;      ///< that of v-, of grains and water together, m/s
  /// The free field at this time, by face; then the own fields of the faces that have one, in their order.
  std::span<eq6::FreeField> field;
};

/// Tractions of supports on a face, Pa.
struct SupportLoad {
  Vector own, driven, spring;
  Vector far_end; ///< velocity of the far ends of springs, m/s

  Vector reaction() const { return own + driven; }
};

class Support {
public:
  Support() = default;
  Support(const Support&) = delete;
  Support& operator=(const Support&) = delete;
  virtual ~Support() = default;

  /// Names its state in a checkpoint, and its row in the table of times where it has one.
  virtual std::string name() const = 0;
  /// Whether its exchange has a row of its own in the table of times; otherwise it counts as boundary
  /// exchange.
  virtual bool is_timed() const { return false; }
  /// Whether what it does at a face depends on nothing but what it knows of that face. Ranks then need to
  /// advance it at no faces but those that they work out.
  virtual bool is_by_face() const { return false; }
  /// After a sort: the grid may have grown.
  virtual void follow_sort(const Ground&) {}
  /// Goes on to the time of an exchange, and leaves what it exerts from then on.
  virtual void exchange(const Exchange& at, std::span<SupportLoad> loads) = 0;
  /// Energy that its springs have absorbed since the last exchange, J/m.
  virtual double work() const { return 0.0; }
  /// The passes of whatever else it does in a step.
  virtual std::vector<Pass> passes(Ground&) { return {}; }

  /// Adds all that changes with time, for a checkpoint.
  virtual void add_state(SavedNumbers&) {}
};

} // namespace tremolo::mpm_domain
