#pragma once

// Particles as output sees them. Histories take those that monitors follow: those of the domain or, where
// ranks share it, a copy on rank 0, brought up to date when a row is to be written. Frames and checkpoints
// take all, piece by piece.

#include "mpm_domain/particles/all/all_particles.hpp"
#include "mpm_domain/particles/share_out.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
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
  /// @param ground  outlives this
  explicit Snapshot(Ground& ground) : ground_(ground), all_(ground) {}

  /// Those that are followed. A particle that is not in it has no place in index_of.
  std::span<const Particles> sets() const {
    return ground_.share ? std::span<const Particles>(copy_.sets) : std::span<const Particles>(ground_.sets);
  }
  std::span<const Particles> sets_of_soil() const { return sets().first(ground_.soil_sets); }
  /// Velocity and acceleration as particle_velocity() and particle_acceleration() give them (gather.hpp).
  Vector velocity(std::size_t set, std::size_t k) const;
  Vector acceleration(std::size_t set, std::size_t k) const;

  /// All particles; where ranks share the domain, while show() is called for them.
  const AllParticles& all() const { return all_; }

  /// Passes to all ranks which particles are followed. All ranks call it once.
  /// @param followed  by name: those of rank 0 count
  /// @param also      others, by what they are, such as quarters of those that have been cut; the same on all
  void follow(const std::vector<ParticleName>& followed, Wanted also = {});

  struct Extent {
    bool followed = false;
    bool all = false;
  };
  /// Lets rank 0 read as much as it wants, after a step. All ranks call it.
  /// @param wanted  that of rank 0 counts
  /// @param shown   the quantities that it may read of all particles (all_particles.hpp)
  /// @param read    called on rank 0
  void show(Extent wanted, const std::function<std::vector<ShownQuantity>()>& shown,
            const std::function<void()>& read);

private:
  void take_followed();

  Ground& ground_;
  AllParticles all_;
  std::vector<std::vector<bool>> followed_; ///< by set and id
  Wanted also_followed_;                    ///< none: no others are
  GatheredSets copy_;                       ///< with their velocities and accelerations
};

} // namespace tremolo::mpm_domain
