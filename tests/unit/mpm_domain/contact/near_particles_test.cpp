// The particles that contact follows are all those of the soil near a body, on any mesh.

#include "mpm_domain/contact/contact_nodes.hpp"
#include "mpm_domain/domain.hpp"
#include "tests/support/structure_scene.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

using namespace test_support;

class NearParticles : public testing::TestWithParam<bool> {};

TEST_P(NearParticles, AreThoseWithinAMarginOfTheBody) {
  Spec spec = flat_ground(60.0, 30.0, GetParam() ? 1.0 : 0.5, {2000.0, 1e8, 0.3});
  if (GetParam())
    spec.refine = {{{-12.0, -24.0, 16.0, 0.0}, 1}};
  spec.structures = {structure(circle({2.2, -11.7}, 2.5), 1000.0, 0.4)};
  Domain domain(spec);
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

INSTANTIATE_TEST_SUITE_P(Meshes, NearParticles, testing::Bool());

} // namespace
} // namespace tremolo::mpm_domain
