#include "mesh/quadtree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace tremolo::mesh {

namespace {

constexpr std::size_t nowhere = static_cast<std::size_t>(-1);

/// Cells first .. last - 1 of side h that overlap [a, b] by more than rounding, cut to 0 .. count - 1.
struct Range {
  int first;
  int last;
};

Range overlapped(double a, double b, double origin, double h, int count) {
  constexpr double rounding = 1e-6;
  const auto within = [&](double cells) {
    return static_cast<int>(std::clamp(cells, 0.0, static_cast<double>(count)));
  };
  return {within(std::floor((a - origin) / h + rounding)), within(std::ceil((b - origin) / h - rounding))};
}

} // namespace

std::vector<Refinement> beyond_edges(std::span<const Refinement> refinements, const Rectangle& model,
                                     double near, bool sides) {
  constexpr double far = std::numeric_limits<double>::infinity();
  std::vector<Refinement> all(refinements.begin(), refinements.end());
  for (Refinement& refinement : all) {
    Rectangle& box = refinement.box;
    if (sides && box.x_min < model.x_min + near)
      box.x_min = -far;
    if (sides && box.x_max > model.x_max - near)
      box.x_max = far;
    if (box.y_min < model.y_min + near)
      box.y_min = -far;
    if (box.y_max > model.y_max - near)
      box.y_max = far;
  }
  return all;
}

Quadtree::Quadtree(const Roots& roots, std::span<const Refinement> refinements) : roots_(roots) {
  if (roots.nx < 1 || roots.ny < 1 || !(roots.h > 0.0) || roots.period < 0 || roots.period > roots.nx)
    throw std::invalid_argument("a mesh needs at least one cell, of a size > 0 m");
  int finest = 0;
  for (const Refinement& refinement : refinements) {
    if (refinement.level < 0 || refinement.level > finest_level_allowed)
      throw std::invalid_argument("a refinement's level is " + std::to_string(refinement.level) +
                                  "; allowed: 0 to " + std::to_string(finest_level_allowed));
    finest = std::max(finest, refinement.level);
  }
  for (int level = 0; level < finest; ++level)
    cut_.emplace_back(static_cast<std::size_t>(columns(level)) * static_cast<std::size_t>(rows(level)));
  cut_for_balance_.resize(cut_.size());
  for (const Refinement& refinement : refinements)
    refine(refinement);
  balance();
  while (!cut_.empty() && std::ranges::count(cut_.back(), 1) == 0)
    cut_.pop_back(); // a box beside the roots cuts nothing
}

int Quadtree::real_column(int level, int i) const {
  if (roots_.period == 0)
    return i;
  const int first = roots_.first_column << level;
  const int period = roots_.period << level;
  const int beyond = (i - first) % period;
  return first + (beyond < 0 ? beyond + period : beyond);
}

std::size_t Quadtree::place(const Cell& cell) const {
  if (cell.level < 0 || cell.i < 0 || cell.j < 0 || cell.i >= columns(cell.level) ||
      cell.j >= rows(cell.level))
    return nowhere;
  return static_cast<std::size_t>(cell.j) * static_cast<std::size_t>(columns(cell.level)) +
         static_cast<std::size_t>(real_column(cell.level, cell.i));
}

Rectangle Quadtree::rectangle(const Cell& cell) const {
  const double h = size(cell.level);
  return {roots_.x0 + cell.i * h, roots_.y0 + cell.j * h, roots_.x0 + (cell.i + 1) * h,
          roots_.y0 + (cell.j + 1) * h};
}

bool Quadtree::is_cut(const Cell& cell) const {
  if (cell.level >= finest())
    return false;
  const std::size_t at = place(cell);
  return at != nowhere && cut_[static_cast<std::size_t>(cell.level)][at] != 0;
}

bool Quadtree::exists(const Cell& cell) const {
  if (place(cell) == nowhere)
    return false;
  return cell.level == 0 || is_cut({cell.level - 1, cell.i / 2, cell.j / 2});
}

void Quadtree::refine(const Refinement& refinement) {
  const Rectangle& box = refinement.box;
  for (int level = 0; level < refinement.level; ++level) {
    const Range x = overlapped(box.x_min, box.x_max, roots_.x0, size(level), columns(level));
    const Range y = overlapped(box.y_min, box.y_max, roots_.y0, size(level), rows(level));
    for (int j = y.first; j < y.last; ++j)
      for (int i = x.first; i < x.last; ++i)
        cut_[static_cast<std::size_t>(level)][place({level, i, j})] = 1;
  }
}

/// A cut cell's children need neighbours that are at most one level coarser: all cells around it exist, which
/// means that their parents are cut. From fine to coarse once, since this cuts coarser cells only.
void Quadtree::balance() {
  for (int level = finest() - 1; level > 0; --level)
    for (int j = 0; j < rows(level); ++j)
      for (int i = 0; i < columns(level); ++i) {
        if (real_column(level, i) != i || !is_cut({level, i, j}))
          continue;
        for (int b = j - 1; b <= j + 1; ++b)
          for (int a = i - 1; a <= i + 1; ++a) {
            const std::size_t inside = place({level, a, b});
            if (inside == nowhere)
              continue;
            std::uint8_t& parent =
                cut_[static_cast<std::size_t>(level) - 1][place({level - 1, a / 2, b / 2})];
            cut_for_balance_[static_cast<std::size_t>(level) - 1] += parent == 0 ? 1 : 0;
            parent = 1;
          }
      }
}

std::vector<Cell> Quadtree::leaves() const {
  std::vector<Cell> all;
  for (int level = 0; level <= finest(); ++level)
    for (int j = 0; j < rows(level); ++j)
      for (int i = 0; i < columns(level); ++i)
        if (is_leaf({level, i, j}))
          all.push_back({level, i, j});
  return all;
}

bool Quadtree::has_leaf_in(int level, const Rectangle& box) const {
  const Range x = overlapped(box.x_min, box.x_max, roots_.x0, size(level), columns(level));
  const Range y = overlapped(box.y_min, box.y_max, roots_.y0, size(level), rows(level));
  for (int j = y.first; j < y.last; ++j)
    for (int i = x.first; i < x.last; ++i)
      if (is_leaf({level, i, j}))
        return true;
  return false;
}

int Quadtree::finest_in(const Rectangle& box) const {
  int level = finest();
  while (level > 0 && !has_leaf_in(level, box))
    --level;
  return level;
}

int Quadtree::coarsest_in(const Rectangle& box) const {
  int level = 0;
  while (level < finest() && !has_leaf_in(level, box))
    ++level;
  return level;
}

} // namespace tremolo::mesh
