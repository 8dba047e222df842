#include "mpm_domain/head/seepage_of_ground.hpp"

#include "mpm_domain/head/ground_mesh.hpp"
#include "mpm_domain/spec/lattice.hpp"
#include "seepage/elements.hpp"
#include "seepage/steady_flow.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

namespace {

using seepage::Condition;

/// The columns of nodes below the free water of both sides: those up to the first whose ground rises above
/// the level there.
struct FreeWater {
  std::size_t left_end;    ///< last column of the left water
  std::size_t right_begin; ///< first column of the right water
};

FreeWater free_water(const GroundMesh& mesh, const SideLevels& levels) {
  const std::size_t columns = mesh.grid.columns;
  std::size_t left = 0;
  while (left < columns && mesh.ground(left) < levels.left - mesh.slack())
    ++left;
  std::size_t right = columns;
  while (right > 0 && mesh.ground(right - 1) < levels.right - mesh.slack())
    --right;
  if (levels.left != levels.right && (left == columns || right == 0))
    throw std::invalid_argument(fmt::format(
        "water at {:g} m on the left and at {:g} m on the right would meet over the ground: only ground that "
        "rises above both keeps two levels apart",
        levels.left, levels.right));
  return {left, right > 0 ? right - 1 : 0};
}

void set_conditions(GroundMesh& mesh, const SideLevels& levels, const FreeWater& water) {
  seepage::FlowProblem& problem = mesh.problem;
  problem.conditions.assign(problem.nodes.size(), Condition::none);
  problem.given.assign(problem.nodes.size(), 0.0);
  const auto give = [&](std::size_t n, double head) {
    problem.conditions[n] = Condition::head;
    problem.given[n] = head;
  };
  for (const std::size_t n : mesh.surface) {
    const double y = problem.nodes[n].y;
    if (mesh.column(n) <= water.left_end && y <= levels.left + mesh.slack())
      give(n, levels.left);
    else if (mesh.column(n) >= water.right_begin && y <= levels.right + mesh.slack())
      give(n, levels.right);
    else
      problem.conditions[n] = Condition::exit;
  }
  const auto stand_beside = [&](const std::vector<std::size_t>& nodes, double level) {
    for (const std::size_t n : nodes)
      if (problem.nodes[n].y <= level + mesh.slack())
        give(n, level);
  };
  stand_beside(mesh.left, levels.left);
  stand_beside(mesh.right, levels.right);
}

/// Means over the elements of a node.
struct NodeSlopes {
  std::vector<Vector> slope; ///< grad h, 1
  std::vector<double> area;  ///< m2; 0 outside of the ground
};

NodeSlopes slopes_of(const seepage::FlowProblem& problem, const std::vector<double>& heads) {
  NodeSlopes slopes{std::vector<Vector>(heads.size()), std::vector<double>(heads.size(), 0.0)};
  for (const seepage::Element& element : problem.elements) {
    const auto [dx, dy] = seepage::gradient(problem, element, heads);
    const double area = seepage::area(problem, element);
    for (std::size_t c = 0; c < element.corners; ++c) {
      slopes.slope[element.nodes[c]] += area * Vector{dx, dy};
      slopes.area[element.nodes[c]] += area;
    }
  }
  for (std::size_t n = 0; n < heads.size(); ++n)
    if (slopes.area[n] > 0.0)
      slopes.slope[n] = slopes.slope[n] / slopes.area[n];
  return slopes;
}

/// Gives nodes that have no head yet the mean of what their neighbours would give them, one layer of nodes.
/// @param from  (known node, place) -> the head there
/// @returns whether any was without
template <typename From>
bool extend(HeadGrid& grid, std::vector<unsigned char>& known, const From& from) {
  const std::vector<unsigned char> before = known;
  bool any = false;
  for (std::size_t j = 0; j < grid.rows; ++j)
    for (std::size_t i = 0; i < grid.columns; ++i) {
      if (before[grid.node(i, j)] != 0)
        continue;
      double sum = 0.0;
      double count = 0.0;
      for (std::size_t b = j > 0 ? j - 1 : 0; b <= std::min(j + 1, grid.rows - 1); ++b)
        for (std::size_t a = i > 0 ? i - 1 : 0; a <= std::min(i + 1, grid.columns - 1); ++a)
          if (before[grid.node(a, b)] != 0) {
            sum += from(grid.node(a, b), grid.position(i, j));
            count += 1.0;
          }
      if (count == 0.0)
        continue;
      grid.heads[grid.node(i, j)] = sum / count;
      known[grid.node(i, j)] = 1;
      any = true;
    }
  return any;
}

/// The heads of the regular grid.
HeadGrid regular(const GroundMesh& mesh, const std::vector<double>& heads, const SideLevels& levels,
                 const FreeWater& water) {
  const NodeSlopes slopes = slopes_of(mesh.problem, heads);
  const auto along_slope = [&](std::size_t n, const Vector& to) {
    const Vector& at = mesh.problem.nodes[n];
    return heads[n] + dot(slopes.slope[n], {to.x - at.x, to.y - at.y});
  };
  HeadGrid grid = mesh.grid;
  grid.heads.assign(heads.size(), 0.0);
  std::vector<unsigned char> known(heads.size(), 0);
  for (std::size_t j = 0; j < grid.rows; ++j)
    for (std::size_t i = 0; i < grid.columns; ++i)
      if (const std::size_t n = grid.node(i, j); slopes.area[n] > 0.0) {
        grid.heads[n] = along_slope(n, grid.position(i, j));
        known[n] = 1;
      }
  extend(grid, known, along_slope);
  for (std::size_t n = 0; n < heads.size(); ++n)
    if (known[n] == 0 && (mesh.column(n) <= water.left_end || mesh.column(n) >= water.right_begin)) {
      grid.heads[n] = mesh.column(n) <= water.left_end ? levels.left : levels.right;
      known[n] = 1;
    }
  while (extend(grid, known, [&](std::size_t n, const Vector&) { return grid.heads[n]; })) {
  }
  return grid;
}

void find_steepest_rise(const seepage::FlowProblem& problem, const std::vector<double>& heads,
                        SeepageFound& found) {
  for (const seepage::Element& element : problem.elements) {
    Vector centre;
    double head = 0.0;
    for (std::size_t c = 0; c < element.corners; ++c) {
      const double share = 1.0 / static_cast<double>(element.corners);
      centre.x += share * problem.nodes[element.nodes[c]].x;
      centre.y += share * problem.nodes[element.nodes[c]].y;
      head += share * heads[element.nodes[c]];
    }
    if (head <= centre.y)
      continue;
    if (const double rise = -seepage::gradient(problem, element, heads).y; rise > found.steepest_rise) {
      found.steepest_rise = rise;
      found.at = centre;
    }
  }
}

} // namespace

