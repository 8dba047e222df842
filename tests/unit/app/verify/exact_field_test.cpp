// Which cases have the half-space field as their exact solution.

#include "app/verify/exact_field.hpp"

#include "tests/support/exact_run.hpp"

#include <gmock/gmock.h>

namespace {

using namespace tremolo;
using ::testing::Eq;
using ::testing::Optional;
using tremolo::testing::exact_case;
using tremolo::testing::exact_case_with;

std::optional<std::string> reason(const std::string& text) {
  return app::why_not_exact(scene::parse(text, "case.toml", "."));
}

TEST(ExactField, IsKnownOfLevelUniformElasticGround) {
  EXPECT_EQ(reason(exact_case), std::nullopt);
  // The same soil in two regions, and the half-space by its wave speeds.
  EXPECT_EQ(reason(exact_case_with("polygon = [[0.0, -10.0], [20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]",
                                   "polygon = [[0.0, -10.0], [20.0, -10.0], [20.0, -4.0], [0.0, -4.0]]\n"
                                   "[[region]]\nsoil = \"sand\"\n"
                                   "polygon = [[0.0, -4.0], [20.0, -4.0], [20.0, 0.0], [0.0, 0.0]]")),
            std::nullopt);
  EXPECT_EQ(reason(exact_case_with("density = 1700.0\nyoung = 40e6\npoisson = 0.28",
                                   "density = 1700.0\nvs = 95.87062360592131\nvp = 173.4364837735801")),
            std::nullopt);
}

TEST(ExactField, IsUnknownWhereTheSurfacesDiffer) {
  EXPECT_THAT(reason(tremolo::testing::unequal_surfaces_case()),
              Optional(Eq("the free fields have their surfaces at different levels, y = -2 m on "
                          "the left and y = 0 m on the right")));
}

TEST(ExactField, IsUnknownOfAnotherSoil) {
  EXPECT_THAT(reason(exact_case_with("density = 1700.0\nyoung = 40e6", "density = 1700.0\nyoung = 41e6")),
              Optional(Eq("soil 'sand' (density 1700 kg/m3, young 4e+07 Pa, poisson 0.28) differs from the "
                          "half-space (1700 kg/m3, 4.1e+07 Pa, 0.28)")));
}

TEST(ExactField, IsUnknownOfASoilThatYields) {
  EXPECT_THAT(reason(exact_case_with("model = \"linear_elastic\"",
                                     "model = \"mohr_coulomb\"\n"
                                     "cohesion_peak = 1e3\ncohesion_residual = 1e3\nsoftening = 0.0\n"
                                     "friction_peak_deg = 20.0\nfriction_residual_deg = 20.0")),
              Optional(Eq("soil 'sand' is not linear elastic but mohr_coulomb")));
}

TEST(ExactField, IsUnknownAroundAStructure) {
  EXPECT_THAT(reason(exact_case_with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n[[stage]]") +
                     "[[structure]]\nname = \"block\"\n"
                     "polygon = [[8.0, 0.0], [12.0, 0.0], [12.0, 4.0], [8.0, 4.0]]\n"
                     "density = 1000.0\nrigid = true\nfriction = 0.5\n"),
              Optional(Eq("structure 'block' scatters the waves")));
}

TEST(ExactField, IsUnknownOfAHill) {
  EXPECT_THAT(reason(exact_case_with("[20.0, 0.0], [0.0, 0.0]]", "[20.0, 0.0], [12.0, 0.0], [10.0, -1.0], "
                                                                 "[8.0, 0.0], [0.0, 0.0]]")),
              Optional(Eq("the ground is not level: the soil fills 198 m2 of the 200 m2 below the free "
                          "surface")));
}

} // namespace
