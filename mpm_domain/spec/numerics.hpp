#pragma once

// The choices of the domain's numerical scheme, under the names that a case file gives them.

#include "base/words.hpp"

#include <optional>

namespace tremolo::mpm_domain {

/// Transfer of velocity between particles and grid.
enum class Transfer {
  apic, ///< affine particle-in-cell (Jiang et al. 2015): angular momentum kept, noise filtered
  flip, ///< particles take the grid's acceleration; no dissipation, no filter
};
constexpr auto words(Transfer) {
  return word_table<Transfer>({{Transfer::apic, "apic"}, {Transfer::flip, "flip"}});
}

/// When stress is updated in a step: last, or last with remapped velocity.
enum class StepOrder { usl, musl };
constexpr auto words(StepOrder) {
  return word_table<StepOrder>({{StepOrder::usl, "usl"}, {StepOrder::musl, "musl"}});
}

/// Change of the particles' boxes with strain.
enum class ParticleBoxes {
  fixed,     ///< they keep their size: uGIMP
  deforming, ///< they follow it (particle_boxes.hpp)
};
constexpr auto words(ParticleBoxes) {
  return word_table<ParticleBoxes>(
      {{ParticleBoxes::fixed, "fixed"}, {ParticleBoxes::deforming, "deforming"}});
}

/// Volumetric strain passed to a law that yields.
enum class Dilatation {
  cell, ///< the mean of the particle's cell: soil that keeps its volume does not lock (cell_dilatation.hpp)
  particle, ///< the particle's own
};
constexpr auto words(Dilatation) {
  return word_table<Dilatation>({{Dilatation::cell, "cell"}, {Dilatation::particle, "particle"}});
}

/// Numerical dispersion: waves in the domain are slower than true ones, the more so the shorter they are.
enum class Dispersion {
  plain,   ///< that of uGIMP
  reduced, ///< its leading term is taken away (dispersion/sharpening.hpp)
};
constexpr auto words(Dispersion) {
  return word_table<Dispersion>({{Dispersion::plain, "plain"}, {Dispersion::reduced, "reduced"}});
}

enum class Side { left, right, base };
constexpr auto words(Side) {
  return word_table<Side>({{Side::left, "left"}, {Side::right, "right"}, {Side::base, "base"}});
}

/// Kind of the two sides of the model.
enum class Sides {
  free_field,       ///< they carry faces
  periodic,         ///< the domain repeats itself beyond them; it is a whole number of cells wide
  periodic_springs, ///< their faces are tied to each other (periodic_springs.hpp)
  container,        ///< smooth walls that move with a rigid base (rigid_base.hpp)
};
constexpr auto words(Sides) {
  return word_table<Sides>({{Sides::free_field, "free_field"},
                            {Sides::periodic, "periodic"},
                            {Sides::periodic_springs, "periodic_springs"},
                            {Sides::container, "container"}});
}

/// The numerical scheme of the domain.
struct Scheme {
  Transfer transfer = Transfer::apic;
  StepOrder order = StepOrder::musl;
  double fraction = 0.5;    ///< of the critical time step, in (0, 1]
  std::optional<double> dt; ///< a fixed time step instead, s
  /// Each level of a graded mesh takes a step of its own, half of the coarser one's (shared_nodes.hpp);
  /// fraction and dt are of the coarsest one's. For the transfer apic and the order musl.
  bool subcycle = false;
  Dilatation dilatation = Dilatation::cell; ///< of laws that yield; others see their own
  Dispersion dispersion = Dispersion::plain;
};

} // namespace tremolo::mpm_domain
