// The particles that contact follows are all those of the soil near a body, on any mesh.

#include "mpm_domain/contact/contact_nodes.hpp"
#include "mpm_domain/domain.hpp"
#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using namespace test_support;

constexpr Vector centre{2.2, -11.7};
constexpr double radius = 2.5;

Spec round_body(bool graded) {
  Spec spec = flat_ground(60.0, 30.0, graded ? 1.0 : 0.5, {2000.0, 1e8, 0.3});
  if (graded)
    spec.refine = {{{-12.0, -24.0, 16.0, 0.0}, 1}};
  spec.structures = {structure(circle(centre, radius), 1000.0, 0.4)};
  return spec;
}

class NearParticles : public testing::TestWithParam<bool> {};

TEST_P(NearParticles, AreThoseWithinAMarginOfTheBody) {
  Domain domain(round_body(GetParam()));
  const BodySurface& surface = domain.contact.bodies().front().surface();
  const mesh::Rectangle box = surface.bounds();
  for (const double margin : {0.3, 1.3, 4.0, 9.0}) {
    ContactNodes contact;
    contact.follow_sort(domain, surface, margin);
    std::vector<std::pair<std::size_t, std::size_t>> followed, near;
    for (const NearParticle& p : contact.near())
      followed.emplace_back(p.set, p.index);
    for (std::size_t s = 0; s < domain.soil_sets; ++s)
      for (std::size_t k = 0; k < domain.sets[s].size(); ++k) {
        const double x = domain.sets[s].x[k];
        const double y = domain.sets[s].y[k];
        if (x > box.x_min - margin && x < box.x_max + margin && y > box.y_min - margin &&
            y < box.y_max + margin)
          near.emplace_back(s, k);
      }
    EXPECT_EQ(followed, near) << margin;
    EXPECT_GT(near.size(), margin > 1.0 ? 100U : 0U) << margin;
  }
}

/// Soil and body come towards each other by as much as each may move until the next sort. Those that may
/// enter are pushed out as if all near ones were looked at.
TEST_P(NearParticles, AreFollowedIfTheyMayEnterTheBody) {
  const auto pushed_out = [](const Spec& spec, const std::vector<NearParticle>& (ContactNodes::*of)() const,
                             std::size_t& looked_at) {
    Domain domain(spec);
    ContactNodes contact;
    contact.follow_sort(domain, domain.contact.bodies().front().surface(), domain.reach_of_structures());
    const double way = domain.sort_distance();
    for (Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k) {
        const Vector out = Vector{set.x[k], set.y[k]} - centre;
        const double share = way / std::sqrt(square(out));
        set.x[k] -= share * out.x;
        set.y[k] -= share * out.y;
      }
    const BodySurface grown(circle(centre, radius + way));
    looked_at = (contact.*of)().size();
    const PushedOut pushed = push_out(domain, grown, (contact.*of)());
    return std::pair(pushed.count, domain.sets);
  };
  std::size_t few = 0;
  std::size_t many = 0;
  const auto [some, sets] = pushed_out(round_body(GetParam()), &ContactNodes::may_enter, few);
  const auto [all, expected] = pushed_out(round_body(GetParam()), &ContactNodes::near, many);
  EXPECT_GT(all, 50);
  EXPECT_EQ(some, all);
  for (std::size_t s = 0; s < sets.size(); ++s) {
    EXPECT_EQ(sets[s].x, expected[s].x);
    EXPECT_EQ(sets[s].y, expected[s].y);
  }
  EXPECT_LT(2 * few, many);
}

INSTANTIATE_TEST_SUITE_P(Meshes, NearParticles, testing::Bool());

} // namespace
} // namespace tremolo::mpm_domain
