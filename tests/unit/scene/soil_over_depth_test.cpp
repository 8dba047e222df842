// Soils that vary over depth: the values of their slices against the profile at the slices' middles, the
// layers of the free fields against the soil of the domain, and what is refused with which words.

#include "case_text.hpp"

#include "scene/plan/layers.hpp"
#include "scene/plan/plan.hpp"
#include "scene/soils/domain_soils.hpp"
#include "scene/soils/level_ground.hpp"
#include "tests/support/paths.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <variant>
#include <vector>

namespace tremolo::scene::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::string_view constant = "young = 40e6\npoisson = 0.28\n[[region]]";
constexpr std::string_view one_layer = "[[profile]]\nthickness = 10.0\nsoil = \"sand\"\n";
constexpr std::string_view speeds =
    "vs = { depth = [0.0, 4.0, 20.0], value = [100.0, 140.0, 220.0] }\nvp = 500.0\n";

/// The flat case, 10 m deep on cells of 1 m, with other elastic constants of its soil and one layer of it.
std::string ground(std::string_view elastic, std::string_view more = one_layer) {
  return with(constant, std::string(elastic) + "[[region]]") + std::string(more);
}

double vs_of(const Soil& soil) {
  return materials::elasticity(soil.law).s_wave_speed();
}

/// Straight through the points of `speeds`.
double speed_at(double depth) {
  return depth < 4.0 ? 100.0 + 10.0 * depth : 140.0 + 5.0 * (depth - 4.0);
}

TEST(SoilOverDepth, SlicesAreAsHighAsCellsAndHaveTheValuesOfTheirMiddles) {
  const Case scene = parse_case(ground(speeds));
  ASSERT_EQ(scene.soils.size(), 10U);
  for (std::size_t i = 0; i < scene.soils.size(); ++i) {
    const double depth = 0.5 + static_cast<double>(i);
    EXPECT_EQ(scene.soils[i].name, "sand");
    EXPECT_NEAR(vs_of(scene.soils[i]), speed_at(depth), 1e-9);
    EXPECT_NEAR(materials::elasticity(scene.soils[i].law).p_wave_speed(), 500.0, 1e-9);
    EXPECT_EQ(scene.regions.front().soil_at(-depth), i);
  }
  ASSERT_EQ(scene.soil_profiles.size(), 1U);
  EXPECT_EQ(scene.soil_profiles.front().slices(), 10U);
}

TEST(SoilOverDepth, ElevationsAndDepthsMeanOneAndTheSame) {
  const Case by_depth = parse_case(ground(speeds));
  const Case by_elevation = parse_case(
      ground("vs = { elevation = [-20.0, -4.0, 0.0], value = [220.0, 140.0, 100.0] }\nvp = 500.0\n"));
  ASSERT_EQ(by_depth.soils.size(), by_elevation.soils.size());
  for (std::size_t i = 0; i < by_depth.soils.size(); ++i)
    EXPECT_DOUBLE_EQ(vs_of(by_depth.soils[i]), vs_of(by_elevation.soils[i]));
}

TEST(SoilOverDepth, LayersOfTheFreeFieldHaveTheSlicesOfTheDomain) {
  // The layer ends within a slice; below it lies the half-space.
  const Case scene =
      parse_case(ground(speeds, "[[profile]]\nthickness = 2.0\ndensity = 1700.0\nvs = 90.0\nvp "
                                "= 400.0\n[[profile]]\nthickness = 6.5\nsoil = \"sand\"\n"));
  ASSERT_EQ(scene.profile.size(), 8U);
  double top = -2.0;
  for (std::size_t i = 1; i < scene.profile.size(); ++i) {
    const Layer& layer = scene.profile[i];
    EXPECT_NEAR(layer.thickness, i == 7 ? 0.5 : 1.0, 1e-12);
    const double middle_of_slice = std::floor(top - 1e-6) + 0.5;
    EXPECT_EQ(*layer.soil, scene.regions.front().soil_at(middle_of_slice));
    EXPECT_NEAR(layer.elastic.s_wave_speed(), speed_at(-middle_of_slice), 1e-9);
    top -= layer.thickness;
  }
}

