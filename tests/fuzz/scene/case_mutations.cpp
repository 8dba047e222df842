// Whatever is done to the text of a case, reading it gives a case or refuses it with located errors: it never
// crashes, hangs or lets another exception out. Mutations are drawn from a seeded generator; a failure prints
// the text.

#include "mutator.hpp"

#include "scene/case.hpp"
#include "scene/errors.hpp"
#include "scene/plan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace tremolo::scene {
namespace {

class CaseFuzz : public ::testing::TestWithParam<const char*> {};

TEST_P(CaseFuzz, MutationsAreReadOrRefused) {
  const std::string folder = std::string(TREMOLO_SOURCE_DIR "/cases/") + GetParam();
  const std::string original = testing::file_text(folder + "/case.toml");
  ASSERT_FALSE(original.empty());
  testing::Mutator mutate(20240119);
  std::size_t good = 0;
  std::size_t refused = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::string text = mutate(original);
    try {
      const auto scene = parse(text, "case.toml", folder);
      const auto planned = plan(scene);
      EXPECT_TRUE(std::isfinite(planned.dt) && planned.dt > 0.0) << text;
      ++good;
    } catch (const CaseErrors& errors) {
      EXPECT_FALSE(errors.errors().empty());
      for (const CaseError& error : errors.errors())
        EXPECT_FALSE(error.text.empty());
      ++refused;
    } catch (const std::exception& error) {
      FAIL() << error.what() << "\n" << text;
    }
  }
  EXPECT_GT(good, 100U); // the generator reaches both outcomes
  EXPECT_GT(refused, 100U);
}

INSTANTIATE_TEST_SUITE_P(Shipped, CaseFuzz, ::testing::Values("halfspace_box", "slope_oblique"));

} // namespace
} // namespace tremolo::scene