SeepageOfGround seep(const Spec& spec) {
  GroundMesh mesh = mesh_of(spec);
  const SideLevels& levels = *spec.water->seepage;
  const FreeWater water = free_water(mesh, levels);
  set_conditions(mesh, levels, water);
  const seepage::SteadyFlow flow = seepage::solve(mesh.problem);
  SeepageFound found{.discharge = flow.discharge, .iterations = flow.iterations};
  if (const auto exit = seepage::exit_point(mesh.problem, flow))
    found.exit = {exit->x, exit->y};
  find_steepest_rise(mesh.problem, flow.heads, found);
  return {Head(regular(mesh, flow.heads, levels, water)), found};
}

namespace {

/// Below ground that free water has left, and that could not drain, water stands up to the surface: it is
/// undisturbed where its pressure is zero there (Morgenstern 1963).
Head drawn_down(const Spec& spec) {
  const double level = spec.water->level;
  const double wet = *spec.water->still_wet;
  const auto [left, right] = std::pair(spec.box.x_min, spec.box.x_max);
  const double width = particle_size(spec.cell_size, spec.particles_per_cell);
  const auto columns = static_cast<std::size_t>(std::lround((right - left) / width));
  std::vector<Vector> line;
  for (std::size_t c = 0; c < columns; ++c) {
    const double x = left + (static_cast<double>(c) + 0.5) * width;
    line.push_back({x, std::min(wet, std::max(level, ground_at(spec, x)))});
  }
  const auto [low, high] = std::ranges::minmax(line, {}, &Vector::y);
  return low.y == high.y ? Head(low.y) : Head(std::move(line));
}

} // namespace

std::optional<Head> head_of(const Spec& spec) {
  if (!spec.water)
    return std::nullopt;
  if (spec.water->still_wet)
    return drawn_down(spec);
  if (spec.water->seepage)
    return seep(spec).head;
  return spec.water->line.empty() ? Head(spec.water->level) : Head(spec.water->line);
}

} // namespace tremolo::mpm_domain
