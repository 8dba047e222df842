#include "mpm_domain/particles/parcels.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

constexpr std::size_t head = 2; ///< numbers of a particle before its fields

std::size_t field_count(const Particles& set) {
  std::size_t count = 0;
  set.for_fields([&](const ParticleFieldDescription&, const std::vector<double>&) { ++count; });
  return count;
}

/// A particle of the set that is to be, and where it comes from.
struct Source {
  std::size_t block;
  std::size_t k;         ///< in the set, where it stays
  const double* numbers; ///< in a parcel; null: it stays
};

std::vector<Source> sources_of(const Particles& set, const std::vector<bool>& stays,
                               std::span<const Parcel> arrived, std::size_t width) {
  std::vector<Source> sources;
  with_blocks(set, 0, set.size(), [&](std::size_t k, std::size_t block) {
    if (stays.empty() || stays[k])
      sources.push_back({block, k, nullptr});
  });
  const auto come = static_cast<std::ptrdiff_t>(sources.size());
  for (const Parcel& parcel : arrived)
    for (std::size_t i = 0; i < parcel.size(); i += width)
      sources.push_back({static_cast<std::size_t>(parcel[i]), 0, parcel.data() + i});
  std::stable_sort(sources.begin() + come, sources.end(),
                   [](const Source& a, const Source& b) { return a.block < b.block; });
  std::inplace_merge(sources.begin(), sources.begin() + come, sources.end(),
                     [](const Source& a, const Source& b) { return a.block < b.block; });
  return sources;
}

} // namespace

void pack(const Particles& set, std::size_t k, std::size_t block, Parcel& parcel) {
  parcel.push_back(static_cast<double>(block));
  parcel.push_back(static_cast<double>(set.id[k]));
  set.for_fields([&](const ParticleFieldDescription&, const std::vector<double>& values) {
    parcel.push_back(values[k]);
  });
  const auto state = set.state.begin() + static_cast<std::ptrdiff_t>(k * set.state_size);
  parcel.insert(parcel.end(), state, state + static_cast<std::ptrdiff_t>(set.state_size));
}

std::vector<double> rearrange(Particles& set, std::size_t blocks, const std::vector<bool>& stays,
                              std::span<const Parcel> arrived, std::size_t more) {
  const std::size_t fields = field_count(set);
  const std::size_t width = head + fields + set.state_size + more;
  const std::vector<Source> sources = sources_of(set, stays, arrived, width);
  for (std::size_t k = 0; k < stays.size(); ++k)
    if (!stays[k])
      set.index_of.remove(set.id[k]);
  std::vector<std::uint32_t> ids;
  ids.reserve(sources.size());
  for (const auto& [block, k, numbers] : sources)
    ids.push_back(numbers != nullptr ? static_cast<std::uint32_t>(numbers[1]) : set.id[k]);
  set.id = std::move(ids);
  for (std::size_t n = 0; n < sources.size(); ++n)
    set.index_of.put(set.id[n], n);

  /// One array after the other: there is never a second one of all.
  const auto fill = [&](std::vector<double>& array, std::size_t count, std::size_t position) {
    std::vector<double> values;
    values.reserve(count * sources.size());
    for (const auto& [block, k, numbers] : sources) {
      const double* const from = numbers != nullptr ? numbers + position : array.data() + k * count;
      values.insert(values.end(), from, from + count);
    }
    array = std::move(values);
  };
  std::size_t position = head;
  set.for_fields(
      [&](const ParticleFieldDescription&, std::vector<double>& values) { fill(values, 1, position++); });
  fill(set.state, set.state_size, position);

  set.block_start.assign(blocks + 1, 0);
  std::vector<double> besides;
  for (const auto& [block, k, numbers] : sources) {
    ++set.block_start[block + 1];
    if (numbers != nullptr)
      besides.insert(besides.end(), numbers + width - more, numbers + width);
  }
  std::partial_sum(set.block_start.begin(), set.block_start.end(), set.block_start.begin());
  return besides;
}

} // namespace tremolo::mpm_domain
