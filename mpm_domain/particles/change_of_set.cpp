#include "mpm_domain/particles/change_of_set.hpp"

namespace tremolo::mpm_domain {

void add_copy(const Particles& from, std::size_t k, Particles& to) {
  const ExtraColumns extra = from.extra_columns();
  const auto values = from.columns(extra);
  const auto into = to.columns(extra);
  for (std::size_t c = 0; c < values.size(); ++c)
    into[c]->push_back((*values[c])[k]);
  const auto state = from.state.begin() + static_cast<std::ptrdiff_t>(k * from.state_size);
  to.state.insert(to.state.end(), state, state + static_cast<std::ptrdiff_t>(from.state_size));
  to.id.push_back(static_cast<std::uint32_t>(to.index_of.size()));
  to.index_of.push_back(static_cast<std::uint32_t>(to.size() - 1));
}

void remove(Particles& p, const std::vector<std::size_t>& gone) {
  for (const std::size_t k : gone)
    p.index_of[p.id[k]] = Particles::nowhere;
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
  for (std::vector<double>* column : p.columns())
    keep(*column, 1);
  keep(p.id, 1);
}

} // namespace tremolo::mpm_domain
