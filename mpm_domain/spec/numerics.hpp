#pragma once

// The choices of the domain's numerical scheme, under the names that a case file gives them.

#include <optional>

namespace tremolo::mpm_domain {

/// How velocity travels between particles and grid.
enum class Transfer {
  apic, ///< affine particle-in-cell (Jiang et al. 2015): angular momentum kept, noise filtered
  flip, ///< particles take the grid's acceleration; no dissipation, no filter
};

/// When stress is updated in a step: last, or last with remapped velocity.
enum class StepOrder { usl, musl };

/// What becomes of the particles' boxes where soil is strained.
enum class ParticleBoxes {
  fixed,     ///< they keep their size: uGIMP
  deforming, ///< they follow it (particle_boxes.hpp)
};

enum class Side { left, right, base };

/// What the two sides of the model are.
enum class Sides {
  free_field,       ///< they carry faces
  periodic,         ///< the domain repeats itself beyond them; it is a whole number of cells wide
  periodic_springs, ///< their faces are tied to each other (periodic_springs.hpp)
};

/// The numerical scheme of the domain.
struct Scheme {
  Transfer transfer = Transfer::apic;
  StepOrder order = StepOrder::musl;
  double fraction = 0.5;    ///< of the critical time step, in (0, 1]
  std::optional<double> dt; ///< a fixed time step instead, s
  /// Each level of a graded mesh takes a step of its own, half of the coarser one's (shared_nodes.hpp);
  /// fraction and dt are of the coarsest one's. For the transfer apic and the order musl.
  bool subcycle = false;
};

} // namespace tremolo::mpm_domain
