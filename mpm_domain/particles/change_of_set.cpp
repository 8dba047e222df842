#include "mpm_domain/particles/change_of_set.hpp"

#include <algorithm>

namespace tremolo::mpm_domain {

namespace {

/// Adds a particle with a share of what belongs to all of another one.
void add_part(const Particles& from, std::size_t k, double share, Particles& to) {
  std::vector<double> values;
  from.for_fields([&](const ParticleFieldDescription& line, const std::vector<double>& of_whole) {
    values.push_back(line.on_cut == OnCut::shared ? share * of_whole[k] : of_whole[k]);
  });
  auto next = values.begin();
  to.for_fields(
      [&](const ParticleFieldDescription&, std::vector<double>& of_part) { of_part.push_back(*next++); });
  const auto state = from.state.begin() + static_cast<std::ptrdiff_t>(k * from.state_size);
  to.state.insert(to.state.end(), state, state + static_cast<std::ptrdiff_t>(from.state_size));
  const std::size_t id = to.index_of.size();
  to.id.push_back(static_cast<std::uint32_t>(id));
  to.index_of.give(id + 1);
  to.index_of.put(id, to.size() - 1);
}

} // namespace

void add_quarter(const Particles& from, std::size_t k, Particles& to) {
  add_part(from, k, 0.25, to);
}

void add_copy(const Particles& from, std::size_t k, Particles& to) {
  add_part(from, k, 1.0, to);
}

void remove(Particles& p, const std::vector<std::size_t>& gone) {
  for (const std::size_t k : gone)
    p.index_of.remove(p.id[k]);
  const auto keep = [&](auto& array, std::size_t width) {
    std::size_t end = gone.front() * width;
    auto next = gone.begin();
    for (std::size_t k = gone.front(); k * width < array.size() && width > 0; ++k) {
      if (next != gone.end() && *next == k) {
        ++next;
        continue;
      }
      for (std::size_t i = 0; i < width; ++i)
        array[end++] = array[k * width + i];
    }
    array.resize(end);
  };
  keep(p.state, p.state_size);
  p.for_fields([&](const ParticleFieldDescription&, std::vector<double>& values) { keep(values, 1); });
  keep(p.id, 1);
  for (std::size_t& start : p.block_start)
    start -= static_cast<std::size_t>(std::ranges::lower_bound(gone, start) - gone.begin());
}

} // namespace tremolo::mpm_domain
