// Whatever is done to the text of a soil test, reading it gives a test or refuses it with located errors, and
// what has been read can be shown: it never crashes, hangs or lets another exception out.

#include "read_or_refused.hpp"

#include "scene/soil_test.hpp"
#include "scene/soils/soil_report.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/repetitions.hpp"

namespace tremolo::scene {
namespace {

struct Shipped {
  const char* name;
  SoilTestUse use;
};

/// The name of a case in the list of tests.
void PrintTo(const Shipped& shipped, std::ostream* stream) {
  *stream << shipped.name;
}

class SoilTestFuzz : public ::testing::TestWithParam<Shipped> {};

TEST_P(SoilTestFuzz, MutationsAreReadOrRefused) {
  const std::string folder = source_dir() + "/cases/soiltests";
  const std::string path = folder + "/" + GetParam().name + ".toml";
  testing::expect_read_or_refused(
      path, 20261121, tremolo::test_support::repetitions(std::size_t{1000}), [&](const std::string& text) {
        const auto file = parse_soil_test(text, "test.toml", folder, GetParam().use);
        EXPECT_FALSE(scene::text(parameters_in_force(file.soil, "soil", file.values)).empty()) << text;
      });
}

INSTANTIATE_TEST_SUITE_P(Shipped, SoilTestFuzz,
                         ::testing::Values(Shipped{"pm4sand_dr55_cyclic", SoilTestUse::test},
                                           Shipped{"hostun_calibration", SoilTestUse::calibration},
                                           Shipped{"pm4sand_dr55_modulus", SoilTestUse::test}));

} // namespace
} // namespace tremolo::scene
