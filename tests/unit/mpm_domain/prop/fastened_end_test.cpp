// An end of a prop goes with its point of a body that moves and turns as a whole, and its force has the sum
// and the moment that it has at that point.

#include "mpm_domain/prop/fastened_end.hpp"

#include "mpm_domain/domain.hpp"
#include "mpm_domain/transfer/scatter.hpp"
#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using test_support::flat_ground;
using test_support::rectangle;
using test_support::structure;

/// Ground of cells of 0.5 m with a body in the air, elastic or rigid.
Spec with_body(bool elastic) {
  Spec spec = flat_ground(12.0, 4.0, 0.5, {2000.0, 2e8, 0.2});
  spec.structures = {structure(rectangle(-1.1, 2.0, 0.9, 6.0), 2000.0, 0.5)};
  if (elastic)
    spec.structures.front().stiffness = Stiffness{5e8, 0.3};
  return spec;
}

Spec refined() {
  Spec spec = with_body(false);
  spec.refine = {{{-6.0, -2.0, 1.0, 0.0}, 1}};
  return spec;
}

struct EndCase {
  const char* name;
  Spec spec;
  PropFastening fastening;
};

std::vector<EndCase> nodal_ends() {
  return {{"on the side of an elastic body", with_body(true), {"block", {0.9, 3.3}}},
          {"in its corner", with_body(true), {"block", {-1.1, 6.0}}},
          {"in the ground", with_body(false), {"", {1.3, -1.7}}},
          {"at the surface", with_body(false), {"", {1.3, 0.0}}},
          {"between levels", refined(), {"", {1.0, -1.9}}}};
}

TEST(FastenedEnd, StandsAtItsPoint) {
  for (const EndCase& one : nodal_ends()) {
    Domain domain(one.spec);
    const FastenedEnd end(one.fastening, domain, domain.contact);
    const Vector at = end.position(domain, domain.contact);
    EXPECT_NEAR(at.x, one.fastening.position.x, 1e-12) << one.name;
    EXPECT_NEAR(at.y, one.fastening.position.y, 1e-12) << one.name;
  }
}

TEST(FastenedEnd, ReadsLinearVelocities) {
  for (const EndCase& one : nodal_ends()) {
    Domain domain(one.spec);
    FastenedEnd end(one.fastening, domain, domain.contact);
    const auto [x, y] = one.fastening.position;
    for (int l = 0; l < domain.lattice_count(); ++l) {
      const Lattice& lattice = domain.lattice(l);
      for (int j = 0; j < lattice.ny; ++j)
        for (int i = 0; i < lattice.nx; ++i) {
          const std::size_t n = lattice.index(i, j);
          domain.grid.vx_after[n] =
              0.3 + 0.02 * (lattice.x0 + i * lattice.h) - 0.5 * (lattice.y0 + j * lattice.h);
          domain.grid.vy_after[n] =
              -0.1 + 0.5 * (lattice.x0 + i * lattice.h) + 0.04 * (lattice.y0 + j * lattice.h);
        }
    }
    end.follow(domain);
    const Vector v = end.velocity(domain, domain.contact);
    EXPECT_NEAR(v.x, 0.3 + 0.02 * x - 0.5 * y, 1e-12) << one.name;
    EXPECT_NEAR(v.y, -0.1 + 0.5 * x + 0.04 * y, 1e-12) << one.name;
  }
}

TEST(FastenedEnd, GivesItsForceItsMoment) {
  for (const EndCase& one : nodal_ends()) {
    Domain domain(one.spec);
    FastenedEnd end(one.fastening, domain, domain.contact);
    const Vector force{3e3, -7e3};
    end.follow(domain);
    end.pull_nodes(domain, force);
    Vector sum;
    double moment = 0.0;
    for (int l = 0; l < domain.lattice_count(); ++l) {
      const Lattice& lattice = domain.lattice(l);
      for (int j = 0; j < lattice.ny; ++j)
        for (int i = 0; i < lattice.nx; ++i) {
          const std::size_t n = lattice.index(i, j);
          const Vector f{domain.grid.force_x[n], domain.grid.force_y[n]};
          sum = sum + f;
          moment += cross({lattice.x0 + i * lattice.h, lattice.y0 + j * lattice.h}, f);
        }
    }
    EXPECT_NEAR(sum.x, force.x, 1e-9) << one.name;
    EXPECT_NEAR(sum.y, force.y, 1e-9) << one.name;
    EXPECT_NEAR(moment, cross(one.fastening.position, force), 1e-7) << one.name;
  }
}

TEST(FastenedEnd, MovesWithNoLessMassThanItsBound) {
  for (const EndCase& one : nodal_ends()) {
    Domain domain(one.spec);
    FastenedEnd end(one.fastening, domain, domain.contact);
    scatter(domain, ScatterPart::motion);
    end.follow(domain);
    end.pull_nodes(domain, {1.0, 0.0});
    for (std::size_t n = 0; n < domain.grid.size(); ++n)
      domain.grid.vx_after[n] =
          domain.grid.mass[n] > 0.0 ? domain.grid.force_x[n] / domain.grid.mass[n] : 0.0;
    const double mobility = end.velocity(domain, domain.contact).x;
    EXPECT_LE(mobility, (1.0 + 1e-12) * end.mobility()) << one.name;
    EXPECT_GT(mobility, 0.2 * end.mobility()) << one.name;
  }
}

TEST(FastenedEnd, TurnsWithARigidBody) {
  Domain domain(with_body(false));
  const FastenedEnd end({"block", {0.9, 6.0}}, domain, domain.contact);
  EXPECT_EQ(end.body(), 0U);
  test_support::set_bodies(domain, {{1.0, 5.0, 0.5 * std::acos(-1.0), 0.2, 0.0, 3.0}}); // a quarter turn
  const Vector at = end.position(domain, domain.contact); // its arm was (1, 2) m, is now (-2, 1) m
  EXPECT_NEAR(at.x, -1.0, 1e-12);
  EXPECT_NEAR(at.y, 6.0, 1e-12);
  const Vector v = end.velocity(domain, domain.contact);
  EXPECT_NEAR(v.x, 0.2 - 3.0 * 1.0, 1e-12);
  EXPECT_NEAR(v.y, -3.0 * 2.0, 1e-12);
}

TEST(FastenedEnd, NeedsSomethingToHoldOnTo) {
  Domain domain(with_body(true));
  EXPECT_THROW(FastenedEnd({"", {0.0, 1.5}}, domain, domain.contact), std::invalid_argument);
  EXPECT_THROW(FastenedEnd({"block", {3.0, 3.0}}, domain, domain.contact), std::invalid_argument);
  EXPECT_THROW(FastenedEnd({"tower", {0.0, 3.0}}, domain, domain.contact), std::invalid_argument);
}

} // namespace
} // namespace tremolo::mpm_domain