TEST(SoilOverDepth, LayersUnderAnotherSurfaceAreCutAtTheSameElevations) {
  auto text = ground(speeds);
  text = with("left = { model = \"wave\" }", "left = { model = \"wave\", surface = -3.0 }", text);
  text = with("form = \"total\"", "form = \"blended\"", with("[0.0, -10.0]\n", "[0.0, -20.0]\n", text));
  text = with("[0.0, 0.0]]", "[10.0, 0.0], [10.0, -3.0], [0.0, -3.0]]", text);
  // Ten metres of it begin at y = -3 m on the left, where the soil is the fourth slice.
  const Case scene = parse_case(text);
  const auto& left = layers(scene, scene.boundary.left);
  ASSERT_EQ(left.size(), 10U);
  EXPECT_NEAR(left.front().elastic.s_wave_speed(), speed_at(3.5), 1e-9);
  EXPECT_NEAR(left.back().elastic.s_wave_speed(), speed_at(12.5), 1e-9);
  EXPECT_NEAR(layers(scene, scene.boundary.right).front().elastic.s_wave_speed(), speed_at(0.5), 1e-9);
  EXPECT_EQ(scene.soils.size(), 13U);
  EXPECT_EQ(domain_soils(scene).size(), 10U); // the others lie below the box
}

TEST(SoilOverDepth, ProfilesOfOtherFormsAreComparedInSlicesOnly) {
  // v_p at the surface is below v_s at the base, where the first points of both tables lie.
  const Case scene = parse_case(ground("vs = { elevation = [-10.0, 0.0], value = [200.0, 50.0] }\n"
                                       "vp = { depth = [0.0, 10.0], value = [150.0, 500.0] }\n"));
  EXPECT_NEAR(vs_of(scene.soils.front()), 57.5, 1e-9);
  EXPECT_NEAR(materials::elasticity(scene.soils.back().law).p_wave_speed(), 482.5, 1e-9);
}

TEST(SoilOverDepth, PowersOfStressFollowTheWeightOfTheGroundAbove) {
  const Case scene =
      parse_case(ground("vs = { reference = 200.0, stress = 100e3, exponent = 0.25 }\nvp = 500.0\n"));
  for (std::size_t i = 0; i < scene.soils.size(); ++i) {
    const double stress = 1700.0 * 9.81 * (0.5 + static_cast<double>(i));
    EXPECT_NEAR(vs_of(scene.soils[i]), 200.0 * std::pow(stress / 100e3, 0.25), 1e-9);
  }
}

TEST(SoilOverDepth, GroundBelowTheWaterTableIsBuoyant) {
  auto text =
      ground("young = { reference = 50e6, stress = 100e3, exponent = 0.5 }\npoisson = 0.3\nporosity = "
             "0.4\npermeability = 1e-4\n",
             "[[profile]]\nthickness = 10.0\nsoil = \"sand\"\n[water]\nlevel = -4.0\n");
  text = with("density = 1700.0\nyoung = { ref", "young = { ref", text);
  text = with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n[[stage]]", text);
  const Case scene = parse_case(text);
  const double dry = 0.6 * 2650.0;
  EXPECT_NEAR(*level_ground_stress(scene, -3.0), 9.81 * dry * 3.0, 1e-6);
  EXPECT_NEAR(*level_ground_stress(scene, -6.5), 9.81 * (dry * 4.0 + 0.6 * 1650.0 * 2.5), 1e-6);
  EXPECT_FALSE(level_ground_stress(scene, 0.1));
  EXPECT_NEAR(materials::elasticity(scene.soils[6].law).young,
              50e6 * std::sqrt(*level_ground_stress(scene, -6.5) / 100e3), 1e-3);
  // Layers are those of the slices as waves meet them: dry above the table, grains and water below it.
  EXPECT_FALSE(scene.profile[3].wet);
  EXPECT_TRUE(scene.profile[4].wet);
  EXPECT_NEAR(scene.profile[6].elastic.shear_modulus(),
              materials::elasticity(scene.soils[6].law).shear_modulus(), 1e-3);
}

