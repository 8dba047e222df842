// The factor of a band matrix against a dense one.

#include "mpm_domain/lining/beam/band_matrix.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

TEST(BandMatrix, SolvesAsADenseOneDoes) {
  constexpr std::size_t size = 40;
  constexpr std::size_t width = 7;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  BandMatrix band(size, width);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = i > width ? i - width : 0; j <= i; ++j) {
      const double value = i == j ? 10.0 : entry(random);
      band.add(i, j, value);
      dense(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = value;
      dense(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(i)) = value;
    }
  Eigen::VectorXd right(size);
  for (double& value : right)
    value = entry(random);
  std::vector<double> x(right.begin(), right.end());
  band.factorise();
  band.solve(x);
  const Eigen::VectorXd exact = dense.llt().solve(right);
  for (std::size_t i = 0; i < size; ++i)
    EXPECT_NEAR(x[i], exact(static_cast<Eigen::Index>(i)), 1e-14);
}

TEST(BandMatrix, RefusesAMatrixThatIsNotPositive) {
  BandMatrix band(2, 1);
  band.add(0, 0, 1.0);
  band.add(1, 0, 2.0);
  band.add(1, 1, 1.0);
  EXPECT_THROW(band.factorise(), std::runtime_error);
}

} // namespace
} // namespace tremolo::mpm_domain
