#include "mpm_domain/grid/box_average.hpp"

#include <span>

namespace tremolo::mpm_domain {

namespace {

/// |part|/|all| along one direction, 1 where `all` is a point.
double fraction(double part, double all) {
  return all > 0.0 ? part / all : 1.0;
}

} // namespace

void box_average(const GradedMesh& mesh, const mesh::Rectangle& box, std::vector<BoxWeight>& weights) {
  mesh.for_parts(box, [&](const mesh::Cell& cell, const mesh::Rectangle& part) {
    const mesh::Rectangle all = mesh.tree().rectangle(cell);
    const double h = mesh.tree().size(cell.level);
    const double share = fraction(part.x_max - part.x_min, box.x_max - box.x_min) *
                         fraction(part.y_max - part.y_min, box.y_max - box.y_min);
    const double xi = (0.5 * (part.x_min + part.x_max) - all.x_min) / h;
    const double eta = (0.5 * (part.y_min + part.y_max) - all.y_min) / h;
    for (int corner = 0; corner < 4; ++corner) {
      const bool right = corner % 2 == 1;
      const bool above = corner / 2 == 1;
      const double nx = right ? xi : 1.0 - xi;
      const double ny = above ? eta : 1.0 - eta;
      weights.push_back({mesh.node(cell.level, cell.i + corner % 2, cell.j + corner / 2),
                         right ? all.x_max : all.x_min, above ? all.y_max : all.y_min, share * nx * ny,
                         share * (right ? ny : -ny) / h, share * (above ? nx : -nx) / h});
    }
  });
}

SecondMoments second_moments(const GradedMesh& mesh, const mesh::Rectangle& box) {
  std::vector<BoxWeight> weights;
  box_average(mesh, box, weights);
  SecondMoments d;
  const auto add = [&](double s, double x, double y) {
    const double dx = x - 0.5 * (box.x_min + box.x_max);
    const double dy = y - 0.5 * (box.y_min + box.y_max);
    d.x += s * dx * dx;
    d.y += s * dy * dy;
  };
  for (const BoxWeight& w : weights) {
    const std::span<const Share> shares = mesh.prolongation().shares_of(w.node);
    if (shares.empty())
      add(w.s, w.x, w.y);
    for (const Share& share : shares)
      add(share.weight * w.s, w.x + share.dx, w.y + share.dy);
  }
  return d;
}

} // namespace tremolo::mpm_domain
