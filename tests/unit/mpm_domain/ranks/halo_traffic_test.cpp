// What ranks send to each other in a step is what the perimeter of their tiles asks for, where there is no
// boundary.

#include "mpm_domain/ranks/communicator.hpp"
#include "tests/support/box_run.hpp"
#include "tests/unit/mpm_domain/ranks/test_ranks.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>

namespace tremolo {
namespace {

using mpm_domain::Spec;

/// A second count: node by node. Every filled tile of this rank sends each of its window's nodes once to each
/// other rank that has a tile with the node in its window.
std::uint64_t nodes_to_send(const mpm_domain::Domain& domain) {
  const mpm_domain::TileMap& tiles = domain.tiles;
  std::uint64_t count = 0;
  for (std::size_t tile = 0; tile < tiles.count(); ++tile) {
    if (domain.share->deal.load[tile] == 0 || !domain.share->is_mine(tile))
      continue;
    const mpm_domain::NodeBlock window = tiles.window(tile);
    for (int row = window.row; row < window.end_row(); ++row)
      for (int column = window.column; column < window.end_column(); ++column) {
        std::set<int> ranks;
        for (const std::size_t other : tiles.around(tile)) {
          const mpm_domain::NodeBlock of_other = tiles.window(other);
          const bool holds = column >= of_other.column && column < of_other.end_column() &&
                             row >= of_other.row && row < of_other.end_row();
          if (const int owner = domain.share->owner(other);
              holds && owner >= 0 && !domain.share->is_mine(other))
            ranks.insert(owner);
        }
        count += ranks.size();
      }
  }
  return count;
}

mpm_domain::Communicator::Traffic traffic_of_a_step(mpm_domain::Domain& domain) {
  test_support::PlaneWave wave;
  mpm_domain::Stepper stepper(domain, 0.9, test_support::plane_wave_source(domain, wave, true));
  const auto before = domain.share->ranks->traffic();
  stepper.step();
  const auto after = domain.share->ranks->traffic();
  return {after.messages - before.messages, after.bytes - before.bytes};
}

/// Fields of the scatters of a step with musl: mass, momentum and force, then momentum again.
constexpr std::uint64_t fields_a_step = 5 + 2;

TEST(HaloTraffic, IsThatOfTheNodesInWindowsOfOthers) {
  TREMOLO_NEED_RANKS();
  mpm_domain::Domain domain(test_support::elastic_box(100.0, 40.0, 1.0), test_support::test_ranks());
  domain.boundary.remove_faces();
  sort_particles(domain);
  EXPECT_EQ(traffic_of_a_step(domain).bytes, nodes_to_send(domain) * fields_a_step * sizeof(double));
}

/// Windows of 37 x 13 nodes share 5 rows with those above. Soil of 44 m by 20 m fills 2 x 4 tiles, which the
/// curve parts above the second row: each of the two tiles at the rim sends 37 x 5 nodes, in one message a
/// scatter.
TEST(HaloTraffic, AcrossAStraightRimIsFiveRows) {
  TREMOLO_NEED_RANKS();
  if (test_support::test_ranks()->size() != 2)
    return; // more ranks have rims with corners
  mpm_domain::Domain domain(test_support::elastic_box(44.0, 20.0, 1.0), test_support::test_ranks());
  domain.boundary.remove_faces();
  sort_particles(domain);
  const auto traffic = traffic_of_a_step(domain);
  EXPECT_EQ(traffic.messages, 2u);
  EXPECT_EQ(traffic.bytes, std::uint64_t{2} * 37 * 5 * fields_a_step * sizeof(double));
}

} // namespace
} // namespace tremolo
