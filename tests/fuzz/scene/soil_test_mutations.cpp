// Whatever is done to the text of a soil test, reading it gives a test or refuses it with located errors, and
// what has been read can be shown: it never crashes, hangs or lets another exception out.

#include "mutator.hpp"

#include "scene/errors.hpp"
#include "scene/soil_report.hpp"
#include "scene/soil_test.hpp"

#include <gtest/gtest.h>

#include <string>

namespace tremolo::scene {
namespace {

class SoilTestFuzz : public ::testing::TestWithParam<const char*> {};

TEST_P(SoilTestFuzz, MutationsAreReadOrRefused) {
  const std::string folder = TREMOLO_SOURCE_DIR "/cases/soiltests";
  const std::string name = GetParam();
  const std::string original = testing::file_text(folder + "/" + name + ".toml");
  ASSERT_FALSE(original.empty());
  const auto use =
      original.find("[target]") == std::string::npos ? SoilTestUse::test : SoilTestUse::calibration;
  testing::Mutator mutate(20261121);
  std::size_t good = 0;
  std::size_t refused = 0;
  for (int i = 0; i < 1000; ++i) {
    const std::string text = mutate(original);
    try {
      const auto file = parse_soil_test(text, "test.toml", folder, use);
      EXPECT_FALSE(scene::text(parameters_in_force(file.soil, "soil", file.values)).empty()) << text;
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
  EXPECT_GT(good, 50U); // the generator reaches both outcomes
  EXPECT_GT(refused, 50U);
}

INSTANTIATE_TEST_SUITE_P(Shipped, SoilTestFuzz,
                         ::testing::Values("pm4sand_dr55_cyclic", "hostun_calibration",
                                           "pm4sand_dr55_modulus"));

} // namespace
} // namespace tremolo::scene
