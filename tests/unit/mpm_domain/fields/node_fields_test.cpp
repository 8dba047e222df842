// What runs over the table of node fields takes every field of the groups that it names, and no other.

#include "mpm_domain/grid/grid.hpp"
#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/box_run.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

static_assert(sizeof(NodeFields) == node_field_table.size() * sizeof(NodeField));
static_assert(bytes_per_node() == 17 * sizeof(double));

/// Another number on every node of every field.
double number(std::size_t line, std::size_t node) {
  return std::sin(12.9898 * static_cast<double>(node) + 78.233 * static_cast<double>(line));
}

void fill_with_numbers(Grid& grid) {
  grid.traits = {.wet = true, .flowing = true, .sharp = true, .seeping = true};
  resize_fields(grid, grid.size());
  for (std::size_t line = 0; line < node_field_table.size(); ++line)
    for (std::size_t n = 0; n < grid.size(); ++n)
      (grid.*node_field_table[line].field)[n] = number(line, n);
}

void expect_untouched(const Grid& grid, std::size_t line) {
  for (std::size_t n = 0; n < grid.size(); ++n)
    ASSERT_EQ((grid.*node_field_table[line].field)[n], number(line, n))
        << node_field_table[line].name << ", node " << n;
}

TEST(NodeFieldTable, HasEveryFieldOnce) {
  NodeFields fields;
  std::set<const NodeField*> positions;
  std::set<std::string_view> names;
  for (const NodeFieldDescription& line : node_field_table) {
    positions.insert(&(fields.*line.field));
    names.insert(line.name);
    EXPECT_FALSE(line.unit.empty()) << line.name;
  }
  EXPECT_EQ(positions.size(), node_field_table.size());
  EXPECT_EQ(names.size(), node_field_table.size());
}

TEST(NodeFieldTable, ResizingMakesEveryFieldZero) {
  Grid grid;
  grid.traits = {.wet = true, .flowing = true, .sharp = true, .seeping = true};
  for (const NodeFieldDescription& line : node_field_table)
    (grid.*line.field).assign(3, 1.0);
  resize_fields(grid, 7);
  EXPECT_EQ(grid.size(), 7U);
  for (const NodeFieldDescription& line : node_field_table)
    EXPECT_EQ(grid.*line.field, NodeField(7, 0.0)) << line.name;
}

TEST(NodeFieldTable, DryNodesHaveNoWater) {
  Grid grid;
  resize_fields(grid, 7);
  for (const NodeFieldDescription& line : node_field_table)
    EXPECT_EQ((grid.*line.field).size(), line.trait == NodeTrait::always ? 7U : 0U) << line.name;
  EXPECT_GT(bytes_per_node({.wet = true, .flowing = false}), bytes_per_node());
  EXPECT_GT(bytes_per_node({.wet = true, .flowing = true}), bytes_per_node({.wet = true, .flowing = false}));
  EXPECT_EQ(bytes_per_node({.sharp = true}), bytes_per_node() + 7 * sizeof(double));
  EXPECT_EQ(bytes_per_node({.seeping = true}), bytes_per_node() + 2 * sizeof(double));
}

TEST(NodeFieldTable, ClearingTakesTheGroupsOfAPart) {
  Domain domain(test_support::elastic_box(4.0, 3.0, 1.0));
  const std::size_t end = domain.grid.size() / 2;
  const std::vector<NodeRange> half{{0, end}};
  const std::vector<std::pair<ScatterPart, std::set<NodeGroup>>> groups_of{
      {ScatterPart::motion, {NodeGroup::mass, NodeGroup::momentum}},
      {ScatterPart::momentum, {NodeGroup::momentum}},
      {ScatterPart::force, {NodeGroup::force}},
      {ScatterPart::both, {NodeGroup::mass, NodeGroup::momentum, NodeGroup::force}}};
  for (const auto& [part, groups] : groups_of) {
    fill_with_numbers(domain.grid);
    clear(domain, part, half);
    for (std::size_t line = 0; line < node_field_table.size(); ++line) {
      const auto& [name, unit, group, field, trait] = node_field_table[line];
      if (!groups.contains(group)) {
        expect_untouched(domain.grid, line);
        continue;
      }
      for (std::size_t n = 0; n < domain.grid.size(); ++n)
        ASSERT_EQ((domain.grid.*field)[n], n < end ? 0.0 : number(line, n)) << name << ", node " << n;
    }
  }
}

/// Every group, from the table.
std::set<NodeGroup> all_groups() {
  std::set<NodeGroup> groups;
  for (const NodeFieldDescription& line : node_field_table)
    groups.insert(line.group);
  return groups;
}

/// The images of a period; with cells of two sizes, hanging and virtual nodes besides.
class TiedNodes : public testing::TestWithParam<bool> {
protected:
  static Domain tied_domain() {
    Spec spec = test_support::elastic_box(6.0, 6.0, 1.0);
    spec.sides = Sides::periodic;
    if (GetParam())
      spec.refine = {{{1.0, -3.0, 4.0, 0.0}, 1}};
    return Domain(spec);
  }
};

/// P^T: what tied nodes have collected goes to the nodes that they follow.
TEST_P(TiedNodes, HandOnTheFieldsOfAGroup) {
  Domain domain = tied_domain();
  const Prolongation& ties = domain.ties();
  ASSERT_FALSE(ties.empty());
  for (const NodeGroup folded : all_groups()) {
    fill_with_numbers(domain.grid);
    fold(domain, folded);
    for (std::size_t line = 0; line < node_field_table.size(); ++line) {
      const auto& [name, unit, group, field, trait] = node_field_table[line];
      if (group != folded) {
        expect_untouched(domain.grid, line);
        continue;
      }
      std::vector<double> expected(domain.grid.size());
      for (std::size_t n = 0; n < expected.size(); ++n)
        expected[n] = number(line, n);
      for (std::size_t row = 0; row < ties.tied_count(); ++row) {
        for (const Share& share : ties.row(row))
          expected[share.node] += share.weight * number(line, ties.tied(row));
        expected[ties.tied(row)] = 0.0;
      }
      for (std::size_t n = 0; n < expected.size(); ++n)
        ASSERT_NEAR((domain.grid.*field)[n], expected[n], 1e-14) << name << ", node " << n;
    }
  }
}

/// P: tied nodes take over what the nodes that they follow have.
TEST_P(TiedNodes, FollowInTheFieldsOfAGroup) {
  Domain domain = tied_domain();
  const Prolongation& ties = domain.ties();
  for (const NodeGroup prolonged : all_groups()) {
    fill_with_numbers(domain.grid);
    prolong(domain, prolonged);
    for (std::size_t line = 0; line < node_field_table.size(); ++line) {
      const auto& [name, unit, group, field, trait] = node_field_table[line];
      if (group != prolonged) {
        expect_untouched(domain.grid, line);
        continue;
      }
      for (std::size_t n = 0; n < domain.grid.size(); ++n) {
        double expected = ties.shares_of(n).empty() ? number(line, n) : 0.0;
        for (const Share& share : ties.shares_of(n))
          expected += share.weight * number(line, share.node);
        ASSERT_NEAR((domain.grid.*field)[n], expected, 1e-14) << name << ", node " << n;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Meshes, TiedNodes, testing::Bool(),
                         [](const auto& of) { return of.param ? "Graded" : "Uniform"; });

} // namespace
} // namespace tremolo::mpm_domain
