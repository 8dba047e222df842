#include "mpm_domain/transfer/snapshot.hpp"

#include "mpm_domain/ranks/communicator.hpp"
#include "mpm_domain/ranks/passed_state.hpp"
#include "mpm_domain/transfer/gather.hpp"

#include <array>
#include <cstdint>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

constexpr std::size_t numbers_of_motion = 4; ///< velocity and acceleration of a particle

} // namespace

Vector Snapshot::velocity(std::size_t set, std::size_t k) const {
  if (!ground_.share)
    return particle_velocity(ground_, ground_.sets[set], k);
  const double* const motion = copy_.numbers[set].data() + numbers_of_motion * k;
  return {motion[0], motion[1]};
}

Vector Snapshot::acceleration(std::size_t set, std::size_t k) const {
  if (!ground_.share)
    return particle_acceleration(ground_, ground_.sets[set], k);
  const double* const motion = copy_.numbers[set].data() + numbers_of_motion * k;
  return {motion[2], motion[3]};
}

void Snapshot::follow(const std::vector<ParticleName>& followed, Wanted also) {
  also_followed_ = std::move(also);
  if (!ground_.share)
    return;
  std::vector<std::uint64_t> names;
  for (const ParticleName& particle : followed)
    names.insert(names.end(), {particle.set, particle.id});
  PassedState of_first;
  of_first.write("followed", std::move(names));
  of_first.follow_first(*ground_.share->ranks);
  names = of_first.integers("followed");
  for (const Particles& set : ground_.sets)
    followed_.emplace_back(set.index_of.size(), false);
  for (std::size_t i = 0; i < names.size(); i += 2)
    followed_[names[i]][names[i + 1]] = true;
}

void Snapshot::show(Extent wanted, const std::function<std::vector<ShownQuantity>()>& shown,
                    const std::function<void()>& read) {
  if (!ground_.share)
    return read();
  std::array<double, 2> flags{wanted.followed ? 1.0 : 0.0, wanted.all ? 1.0 : 0.0};
  ground_.share->ranks->follow_first(flags);
  wanted = {flags[0] != 0.0, flags[1] != 0.0};
  if (wanted.followed || wanted.all)
    take_at_skirt(ground_, std::array{&NodeFields::vx_after, &NodeFields::vy_after, &NodeFields::ax,
                                      &NodeFields::ay}); // readings take in the nodes beside
  if (wanted.followed)
    take_followed();
  if (wanted.all)
    all_.show(shown(), read);
  else if (ground_.share->ranks->rank() == 0)
    read();
}

void Snapshot::take_followed() {
  const auto is_wanted = [&](std::size_t set, std::size_t k) {
    const std::uint32_t id = ground_.sets[set].id[k]; // particles that have been cut are not among them
    return (id < followed_[set].size() && followed_[set][id]) || (also_followed_ && also_followed_(set, k));
  };
  copy_ = gather_sets(ground_, is_wanted, numbers_of_motion,
                      [&](std::size_t set, std::size_t k, std::vector<double>& to) {
                        const Vector v = particle_velocity(ground_, ground_.sets[set], k);
                        const Vector a = particle_acceleration(ground_, ground_.sets[set], k);
                        to.insert(to.end(), {v.x, v.y, a.x, a.y});
                      });
}

} // namespace tremolo::mpm_domain
