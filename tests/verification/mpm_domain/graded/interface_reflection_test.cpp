// What a level interface reflects of a harmonic wave, of the discretisation alone: lumped mass M and
// stiffness K = sum V G^T D G of the particles where they stand, no transfers and no time steps,
//
//     (omega^2 M - K) u = 0        between discrete waves  e^(iky) + R e^(-iky)  below and  T e^(iky)  above.
//
// A lumped chain of cells of size h has k = (2/h) asin(x), x = omega h/(2c), and the impedance rho c sqrt(1 -
// x^2), lower the coarser it is, so that an interface between h and h/2 reflects, from either side,
//
//     |R| = (sqrt(1 - x^2/4) - sqrt(1 - x^2)) / (sqrt(1 - x^2/4) + sqrt(1 - x^2)),      x = pi/N,
//
// with N coarse cells a (long) wave length: (3/16)(pi/N)^2.

#include "mpm_domain/step/grid_update.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/elastic_forces.hpp"
#include "tests/verification/mpm_domain/graded/level_interface.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using Complex = std::complex<double>;

constexpr double half = 6.0;  // of the strip on either side of the interface at y = 0, m
constexpr double near = 1e-6; // m

/// A degree of freedom of the grid.
struct Freedom {
  std::size_t node = 0;
  NodeField Grid::*velocity = nullptr;
  NodeField Grid::*force = nullptr;
  bool is_transverse = false; ///< along x
  double y = 0.0;             ///< m
};

/// Those of all nodes that have mass and are not tied.
std::vector<Freedom> freedoms(const Domain& domain) {
  const Grid& grid = domain.grid;
  std::vector<Freedom> all;
  for (int level = 0; level < domain.lattice_count(); ++level) {
    const Lattice& lattice = domain.lattice(level);
    for (int j = 0; j < lattice.ny; ++j)
      for (int i = 0; i < lattice.nx; ++i) {
        const std::size_t node = lattice.index(i, j);
        if (grid.mass[node] <= empty_mass(domain))
          continue;
        const double y = lattice.y0 + j * lattice.h;
        all.push_back({node, &Grid::vx_after, &Grid::force_x, true, y});
        all.push_back({node, &Grid::vy_after, &Grid::force_y, false, y});
      }
  }
  return all;
}

/// -K, by the domain's own passes: forces of unit displacements, so small that volumes stay as they are.
Eigen::MatrixXd stiffness_forces(Domain& domain, const std::vector<Freedom>& all) {
  constexpr double unit = 1e-12;
  Grid& grid = domain.grid;
  const auto count = static_cast<Eigen::Index>(all.size());
  Eigen::MatrixXd forces(count, count);
  for (Eigen::Index column = 0; column < count; ++column) {
    std::ranges::fill(grid.vx_after, 0.0);
    std::ranges::fill(grid.vy_after, 0.0);
    const Freedom& moved = all[static_cast<std::size_t>(column)];
    (grid.*moved.velocity)[moved.node] = unit;
    test_support::elastic_forces(domain);
    for (Eigen::Index row = 0; row < count; ++row) {
      const Freedom& felt = all[static_cast<std::size_t>(row)];
      forces(row, column) = (grid.*felt.force)[felt.node] / unit;
    }
  }
  return forces;
}

/// The strip between its two ends, where waves are known.
struct Strip {
  std::vector<Freedom> freedoms;
  Eigen::VectorXd mass;
  Eigen::MatrixXd forces;
  double h_below = 0.0, h_above = 0.0; ///< cell sizes, m
  materials::Elasticity soil;
};

Strip assembled(bool is_fine_below) {
  Domain domain(level_interface(half, is_fine_below));
  scatter(domain, ScatterPart::motion);
  Strip result;
  result.freedoms = freedoms(domain);
  result.mass.resize(static_cast<Eigen::Index>(result.freedoms.size()));
  for (std::size_t i = 0; i < result.freedoms.size(); ++i)
    result.mass[static_cast<Eigen::Index>(i)] = domain.grid.mass[result.freedoms[i].node];
  result.forces = stiffness_forces(domain, result.freedoms);
  result.h_below = is_fine_below ? 0.5 * h : h;
  result.h_above = is_fine_below ? h : 0.5 * h;
  result.soil = materials::elasticity(domain.spec.soils.front().law);
  return result;
}

struct Reflection {
  double amplitude = 0.0;
  double residual = 0.0; ///< of the equations, relative: zero where the waves at the ends are exact
};

Reflection reflection(const Strip& strip, Body wave, double cells) {
  const bool transverse = wave == Body::sv;
  const double c = transverse ? strip.soil.s_wave_speed() : strip.soil.p_wave_speed();
  const double omega = 2.0 * std::numbers::pi * c / (cells * h);
  const auto travelling = [&](double size, double y) {
    return std::polar(1.0, 2.0 / size * std::asin(0.5 * omega * size / c) * y);
  };
  // u = known + unknown X, where X holds R, T and the displacements between the ends.
  const auto count = static_cast<Eigen::Index>(strip.freedoms.size());
  Eigen::VectorXcd known = Eigen::VectorXcd::Zero(count);
  Eigen::MatrixXcd unknown = Eigen::MatrixXcd::Zero(count, count + 2);
  std::vector<Eigen::Index> equations;
  Eigen::Index next = 2;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Freedom& freedom = strip.freedoms[static_cast<std::size_t>(i)];
    if (std::abs(freedom.y) < half - near)
      equations.push_back(i);
    const bool moves = freedom.is_transverse == transverse;
    if (freedom.y < -half + strip.h_below + near) {
      known[i] = moves ? travelling(strip.h_below, freedom.y) : 0.0;
      unknown(i, 0) = moves ? travelling(strip.h_below, -freedom.y) : 0.0;
    } else if (freedom.y > half - strip.h_above - near) {
      unknown(i, 1) = moves ? travelling(strip.h_above, freedom.y) : 0.0;
    } else {
      unknown(i, next++) = 1.0;
    }
  }
  const Eigen::MatrixXcd motion =
      strip.forces + Eigen::MatrixXd(omega * omega * strip.mass.asDiagonal()).eval();
  const Eigen::MatrixXcd rows = motion(equations, Eigen::all);
  const Eigen::MatrixXcd matrix = rows * unknown.leftCols(next);
  const Eigen::VectorXcd right = -rows * known;
  const Eigen::VectorXcd x = matrix.colPivHouseholderQr().solve(right);
  return {std::abs(x[0]), (matrix * x - right).norm() / right.norm()};
}

class LevelInterface : public testing::TestWithParam<Arrival> {};

TEST_P(LevelInterface, ReflectsWhatTheImpedancesOfItsCellsSay) {
  const auto [wave, is_fine_below] = GetParam();
  const Strip strip = assembled(is_fine_below);
  for (const double cells : {8.0, 10.0, 15.0, 20.0}) {
    const double closed = reflected_by_impedances(cells);
    const Reflection found = reflection(strip, wave, cells);
    EXPECT_NEAR(found.amplitude, closed, 1e-4 * closed) << cells << " coarse cells a wave length";
    EXPECT_LT(found.residual, 1e-6) << "the ends do not let waves pass";
  }
}

INSTANTIATE_TEST_SUITE_P(Waves, LevelInterface, every_arrival(), name_of_arrival);

} // namespace
} // namespace tremolo::mpm_domain
