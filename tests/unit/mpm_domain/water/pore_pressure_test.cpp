// What pore pressures take up is what the water's force does, no water is lost, and the filter of the
// increments is self-adjoint: it cannot add energy.

#include "mpm_domain/clocks/clock_nodes.hpp"
#include "mpm_domain/grid/tied_nodes.hpp"
#include "mpm_domain/particles/water/pore_volume.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/prop/particle_nodes.hpp"
#include "mpm_domain/tiles/cell_means.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "mpm_domain/water/mixture_update.hpp"
#include "mpm_domain/water/pore_pressure.hpp"
#include "mpm_domain/water/water_scatter.hpp"
#include "tests/support/box_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

namespace tremolo::mpm_domain {
namespace {

struct Mesh {
  const char* name;
  bool periodic = false;
  bool graded = false;
  bool boxes_follow = false;
};

class PorePressure : public testing::TestWithParam<Mesh> {
protected:
  /// A saturated box of two porosities, whose particles lie anywhere by up to a tenth of a cell.
  static Spec wet_spec() {
    Spec spec = test_support::elastic_box(8.0, 6.0, 1.0);
    spec.gravity = 9.81;
    spec.water = {0.0, {}};
    spec.soils.front().pores = {.porosity = 0.35, .grain_density = 2650.0, .permeability = 1e-3};
    Soil loose = spec.soils.front();
    loose.pores->porosity = 0.5;
    spec.soils.push_back(loose);
    spec.regions.push_back({1, {{2.0, -4.0}, {6.0, -4.0}, {6.0, -1.0}, {2.0, -1.0}}});
    if (GetParam().periodic)
      spec.sides = Sides::periodic;
    if (GetParam().graded)
      spec.refine = {{{2.0, -3.0, 5.0, 0.0}, 1}};
    if (GetParam().boxes_follow)
      spec.boxes = ParticleBoxes::deforming;
    return spec;
  }

  PorePressure() : domain(wet_spec()) { disturb(domain); }

  static void disturb(Domain& domain) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> jitter(-0.1, 0.1);
    for (Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k) {
        set.x[k] += jitter(random) * set.cell_size;
        set.y[k] += jitter(random) * set.cell_size;
        set.pore_pressure[k] = rest_pressure(set, k);
      }
    sort_particles(domain);
    scatter(domain, ScatterPart::motion);
  }

  /// Velocities of grains and water at random (m/s), and the flux of both; tied nodes follow.
  static void set_flow(Domain& domain, unsigned seed, double size) {
    std::mt19937 random(seed);
    std::normal_distribution<double> speed(0.0, 1.0);
    Grid& grid = domain.grid;
    for (NodeField* field : {&grid.vx_after, &grid.vy_after, &grid.wx_after, &grid.wy_after})
      for (double& v : *field)
        v = size * speed(random);
    find_flux(domain, domain.soil_rows);
    prolong(domain, NodeGroup::volume_flux);
  }

  /// The cell of each particle of a set: the node that it begins at.
  std::vector<std::size_t> cells(std::size_t s) const {
    const CellFinder finder = domain.mesh ? CellFinder(*domain.mesh) : CellFinder(domain.tiles, 0);
    std::vector<std::size_t> all;
    for (std::size_t k = 0; k < domain.sets[s].size(); ++k)
      all.push_back(finder.at(domain.sets[s].x[k], domain.sets[s].y[k]).node);
    return all;
  }

  /// What particles read of the means at nodes, A C e.
  std::vector<std::vector<double>> read_means() const {
    std::vector<std::vector<double>> all;
    for (std::size_t s = 0; s < domain.sets.size(); ++s) {
      all.emplace_back();
      for (std::size_t k = 0; k < domain.sets[s].size(); ++k) {
        std::vector<NodeShare> nodes;
        add_nodes(domain, s, k, 1.0, nodes);
        double& read = all.back().emplace_back(0.0);
        for (const NodeShare& of : nodes)
          read += of.share * domain.grid.compression[of.node];
      }
    }
    return all;
  }

