#include "seepage/elements.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <numbers>

namespace tremolo::seepage {

namespace {

constexpr double dry = 1e-3; ///< k_r far above the phreatic surface

/// Shape functions at a point of an element, with the share of its area that the point stands for.
struct Point {
  Eigen::Vector4d shape = Eigen::Vector4d::Zero();
  Eigen::Matrix<double, 4, 2> gradient = Eigen::Matrix<double, 4, 2>::Zero(); ///< 1/m
  double area = 0.0;                                                          ///< m2
};

/// @param r,s  of the parent square [-1, 1]^2
Point point_of_quadrilateral(const FlowProblem& problem, const Element& element, double r, double s) {
  constexpr std::array<std::array<double, 2>, 4> corners{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  Point point;
  Eigen::Matrix<double, 4, 2> parent;
  Eigen::Matrix<double, 4, 2> places;
  for (int i = 0; i < 4; ++i) {
    const auto& [cr, cs] = corners[static_cast<std::size_t>(i)];
    point.shape[i] = 0.25 * (1.0 + cr * r) * (1.0 + cs * s);
    parent.row(i) << 0.25 * cr * (1.0 + cs * s), 0.25 * cs * (1.0 + cr * r);
    const Vector& place = problem.nodes[element.nodes[static_cast<std::size_t>(i)]];
    places.row(i) << place.x, place.y;
  }
  const Eigen::Matrix2d jacobian = parent.transpose() * places;
  point.gradient = parent * jacobian.inverse().transpose();
  point.area = jacobian.determinant();
  return point;
}

/// @param shape  of the point: its three barycentric coordinates
Point point_of_triangle(const FlowProblem& problem, const Element& element, const Eigen::Vector3d& shape,
                        double share) {
  const Vector& a = problem.nodes[element.nodes[0]];
  const Vector& b = problem.nodes[element.nodes[1]];
  const Vector& c = problem.nodes[element.nodes[2]];
  const double twice = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
  Point point;
  point.shape.head<3>() = shape;
  point.gradient.topRows<3>() << (b.y - c.y) / twice, (c.x - b.x) / twice, (c.y - a.y) / twice,
      (a.x - c.x) / twice, (a.y - b.y) / twice, (b.x - a.x) / twice;
  point.area = share * 0.5 * twice;
  return point;
}

/// act(point) at the points of integration of an element.
template <typename Act>
void for_points(const FlowProblem& problem, const Element& element, const Act& act) {
  constexpr double gauss = std::numbers::inv_sqrt3;
  if (element.corners == 3) {
    for (int i = 0; i < 3; ++i)
      act(point_of_triangle(problem, element, 0.5 * (Eigen::Vector3d::Ones() - Eigen::Vector3d::Unit(i)),
                            1.0 / 3.0));
    return;
  }
  for (const double quarter_r : {-0.5, 0.5})
    for (const double quarter_s : {-0.5, 0.5})
      for (const double r : {-gauss, gauss})
        for (const double s : {-gauss, gauss}) {
          Point point = point_of_quadrilateral(problem, element, quarter_r + 0.5 * r, quarter_s + 0.5 * s);
          point.area *= 0.25;
          act(point);
        }
}

Point centre(const FlowProblem& problem, const Element& element) {
  return element.corners == 3 ? point_of_triangle(problem, element, Eigen::Vector3d::Constant(1.0 / 3.0), 1.0)
                              : point_of_quadrilateral(problem, element, 0.0, 0.0);
}

} // namespace

double relative_permeability(double psi, double transition) {
  return std::clamp(1.0 + (1.0 - dry) * psi / transition, dry, 1.0);
}

Eigen::Matrix4d full_conductance(const FlowProblem& problem, const Element& element) {
  Eigen::Matrix4d k = Eigen::Matrix4d::Zero();
  for_points(problem, element, [&](const Point& point) {
    k += point.area * element.permeability * point.gradient * point.gradient.transpose();
  });
  return k;
}

Eigen::Matrix4d conductance(const FlowProblem& problem, const Element& element, const Eigen::Matrix4d& full,
                            std::span<const double> heads) {
  Eigen::Vector4d psi; // a triangle repeats its last corner, whose shape function is then zero
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t node = element.nodes[std::min(i, element.corners - 1)];
    psi[static_cast<Eigen::Index>(i)] = heads[node] - problem.nodes[node].y;
  }
  if (psi.minCoeff() >= 0.0)
    return full;
  if (psi.maxCoeff() <= -problem.transition)
    return dry * full;
  Eigen::Matrix4d k = Eigen::Matrix4d::Zero();
  for_points(problem, element, [&](const Point& point) {
    const double reduced = relative_permeability(point.shape.dot(psi), problem.transition);
    k += point.area * element.permeability * reduced * point.gradient * point.gradient.transpose();
  });
  return k;
}

Vector gradient(const FlowProblem& problem, const Element& element, std::span<const double> heads) {
  const Point point = centre(problem, element);
  Vector sum;
  for (std::size_t i = 0; i < element.corners; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    sum.x += point.gradient(row, 0) * heads[element.nodes[i]];
    sum.y += point.gradient(row, 1) * heads[element.nodes[i]];
  }
  return sum;
}

double area(const FlowProblem& problem, const Element& element) {
  double sum = 0.0;
  for_points(problem, element, [&](const Point& point) { sum += point.area; });
  return sum;
}

} // namespace tremolo::seepage