TEST(SoilOverDepth, StrengthGrowsWithDepth) {
  const Case scene = parse_case(with("model = \"linear_elastic\"", "model = \"drucker_prager\"",
                                     ground("vs = 150.0\nvp = 500.0\nfriction_deg = 0.0\ncohesion = { depth "
                                            "= [0.0, 10.0], value = [20e3, 40e3] }\n")));
  for (std::size_t i = 0; i < scene.soils.size(); ++i)
    EXPECT_NEAR(std::get<materials::DruckerPrager>(scene.soils[i].law).cohesion,
                21e3 + 2e3 * static_cast<double>(i), 1e-6);
}

TEST(SoilOverDepth, StressAtRestVaries) {
  const Case scene = parse_case(ground("young = 40e6\npoisson = 0.28\nrest_coefficient = { depth = [0.0, "
                                       "10.0], value = [1.0, 0.5] }\n"));
  for (std::size_t i = 0; i < scene.soils.size(); ++i)
    EXPECT_NEAR(materials::elasticity(scene.soils[i].law).rest_coefficient(),
                0.975 - 0.05 * static_cast<double>(i), 1e-12);
}

TEST(SoilOverDepth, SoilThatLiesNowhereStaysWhole) {
  const Case scene = parse_case(plus(std::string("[soil.spare]\nmodel = \"linear_elastic\"\ndensity = "
                                                 "1700.0\n") +
                                     std::string(speeds)));
  EXPECT_EQ(scene.soils.size(), 2U);
  EXPECT_TRUE(scene.soil_profiles.empty());
}

TEST(SoilOverDepth, ExplainTellsTheSlicesAndTheRangeOfTheirValues) {
  const Case scene = parse_case(ground(speeds));
  EXPECT_THAT(explain(scene, plan(scene)),
              AllOf(HasSubstr("varies over depth: 10 slices from y = 0 to -10 m"),
                    HasSubstr("105 to 167.5 m/s; "),
                    HasSubstr("{ depth = [0, 4, 20], value = [100, 140, 220] }")));
}

TEST(SoilOverDepth, TheStepIsThatOfTheStiffestSliceOfTheDomain) {
  const Case scene = parse_case(ground("young = { depth = [0.0, 10.0], value = [20e6, 80e6] }\npoisson = "
                                       "0.28\n"));
  const auto& deepest = materials::elasticity(scene.soils.back().law);
  EXPECT_NEAR(plan(scene).critical_dt, 0.65 * 1.0 / deepest.p_wave_speed(), 1e-9);
}

TEST(SoilOverDepth, TheExampleOfTheManualIsACase) {
  const Case scene = load(source_dir() + "/docs/examples/over_depth/case.toml");
  EXPECT_EQ(scene.soils.size(), 24U);
  EXPECT_EQ(scene.profile.size(), 24U);
  EXPECT_NEAR(vs_of(scene.soils[0]), 111.25, 1e-9);
  EXPECT_NEAR(vs_of(scene.soils[16]), 260.0 * std::pow(9.81 * (1700.0 * 16.0 + 925.0) / 100e3, 0.25), 1e-9);
}

/// The one error of the ground with these elastic constants.
std::string error_of(std::string_view elastic) {
  const auto errors = errors_of(ground(elastic));
  EXPECT_EQ(errors.size(), 1U) << elastic << ::testing::PrintToString(errors);
  return errors.empty() ? "" : errors.front();
}

TEST(SoilOverDepth, FormsThatAreNoneAreRefused) {
  EXPECT_THAT(error_of("vs = { depht = [0.0, 10.0], value = [100.0, 140.0] }\nvp = 500.0\n"),
              AllOf(HasSubstr("case.toml:16:16: [soil.sand] unknown key 'depht' in the profile 'vs'"),
                    HasSubstr("did you mean 'depth'?")));
  EXPECT_THAT(error_of("vs = { depth = [0.0, 10.0] }\nvp = 500.0\n"),
              HasSubstr("missing 'value' of the profile 'vs'; the forms are { depth"));
  EXPECT_THAT(error_of("vs = { depth = [0.0, 10.0], elevation = [0.0, 10.0], value = [1.0, 2.0] }\nvp = "
                       "500.0\n"),
              HasSubstr("must have one of the forms"));
  EXPECT_THAT(error_of("vs = { reference = 200.0, exponent = 0.25 }\nvp = 500.0\n"),
              HasSubstr("missing 'stress' of the profile 'vs'"));
  EXPECT_THAT(error_of("vs = {}\nvp = 500.0\n"), HasSubstr("must have one of the forms"));
}

