#include "mpm_domain/transfer/snapshot.hpp"

#include "mpm_domain/ranks/communicator.hpp"
#include "mpm_domain/transfer/gather.hpp"

namespace tremolo::mpm_domain {

Vector Snapshot::velocity(std::size_t set, std::size_t k) const {
  return particle_velocity(ground_, sets()[set], k);
}

Vector Snapshot::acceleration(std::size_t set, std::size_t k) const {
  if (!ground_.share)
    return particle_acceleration(ground_, ground_.sets[set], k);
  const std::vector<double>& of_set = copy_.numbers[set];
  return {of_set[2 * k], of_set[2 * k + 1]};
}

void Snapshot::follow(const std::vector<ParticleName>& followed) {
  if (!ground_.share)
    return;
  Communicator& ranks = *ground_.share->ranks;
  double count = static_cast<double>(followed.size());
  ranks.follow_first({&count, 1});
  std::vector<double> numbers;
  for (const ParticleName& particle : followed)
    numbers.insert(numbers.end(), {static_cast<double>(particle.set), static_cast<double>(particle.id)});
  numbers.resize(2 * static_cast<std::size_t>(count));
  ranks.follow_first(numbers);
  for (const Particles& set : ground_.sets)
    followed_.emplace_back(set.index_of.size(), false);
  for (std::size_t i = 0; i < numbers.size(); i += 2)
    followed_[static_cast<std::size_t>(numbers[i])][static_cast<std::size_t>(numbers[i + 1])] = true;
}

Snapshot::Extent Snapshot::take(Extent wanted) {
  if (!ground_.share)
    return wanted;
  double number = static_cast<double>(wanted);
  ground_.share->ranks->follow_first({&number, 1});
  wanted = static_cast<Extent>(static_cast<int>(number));
  if (wanted == Extent::nothing)
    return wanted;
  Wanted is_wanted;
  if (wanted == Extent::followed)
    is_wanted = [&](std::size_t set, std::size_t k) {
      const std::uint32_t id = ground_.sets[set].id[k]; // particles that have been cut are not among them
      return id < followed_[set].size() && followed_[set][id];
    };
  copy_ = gather_sets(ground_, is_wanted, 2, [&](std::size_t set, std::size_t k, std::vector<double>& to) {
    const Vector a = particle_acceleration(ground_, ground_.sets[set], k);
    to.insert(to.end(), {a.x, a.y});
  });
  return wanted;
}

} // namespace tremolo::mpm_domain
