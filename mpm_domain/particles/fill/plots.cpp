#include "mpm_domain/particles/fill/plots.hpp"

#include "mpm_domain/ranks/lists_of_all.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

namespace tremolo::mpm_domain {

namespace {

void add_particle(Particles& set, const Plot& plot) {
  set.id.push_back(static_cast<std::uint32_t>(set.id.size()));
  set.for_fields([](const ParticleFieldDescription&, std::vector<double>& values) { values.push_back(0.0); });
  const auto [x, y, area] = plot;
  set.x.back() = set.x_initial.back() = x;
  set.y.back() = set.y_initial.back() = y;
  set.volume.back() = area;
  set.mass.back() = set.density * area;
  if (set.traits.own_boxes)
    set.box_xx.back() = set.box_yy.back() = set.half_size * set.half_size;
}

/// Whether this rank is the first of those that have the least of numbers, one by one.
std::vector<bool> has_least(std::span<const double> numbers, Communicator* ranks) {
  std::vector<bool> has(numbers.size(), true);
  if (ranks == nullptr)
    return has;
  std::vector<double> least;
  for (const double number : numbers)
    least.push_back(-number);
  ranks->largest(least);
  std::vector<double> first;
  for (std::size_t n = 0; n < numbers.size(); ++n)
    first.push_back(-numbers[n] == least[n] ? -ranks->rank() : -ranks->size());
  ranks->largest(first);
  for (std::size_t n = 0; n < numbers.size(); ++n)
    has[n] = first[n] == -ranks->rank();
  return has;
}

} // namespace

Plots::Plots(std::span<Particles> sets, Communicator* ranks)
    : sets_(sets), ranks_(ranks), rank_(ranks != nullptr ? ranks->rank() : 0) {}

void Plots::add(std::size_t set, const Plot& plot, double size) {
  if (is_particle(plot, size))
    add_particle(sets_[set], plot);
  else if (plot.area > 0.0)
    slivers_.push_back({set, plot, rank_});
}

/// The first sliver of a set without particles becomes one.
void Plots::begin_empty_sets() {
  std::vector<std::int64_t> sizes;
  for (const Particles& set : sets_)
    sizes.push_back(static_cast<std::int64_t>(set.size()));
  if (ranks_ != nullptr)
    ranks_->add(sizes);
  std::erase_if(slivers_, [&](const Sliver& sliver) {
    const bool begins = sizes[sliver.set]++ == 0;
    if (begins && sliver.rank == rank_)
      add_particle(sets_[sliver.set], sliver.plot);
    return begins;
  });
}

Plots::Nearest Plots::nearest(const Sliver& sliver) const {
  const Particles& set = sets_[sliver.set];
  Nearest found{.distance = std::numeric_limits<double>::infinity()};
  for (std::size_t k = 0; k < set.size(); ++k)
    if (const double distance = std::hypot(set.x[k] - sliver.plot.x, set.y[k] - sliver.plot.y);
        distance < found.distance)
      found = {k, distance};
  return found;
}

void Plots::join_slivers() {
  if (ranks_ != nullptr)
    slivers_ = lists_of_all(*ranks_, slivers_); // in the order in which one process would lay them
  begin_empty_sets();
  std::vector<std::size_t> next;
  std::vector<double> distances;
  for (const Sliver& sliver : slivers_) {
    const auto [k, distance] = nearest(sliver);
    next.push_back(k);
    distances.push_back(distance);
  }
  const std::vector<bool> is_here = has_least(distances, ranks_);
  for (std::size_t n = 0; n < slivers_.size(); ++n) {
    if (!is_here[n])
      continue;
    Particles& set = sets_[slivers_[n].set];
    set.volume[next[n]] += slivers_[n].plot.area;
    set.mass[next[n]] += set.density * slivers_[n].plot.area;
  }
  slivers_.clear();
}

} // namespace tremolo::mpm_domain