  /// Changes of the pressures in the flow of a seed, whose velocities have this size (m/s).
  std::vector<std::vector<double>> changes(unsigned seed, double size = 1.0) {
    return changes_of(domain, seed, size);
  }
  static std::vector<std::vector<double>> changes_of(Domain& domain, unsigned seed, double size) {
    std::vector<std::vector<double>> before;
    for (const Particles& set : domain.sets)
      before.push_back(set.pore_pressure);
    const ClockNodes nodes(domain);
    scatter_mixture(domain, nodes.of(0), nodes.ties_of(0));
    set_flow(domain, seed, size);
    update_pressures(domain, dt, domain.grid.flux_x, domain.grid.flux_y, nodes.of(0), nodes.ties_of(0));
    for (std::size_t s = 0; s < domain.sets.size(); ++s)
      for (std::size_t k = 0; k < domain.sets[s].size(); ++k)
        before[s][k] = std::exchange(domain.sets[s].pore_pressure[k], before[s][k]) - before[s][k];
    return before;
  }

  template <typename Of>
  double sum(const Of& of) const {
    double total = 0.0;
    for (std::size_t s = 0; s < domain.sets.size(); ++s)
      for (std::size_t k = 0; k < domain.sets[s].size(); ++k)
        total += of(s, k);
    return total;
  }

