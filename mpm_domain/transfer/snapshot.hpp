#pragma once

// Particles as output sees them: those of the domain or, where ranks share it, a copy on rank 0 of all that
// the ranks have, or of those that monitors follow. Ranks bring it up to date when something is to be
// written.

#include "mpm_domain/particles/share_out.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// A particle, wherever it is.
struct ParticleName {
  std::size_t set;
  std::uint32_t id;
};

class Snapshot {
public:
  /// @param domain outlives this; shared out later, if at all
  explicit Snapshot(Ground& ground) : ground_(ground) {}

  /// A particle that is not in it has no place in index_of.
  std::span<const Particles> sets() const {
    return ground_.share ? std::span<const Particles>(copy_.sets) : std::span<const Particles>(ground_.sets);
  }
  std::span<const Particles> sets_of_soil() const { return sets().first(ground_.soil_sets); }
  /// Velocity and acceleration as particle_velocity() and particle_acceleration() give them (gather.hpp).
  Vector velocity(std::size_t set, std::size_t k) const;
  Vector acceleration(std::size_t set, std::size_t k) const;

  enum class Extent { nothing, followed, all };

  /// Passes to all ranks which particles are followed. That of rank 0 counts; all ranks call it once.
  void follow(const std::vector<ParticleName>& followed);
  /// Brings the snapshot up to date as far as rank 0 wants it; after a step. All ranks call it.
  /// @returns what rank 0 wants
  Extent take(Extent wanted);

private:
  Ground& ground_;
  std::vector<std::vector<bool>> followed_; ///< by set and id
  GatheredSets copy_;                       ///< with their velocities and accelerations
};

} // namespace tremolo::mpm_domain
