// With Legendre polynomials P_k over the record, V_k and D_k their discrete (trapezoidal) integrals:
//
//     a <- a - sum_k c_k P_k,   min |y - sum_k c_k Y_k|^2   subject to   sum_k c_k V_k(T) = v(T),
//
// y the velocity with Y = V, or the displacement with Y = D. The constraint gives c_0, since V_0(T) = T.

#include "motion/mend/process.hpp"

#include "motion/record.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace tremolo::motion {

namespace {

constexpr int most_degrees = 10;

struct Shape {
  std::vector<double> acceleration;
  std::vector<double> fitted;
  double last_velocity;
};

Shape shape(std::vector<double> acceleration, double dt, BaselineFit fit) {
  auto velocity = integrate(acceleration, dt);
  const double last = velocity.back();
  return {std::move(acceleration),
          fit == BaselineFit::velocity ? std::move(velocity) : integrate(velocity, dt), last};
}

std::vector<double> legendre(unsigned degree, std::size_t count) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i)
    values[i] = std::legendre(degree, -1.0 + 2.0 * static_cast<double>(i) / static_cast<double>(count - 1));
  return values;
}

Eigen::Map<const Eigen::VectorXd> column(const std::vector<double>& values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

} // namespace

std::vector<double> baseline_corrected(std::span<const double> acceleration, double dt, BaselineFit fit,
                                       int degree) {
  const int lowest = fit == BaselineFit::velocity ? 1 : 2;
  if (degree < lowest || degree > most_degrees)
    throw std::invalid_argument(
        fmt::format("baseline of degree {}, must be from {} to {}", degree, lowest, most_degrees));
  const std::size_t count = acceleration.size();
  if (count < static_cast<std::size_t>(degree) + 2)
    throw std::invalid_argument(
        fmt::format("a baseline of degree {} needs more than {} samples", degree, count));

  std::vector<Shape> shapes;
  for (int k = 0; k <= degree - lowest; ++k)
    shapes.push_back(shape(legendre(static_cast<unsigned>(k), count), dt, fit));
  const Shape motion = shape({acceleration.begin(), acceleration.end()}, dt, fit);
  const Shape& first = shapes.front();
  const double mean = motion.last_velocity / first.last_velocity;

  // The unknowns are those of the higher polynomials, each less the multiple of P_0 that the constraint
  // takes.
  const auto unknowns = static_cast<Eigen::Index>(shapes.size()) - 1;
  Eigen::MatrixXd basis(static_cast<Eigen::Index>(count), unknowns);
  Eigen::VectorXd taken(unknowns);
  for (Eigen::Index k = 0; k < unknowns; ++k) {
    const Shape& one = shapes[static_cast<std::size_t>(k) + 1];
    taken[k] = one.last_velocity / first.last_velocity;
    basis.col(k) = column(one.fitted) - taken[k] * column(first.fitted);
  }
  Eigen::VectorXd c = Eigen::VectorXd::Zero(unknowns);
  if (unknowns > 0)
    c = basis.colPivHouseholderQr().solve(column(motion.fitted) - mean * column(first.fitted));

  std::vector<double> corrected = motion.acceleration;
  Eigen::Map<Eigen::VectorXd> a(corrected.data(), static_cast<Eigen::Index>(count));
  a.array() -= mean - taken.dot(c);
  for (Eigen::Index k = 0; k < unknowns; ++k)
    a -= c[k] * column(shapes[static_cast<std::size_t>(k) + 1].acceleration);
  return corrected;
}

} // namespace tremolo::motion