  static constexpr double dt = 1e-4;            // s
  static constexpr double bulk_modulus = 2.2e9; // Pa
  Domain domain;
};

/// sum V theta = sum of the flux times the force of a pressure of 1.
TEST_P(PorePressure, IsTheDualOfTheForceOfWater) {
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      set.pore_pressure[k] = rest_pressure(set, k) + std::sin(3.0 * set.x[k] + 2.0 * set.y[k]);
  std::vector<std::vector<double>> excess;
  for (const Particles& set : domain.sets) {
    excess.emplace_back();
    for (std::size_t k = 0; k < set.size(); ++k)
      excess.back().push_back(excess_pressure(set, k));
  }
  changes(1);
  const Grid& grid = domain.grid;
  double of_force = 0.0;
  double size = 0.0;
  for (std::size_t n = 0; n < grid.size(); ++n) {
    const double power = grid.water_force_x[n] * grid.flux_x[n] + grid.water_force_y[n] * grid.flux_y[n];
    of_force += power;
    size += std::abs(power);
  }
  const double of_pressure =
      sum([&](auto s, auto k) { return excess[s][k] * domain.waiting_pressures[s].compression[k]; });
  EXPECT_NEAR(-dt * of_force, of_pressure, 1e-12 * dt * size);
}

TEST_P(PorePressure, LosesNoWater) {
  const auto change = changes(2);
  const auto stored =
      sum([&](auto s, auto k) { return pore_volume(domain.sets[s], k) * change[s][k] / bulk_modulus; });
  const auto compressed = sum([&](auto s, auto k) { return domain.waiting_pressures[s].compression[k]; });
  const auto size = sum([&](auto s, auto k) { return std::abs(domain.waiting_pressures[s].compression[k]); });
  EXPECT_NEAR(stored, compressed, 1e-13 * size);
}

/// One pass brings the sums of soil and water to the nodes: of every kind, as much as the particles have.
TEST_P(PorePressure, NodesShareOutWhatParticlesBring) {
  for (Particles& set : domain.sets) {
    std::ranges::fill(set.wx, 0.3);
    std::ranges::fill(set.vx, -0.2);
  }
  const ClockNodes nodes(domain);
  scatter_mixture(domain, nodes.of(0), nodes.ties_of(0));
  const Grid& grid = domain.grid;
  const auto at_nodes = [](const NodeField& field) {
    return std::accumulate(field.begin(), field.end(), 0.0);
  };
  const double volume = sum([&](auto s, auto k) { return domain.sets[s].volume[k]; });
  const double pores = sum([&](auto s, auto k) { return pore_volume(domain.sets[s], k); });
  const double mass = sum([&](auto s, auto k) { return domain.sets[s].mass[k]; });
  const double buoyancy = sum([&](auto s, auto k) {
    return (1.0 - domain.sets[s].weight_share) * domain.spec.gravity * domain.sets[s].mass[k];
  });
  EXPECT_GT(buoyancy, 0.0);
  EXPECT_NEAR(at_nodes(grid.mass), mass, 1e-12 * mass);
  EXPECT_NEAR(at_nodes(grid.momentum_x), -0.2 * mass, 1e-12 * mass);
  EXPECT_NEAR(at_nodes(grid.buoyancy), buoyancy, 1e-12 * buoyancy);
  EXPECT_NEAR(at_nodes(grid.pore_volume), pores, 1e-12 * pores);
  EXPECT_NEAR(at_nodes(grid.wet_volume), volume, 1e-12 * volume);
  EXPECT_NEAR(at_nodes(grid.water_mass), 1000.0 * pores, 1e-9 * pores);
  EXPECT_NEAR(at_nodes(grid.water_momentum_x), 300.0 * pores, 1e-9 * pores);
}

/// With a and b what two flows compress, a . F b = b . F a and a . F a >= 0. Without the last mean of cells,
/// A C in place of C A C, it is not.
TEST_P(PorePressure, FilterIsSelfAdjoint) {
  const auto compressions = [&] {
    std::vector<std::vector<double>> all;
    for (const WaitingPressures& of_set : domain.waiting_pressures)
      all.push_back(of_set.compression);
    return all;
  };
  const auto change_a = changes(3);
  const auto a = compressions();
  const auto wrong_a = read_means();
  const auto change_b = changes(4);
  const auto b = compressions();
  const auto wrong_b = read_means();
  const auto product = [&](const auto& x, const auto& y) {
    return sum([&](auto s, auto k) { return x[s][k] * y[s][k]; });
  };
  const double size = std::sqrt(product(a, change_a) * product(b, change_b));
  EXPECT_GT(product(a, change_a), 0.0);
  EXPECT_GT(product(b, change_b), 0.0);
  EXPECT_NEAR(product(a, change_b), product(b, change_a), 1e-12 * size);
  const double wrong_size = std::sqrt(std::abs(product(a, wrong_a) * product(b, wrong_b)));
  EXPECT_GT(std::abs(product(a, wrong_b) - product(b, wrong_a)), 1e-3 * wrong_size);
}

/// Excess pressures that differ within cells take the mean of these. That loses no water, gives no energy,
/// and is all that happens where nothing flows.
TEST_P(PorePressure, CellsEvenOut) {
  std::mt19937 random(6);
  std::normal_distribution<double> excess(0.0, 1e4);
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      set.pore_pressure[k] = rest_pressure(set, k) + excess(random);
  const auto pores = [&](auto s, auto k) { return pore_volume(domain.sets[s], k); };
  const auto of = [&](auto s, auto k) {
    return domain.sets[s].pore_pressure[k] - rest_pressure(domain.sets[s], k);
  };
  const auto change = changes(6, 0.0);
  const auto after = [&](auto s, auto k) { return of(s, k) + change[s][k]; };
  const auto energy = [&](const auto& p) {
    return sum([&](auto s, auto k) { return pores(s, k) * p(s, k) * p(s, k); });
  };
  const double size = sum([&](auto s, auto k) { return pores(s, k) * std::abs(of(s, k)); });
  EXPECT_NEAR(sum([&](auto s, auto k) { return pores(s, k) * change[s][k]; }), 0.0, 1e-13 * size);
  EXPECT_LT(energy(after), 0.5 * energy(of)); // some four particles a cell
  for (std::size_t s = 0; s < domain.sets.size(); ++s) {
    const std::vector<std::size_t> cell = cells(s);
    for (std::size_t k = 1; k < cell.size(); ++k) {
      const auto same = static_cast<std::size_t>(std::ranges::find(cell, cell[k]) - cell.begin());
      EXPECT_NEAR(after(s, k), after(s, same), 1e-12 * 1e5);
    }
  }
}

/// A pressure is that of its cell.
TEST_P(PorePressure, IsTheSameThroughoutACell) {
  const auto change = changes(5);
  for (std::size_t s = 0; s < domain.sets.size(); ++s) {
    const std::vector<std::size_t> cell = cells(s);
    for (std::size_t k = 0; k < cell.size(); ++k)
      for (std::size_t l = 0; l < k; ++l)
        if (cell[k] == cell[l]) {
          EXPECT_NEAR(change[s][k], change[s][l], 1e-12 * std::abs(change[s][k]));
        }
  }
}

/// Runs follow each other through their tile. Each lies in one cell, and has of its nodes the shares that its
/// particles have one by one.
TEST_P(PorePressure, RunsHaveTheSharesOfTheirParticles) {
  changes(8);
  std::size_t runs = 0;
  std::size_t particles = 0;
  for (std::size_t tile = 0; tile < domain.tiles.count(); ++tile) {
    const Lattice& lattice = domain.tiles.lattice(domain.tiles.level_of(tile));
    const NodeBlock window = domain.tiles.window(tile);
    const auto place = [&](int column, int row) {
      return (row - window.row) * window_columns + column - window.column;
    };
    for (std::size_t s = 0; s < domain.sets.size(); ++s) {
      const Particles& set = domain.sets[s];
      const auto [begin, end] = set.in_block(domain.block(0, tile));
      if (begin == end)
        continue;
      const CellRuns& of_tile = domain.waiting_pressures[s].runs[tile];
      const Lanes* share = of_tile.shares();
      std::size_t k = begin;
      for (const CellRun& run : of_tile.all()) {
        ASSERT_LT(k, run.end);
        std::map<int, double> shares;
        double weight = 0.0;
        for (; k < run.end; ++k) {
          const Vector half = half_sides(set, k);
          const Weights x = cell_weights(set.x[k], {lattice.x0, lattice.h}, half.x);
          const Weights y = cell_weights(set.y[k], {lattice.y0, lattice.h}, half.y);
          EXPECT_EQ(run.cell, place(x.base + 1, y.base + 1));
          for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i)
              shares[place(x.base + i, y.base + j)] += pore_volume(set, k) * x.s[i] * y.s[j];
          weight += pore_volume(set, k);
          ++particles;
        }
        EXPECT_NEAR(run.weight, weight, 1e-14 * weight);
        for (int row = 0; row < (set.has_own_boxes() ? 4 : 3); ++row, ++share)
          for (int i = 0; i < 4; ++i)
            EXPECT_NEAR((*share)[i], std::exchange(shares[run.first + row * window_columns + i], 0.0),
                        1e-14 * weight);
        for (const auto& [node, left] : shares)
          EXPECT_NEAR(left, 0.0, 1e-14 * weight) << "beyond the nodes of the run";
        ++runs;
      }
      EXPECT_EQ(k, end);
    }
  }
  EXPECT_GT(2 * particles, 3 * runs); // four particles a cell, in two rows of boxes at least
}

/// Bits do not depend on the number of threads.
TEST_P(PorePressure, IsTheSameForAnyNumberOfThreads) {
  Spec spec = wet_spec();
  spec.threads = 1;
  Domain alone(spec);
  disturb(alone);
  EXPECT_EQ(changes_of(alone, 9, 1.0), changes(9));
}

INSTANTIATE_TEST_SUITE_P(Meshes, PorePressure,
                         testing::Values(Mesh{"Uniform"}, Mesh{"Periodic", true}, Mesh{"Graded", false, true},
                                         Mesh{"PeriodicGraded", true, true},
                                         Mesh{"OwnBoxes", false, false, true}),
                         [](const auto& mesh) { return mesh.param.name; });

} // namespace
} // namespace tremolo::mpm_domain
