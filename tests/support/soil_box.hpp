#pragma once

// Linear elastic soil around a cavity on one lattice: bilinear cells, integrated over the particles that a
// domain would be filled with, and masses lumped at nodes. Places stay those of the start, so that statics is
// one linear system and dynamics a loop of a few lines: a second, independent user of lining contact.

#include "base/vector.hpp"
#include "mpm_domain/spec/lattice.hpp"
#include "mpm_domain/spec/plot.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tremolo::test_support {

struct SoilBox {
  struct Point {
    std::array<std::size_t, 4> nodes;
    std::array<Vector, 4> gradients; ///< of the hats, 1/m
    double area;
  };

  mpm_domain::Lattice lattice;
  std::vector<Point> points;
  std::vector<double> mass; ///< by node, kg/m
  double lame = 0.0;        ///< Pa
  double shear = 0.0;       ///< Pa

  double full = 0.0;                                            ///< mass of a node that soil fills, kg/m
  double empty() const { return 1e-9 * lattice.h * lattice.h; } ///< mass of a node without soil, kg/m
  Vector position(std::size_t node) const {
    const auto columns = static_cast<std::size_t>(lattice.nx);
    return {lattice.x0 + static_cast<double>(node % columns) * lattice.h,
            lattice.y0 + static_cast<double>(node / columns) * lattice.h};
  }
  bool at_edge(std::size_t node) const {
    const auto columns = static_cast<std::size_t>(lattice.nx);
    const std::size_t i = node % columns;
    const std::size_t j = node / columns;
    return i == 0 || j == 0 || i + 1 == columns || j + 1 == static_cast<std::size_t>(lattice.ny);
  }
  /// Stress that a displacement gradient brings: s_xx, s_yy, s_xy.
  std::array<double, 3> stress(double xx, double yy, double xy) const {
    return {lame * (xx + yy) + 2.0 * shear * xx, lame * (xx + yy) + 2.0 * shear * yy, shear * xy};
  }
  /// Forces of the stress on the nodes, N/m.
  std::vector<Vector> forces(const std::vector<double>& ux, const std::vector<double>& uy) const {
    std::vector<Vector> forces(mass.size());
    for (const Point& p : points) {
      double xx = 0.0;
      double yy = 0.0;
      double xy = 0.0;
      for (std::size_t a = 0; a < 4; ++a) {
        const auto [gx, gy] = p.gradients[a];
        xx += gx * ux[p.nodes[a]];
        yy += gy * uy[p.nodes[a]];
        xy += gy * ux[p.nodes[a]] + gx * uy[p.nodes[a]];
      }
      const auto [sxx, syy, sxy] = stress(xx, yy, xy);
      for (std::size_t a = 0; a < 4; ++a) {
        const auto [gx, gy] = p.gradients[a];
        Vector& f = forces[p.nodes[a]];
        f = {f.x - p.area * (gx * sxx + gy * sxy), f.y - p.area * (gx * sxy + gy * syy)};
      }
    }
    return forces;
  }
};

/// A square of soil with a cavity, cells of size h (m) from its lower left corner on, four particles a cell.
inline SoilBox soil_box(const Vector& corner, int cells, double h, const std::vector<Vector>& cavity,
                        double young, double poisson, double density) {
  SoilBox box;
  box.lattice = {.h = h, .x0 = corner.x, .y0 = corner.y, .nx = cells + 1, .ny = cells + 1, .first = 0};
  box.mass.assign(box.lattice.count(), 0.0);
  box.full = density * h * h;
  box.shear = young / (2.0 * (1.0 + poisson));
  box.lame = young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  const double width = cells * h;
  const std::vector<std::vector<Vector>> all{{corner,
                                              {corner.x + width, corner.y},
                                              {corner.x + width, corner.y + width},
                                              {corner.x, corner.y + width}}};
  const std::vector<std::vector<Vector>> holes{cavity};
  for (int j = 0; j < 2 * cells; ++j)
    for (int i = 0; i < 2 * cells; ++i) {
      const mpm_domain::Plot plot = mpm_domain::plot_of(all, holes, corner.x + (i + 0.5) * 0.5 * h,
                                                        corner.y + (j + 0.5) * 0.5 * h, 0.5 * h);
      if (plot.area < 1e-6 * h * h)
        continue;
      SoilBox::Point point{.nodes = {}, .gradients = {}, .area = plot.area};
      const double x = (plot.x - corner.x) / h - i / 2;
      const double y = (plot.y - corner.y) / h - j / 2;
      for (const int a : {0, 1, 2, 3}) {
        const int right = a % 2;
        const int up = a / 2;
        const double sx = right == 1 ? x : 1.0 - x;
        const double sy = up == 1 ? y : 1.0 - y;
        const auto at = static_cast<std::size_t>(a);
        point.nodes[at] = box.lattice.index(i / 2 + right, j / 2 + up);
        point.gradients[at] = {(2 * right - 1) * sy / h, (2 * up - 1) * sx / h};
        box.mass[point.nodes[at]] += density * plot.area * sx * sy;
      }
      box.points.push_back(point);
    }
  return box;
}

} // namespace tremolo::test_support
