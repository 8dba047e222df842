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
void add_clock(Ground& ground, int clock) {
  constexpr SumRange fields = fields_of<SoilPhase>(motion, force);
  add_sums(
      ground, clock, std::array{fields},
      [&](const Particles& p, std::size_t tile, double* window) {
        return scatter_set<PoreWaterCoupling::none, motion, force>(ground, p, clock, tile, window);
      },
      [&](AcrossTile& tile) { scatter_across_set<SoilPhase, motion, force>(ground, tile); });
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

void clear(Ground& ground, ScatterPart part, std::span<const NodeRange> nodes) {
  std::vector<NodeField*> fields;
  for_groups(part, [&](NodeGroup group) {
    for_group(ground.grid, group, [&](NodeField& field) { fields.push_back(&field); });
  });
  ground.workers.run(nodes.size(), [&](std::size_t row) {
    for (NodeField* field : fields)
      std::fill(field->data() + nodes[row].begin, field->data() + nodes[row].end, 0.0);
  });
}

void add_particles(Ground& ground, ScatterPart part, int clock) {
  switch (part) {
  case ScatterPart::motion:
    return add_clock<Motion::mass_and_momentum, false>(ground, clock);
  case ScatterPart::momentum:
    return add_clock<Motion::momentum, false>(ground, clock);
  case ScatterPart::force:
    return add_clock<Motion::none, true>(ground, clock);
  case ScatterPart::both:
    return add_clock<Motion::mass_and_momentum, true>(ground, clock);
  }
}

void fold(Ground& ground, ScatterPart part, std::span<const std::size_t> rows) {
  for_groups(part, [&](NodeGroup group) { fold(ground, group, rows); });
}

void scatter(Ground& ground, ScatterPart part) {
  clear(ground, part, ground.soil_rows);
  for (int clock = 0; clock < ground.clocks.count(); ++clock)
    add_particles(ground, part, clock);
  for_groups(part, [&](NodeGroup group) { fold(ground, group); });
}

} // namespace tremolo::mpm_domain
