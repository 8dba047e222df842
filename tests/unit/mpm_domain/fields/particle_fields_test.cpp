// A field of one's own is one line of a spec. No other file knows of it, and yet particles carry it wherever
// they go: it is sorted, cut, saved and resumed, and written (process/output/run_output_test.cpp).

#include "mpm_domain/particles/splitting.hpp"
#include "tests/support/no_traction.hpp"
#include "tests/support/saved_state.hpp"
#include "tests/unit/mpm_domain/graded/levels_in_x.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

/// With the field under test.
Spec tagged(Spec spec, OnCut on_cut = OnCut::copied) {
  spec.more_fields = {{.name = "tag", .unit = "1", .meaning = "where it comes from", .on_cut = on_cut}};
  return spec;
}

/// By the coarse particle of 0.5 m that this one is, or is a part of.
double tag_of(const Particles& p, std::size_t k) {
  return std::floor(2.0 * p.x_initial[k]) - 100.0 * std::floor(2.0 * p.y_initial[k]);
}

void set_tags(Domain& domain) {
  for (Particles& p : domain.sets)
    for (std::size_t k = 0; k < p.size(); ++k)
      p.more.front()[k] = tag_of(p, k);
}

TEST(ParticleFieldTable, NamesEveryFieldOnceWithItsUnit) {
  std::vector<std::string> names;
  for (const ParticleFieldDescription& line : particle_field_table()) {
    EXPECT_FALSE(line.unit.empty()) << line.name;
    EXPECT_FALSE(line.meaning.empty()) << line.name;
    EXPECT_NE(line.field, nullptr) << line.name;
    names.push_back(line.name);
  }
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
}

TEST(FieldOfOnesOwn, StaysWithItsParticleInASort) {
  Domain domain(tagged(test_support::elastic_box(6.0, 4.0, 1.0)));
  set_tags(domain);
  Particles& p = domain.sets.front();
  std::mt19937 random(2);
  std::uniform_real_distribution<double> way(-1.2, 1.2);
  for (std::size_t k = 0; k < p.size(); ++k) {
    p.x[k] += way(random);
    p.y[k] += way(random);
  }
  const std::vector<std::uint32_t> order = p.id;
  sort_particles(domain);
  EXPECT_NE(p.id, order);
  ASSERT_EQ(p.more.front().size(), p.size());
  for (std::size_t k = 0; k < p.size(); ++k)
    EXPECT_EQ(p.more.front()[k], tag_of(p, k));
}

class CutField : public testing::TestWithParam<OnCut> {};

TEST_P(CutField, IsSharedOrCopied) {
  const double share = GetParam() == OnCut::shared ? 0.25 : 1.0;
  Domain domain(tagged(test::levels_in_x(Transfer::apic), GetParam()));
  set_tags(domain);
  test::shift(domain, 3.6); // the interface goes through the block
  ASSERT_GT(split_particles(domain), 0U);
  sort_particles(domain);
  EXPECT_GT(domain.sets[0].size(), 0U);
  EXPECT_GT(domain.sets[1].size(), 0U);
  for (std::size_t s = 0; s < 2; ++s) {
    Particles& p = domain.sets[s];
    ASSERT_EQ(p.more.front().size(), p.size());
    for (std::size_t k = 0; k < p.size(); ++k)
      EXPECT_EQ(p.more.front()[k], (s == 0 ? 1.0 : share) * tag_of(p, k));
  }
}

INSTANTIATE_TEST_SUITE_P(Rules, CutField, testing::Values(OnCut::shared, OnCut::copied),
                         [](const auto& of) { return of.param == OnCut::shared ? "Shared" : "Copied"; });

/// A block that flies into finer cells, half of it cut when it is saved.
TEST(FieldOfOnesOwn, IsSavedUnderItsNameAndResumed) {
  const Spec spec = tagged(test::levels_in_x(Transfer::apic));
  Domain whole(spec);
  set_tags(whole);
  for (double& v : whole.sets.front().vx)
    v = 20.0;
  Stepper stepper(whole, 0.0, test_support::no_traction(whole));
  while (whole.sets[1].size() == 0)
    stepper.step();
  ASSERT_GT(whole.sets[0].size(), 0U);
  const test_support::SavedState saved = test_support::saved_state(whole, stepper);
  EXPECT_EQ(saved.numbers("soil0.tag"), whole.sets[0].more.front());
  EXPECT_EQ(saved.numbers("soil1.tag"), whole.sets[1].more.front());

  Domain again(spec);
  Stepper resumed(again, 0.0, test_support::no_traction(again));
  test_support::restore_state(saved, again, resumed);
  for (int step = 0; step < 40; ++step) {
    stepper.step();
    resumed.step();
  }
  expect_same(test_support::saved_state(whole, stepper), test_support::saved_state(again, resumed));
  for (const Particles& p : again.sets)
    for (std::size_t k = 0; k < p.size(); ++k)
      EXPECT_EQ(p.more.front()[k], tag_of(p, k));
}

} // namespace
} // namespace tremolo::mpm_domain
