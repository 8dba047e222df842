#include "mpm_domain/transfer/scatter.hpp"

#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/transfer/add_sums.hpp"
#include "mpm_domain/transfer/scatter_kernel.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

template <Motion motion, bool force>
void add_clock(Domain& domain, int clock) {
  constexpr SumRange fields = fields_of<SoilPhase>(motion, force);
  add_sums(
      domain, clock, std::array{fields},
      [&](const Particles& p, std::size_t tile, double* window) {
        return scatter_set<Company::none, motion, force>(domain, p, clock, tile, window);
      },
      [&](AcrossTile& tile) { scatter_across_set<SoilPhase, motion, force>(domain, tile); });
}

/// act(group) for the groups of node fields that a part sums up.
template <typename Act>
void for_groups(ScatterPart part, const Act& act) {
  if (part == ScatterPart::motion || part == ScatterPart::both)
    act(NodeGroup::mass);
  if (part != ScatterPart::force)
    act(NodeGroup::momentum);
  if (part == ScatterPart::force || part == ScatterPart::both)
    act(NodeGroup::force);
}

} // namespace

void clear(Domain& domain, ScatterPart part, std::span<const NodeRange> nodes) {
  std::vector<NodeField*> fields;
  for_groups(part, [&](NodeGroup group) {
    for_group(domain.grid, group, [&](NodeField& field) { fields.push_back(&field); });
  });
  domain.workers.run(nodes.size(), [&](std::size_t row) {
    for (NodeField* field : fields)
      std::fill(field->data() + nodes[row].begin, field->data() + nodes[row].end, 0.0);
  });
}

void add_particles(Domain& domain, ScatterPart part, int clock) {
  switch (part) {
  case ScatterPart::motion:
    return add_clock<Motion::mass_and_momentum, false>(domain, clock);
  case ScatterPart::momentum:
    return add_clock<Motion::momentum, false>(domain, clock);
  case ScatterPart::force:
    return add_clock<Motion::none, true>(domain, clock);
  case ScatterPart::both:
    return add_clock<Motion::mass_and_momentum, true>(domain, clock);
  }
}

void fold(Domain& domain, ScatterPart part, std::span<const std::size_t> rows) {
  for_groups(part, [&](NodeGroup group) { fold(domain, group, rows); });
}

void scatter(Domain& domain, ScatterPart part) {
  clear(domain, part, domain.soil_rows);
  for (int clock = 0; clock < domain.clocks.count(); ++clock)
    add_particles(domain, part, clock);
  for_groups(part, [&](NodeGroup group) { fold(domain, group); });
}

} // namespace tremolo::mpm_domain