TEST(SoilOverDepth, PointsThatMakeNoProfileAreRefused) {
  EXPECT_THAT(error_of("vs = { depth = [0.0, 5.0, 5.0], value = [1.0, 2.0, 3.0] }\nvp = 500.0\n"),
              HasSubstr("'depth' of the profile 'vs' must rise, found 5 behind 5"));
  EXPECT_THAT(error_of("vs = { depth = [0.0, 10.0], value = [100.0, 120.0, 140.0] }\nvp = 500.0\n"),
              HasSubstr("'value' of the profile 'vs' has 3 numbers, 'depth' has 2"));
  EXPECT_THAT(error_of("vs = { depth = [0.0, 10.0], value = [100.0, -140.0] }\nvp = 500.0\n"),
              HasSubstr("'value' = -140 of the profile 'vs' is out of range, must be > 0 m/s"));
  EXPECT_THAT(error_of("vs = { depth = [0.0, 10.0], value = [100.0] }\nvp = 500.0\n"),
              HasSubstr("must be an array of at least 2 numbers, found 1"));
  EXPECT_THAT(error_of("vs = { depth = [0.0, \"10\"], value = [100.0, 140.0] }\nvp = 500.0\n"),
              HasSubstr("'depth' of the profile 'vs' must be a finite number, found a string"));
  EXPECT_THAT(error_of("vs = { reference = 200.0, stress = 100e3, exponent = 3.0 }\nvp = 900.0\n"),
              HasSubstr("'exponent' = 3 of the profile 'vs' is out of range, must be in [0, 2]"));
}

TEST(SoilOverDepth, ProfilesThatDoNotCoverTheSoilAreRefused) {
  EXPECT_THAT(error_of("vs = { depth = [0.0, 8.0], value = [100.0, 140.0] }\nvp = 500.0\n"),
              HasSubstr("the profile is given from depth 0 to 8 m, but soil 'sand' lies from depth 0 to 10 m "
                        "below [surface] level = 0 m"));
  EXPECT_THAT(error_of("vs = { elevation = [-10.0, -1.0], value = [140.0, 100.0] }\nvp = 500.0\n"),
              HasSubstr("lies from elevation -10 to 0 m: give values for all of it"));
}

TEST(SoilOverDepth, SoilAboveTheLevelGroundHasNoStress) {
  const auto text =
      with("level = 0.0", "level = -2.0",
           ground("vs = { reference = 200.0, stress = 100e3, exponent = 0.25 }\nvp = 500.0\n", ""));
  EXPECT_THAT(errors_of(text), Contains(HasSubstr("but the soil reaches y = -0.5 m above it")));
}

TEST(SoilOverDepth, SlicesMustBeSoilsThemselves) {
  EXPECT_THAT(
      error_of("vs = { depth = [0.0, 10.0], value = [100.0, 500.0] }\nvp = 500.0\n"),
      AllOf(HasSubstr("is too low for 'vs' = 440"), HasSubstr("(slice of the soil from y = -8 to -9 m)")));
}

TEST(SoilOverDepth, KeysThatCannotVaryAreRefused) {
  EXPECT_THAT(
      errors_of(with("density = 1700.0\nvs", "density = { depth = [0.0, 10.0], value = [1.0, 2.0] }\nvs",
                     ground(speeds))),
      Contains(AllOf(HasSubstr("'density' must be a number, found a table; over depth can vary young, "
                               "vs, vp, "),
                     HasSubstr("rest_coefficient"))));
  EXPECT_THAT(errors_of(plus("[halfspace.vs]\ndepth = [0.0, 1.0]\n")),
              Contains(HasSubstr("'vs' must be a number, found a table")));
}

TEST(SoilOverDepth, MoreSlicesThanAllowedAreRefused) {
  EXPECT_THAT(
      errors_of(with("size = 1.0", "size = 0.01", ground(speeds))),
      Contains(HasSubstr("would be cut into 1000 slices as high as the cells, 0.01 m, allowed: at most "
                         "500")));
}

} // namespace
} // namespace tremolo::scene::testing
