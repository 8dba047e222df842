// [random_profile]: which numbers of a case it varies and which stay, in free field and domain, dry and wet,
// and what is refused with which words.

#include "../case_text.hpp"
#include "joined.hpp"

#include "scene/plan/layers.hpp"
#include "scene/plan/plan.hpp"
#include "scene/random/random_text.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <string>
#include <string_view>

namespace tremolo::scene::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using tremolo::testing::join;

constexpr std::string_view random_c = "[random_profile]\nsite_class = \"usgs_c\"\nlayer_thickness = 2.5\n";
constexpr std::string_view one_layer = "[[profile]]\nthickness = 10.0\nsoil = \"sand\"\n";

/// The flat case, 10 m deep, with one layer of its soil and a random profile of four layers.
std::string ground(std::string_view random = random_c) {
  return plus(join({one_layer, random}));
}

materials::Elasticity elastic(const Soil& soil) {
  return materials::elasticity(soil.law);
}

TEST(RandomProfile, SpeedVariesAndDensityAndPoissonsRatioStay) {
  const Case scene = parse_case(ground());
  const materials::Elasticity median = elastic(parse_case(plus(one_layer)).soils.front());
  ASSERT_EQ(4U, scene.soils.size());
  for (std::size_t i = 0; i < scene.soils.size(); ++i) {
    const materials::Elasticity varied = elastic(scene.soils[i]);
    const double factor = scene.random_profile->layers[i].factor;
    EXPECT_NE(1.0, factor);
    EXPECT_NEAR(factor, varied.s_wave_speed() / median.s_wave_speed(), 1e-12);
    EXPECT_EQ(median.density, varied.density);
    EXPECT_EQ(median.poisson, varied.poisson);
    EXPECT_EQ("sand", scene.soils[i].name);
  }
}

TEST(RandomProfile, SpeedsThatAreGivenVaryLikewise) {
  const auto speeds = [](std::string_view more) {
    return parse_case(with("young = 40e6\npoisson = 0.28\n[[region]]", "vs = 120.0\nvp = 500.0\n[[region]]",
                           plus(join({one_layer, more}))));
  };
  const Case scene = speeds(random_c);
  for (std::size_t i = 0; i < scene.soils.size(); ++i) {
    EXPECT_NEAR(120.0 * scene.random_profile->layers[i].factor, elastic(scene.soils[i]).s_wave_speed(), 1e-9);
    EXPECT_NEAR(500.0 / 120.0,
                elastic(scene.soils[i]).p_wave_speed() / elastic(scene.soils[i]).s_wave_speed(), 1e-9);
  }
}

TEST(RandomProfile, DomainAndFreeFieldHaveTheSameLayers) {
  const Case scene = parse_case(ground());
  ASSERT_EQ(4U, scene.profile.size());
  for (std::size_t i = 0; i < scene.profile.size(); ++i) {
    const double y = -2.5 * (static_cast<double>(i) + 0.5);
    EXPECT_NEAR(2.5, scene.profile[i].thickness, 1e-12);
    EXPECT_EQ(i, *scene.profile[i].soil);
    EXPECT_EQ(i, scene.regions.front().soil_at(y));
    EXPECT_EQ(elastic(scene.soils[i]).young, scene.profile[i].elastic.young);
  }
  EXPECT_THAT(remarks_of(ground()),
              ::testing::Not(Contains(HasSubstr("the layers differ from the regions"))));
}

TEST(RandomProfile, LayersWithConstantsOfTheirOwnVary) {
  const Case scene = parse_case(
      plus(join({"[[profile]]\nthickness = 4.0\ndensity = 1700.0\nvs = 90.0\nvp = 400.0\n", random_c})));
  ASSERT_EQ(2U, scene.profile.size());
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(90.0 * scene.random_profile->layers[i].factor, scene.profile[i].elastic.s_wave_speed(), 1e-9);
    EXPECT_EQ(1700.0, scene.profile[i].elastic.density);
  }
  EXPECT_EQ(1U, scene.soils.size()); // the soil of the domain lies in no layer
}

TEST(RandomProfile, HalfSpaceStays) {
  EXPECT_EQ(parse_case(plus(one_layer)).halfspace.young, parse_case(ground()).halfspace.young);
}

TEST(RandomProfile, NoDeviationLeavesTheCaseAsItIs) {
  const Case scene = parse_case(ground(join({random_c, "sigma_ln = 0\n"})));
  for (const Soil& soil : scene.soils)
    EXPECT_EQ(elastic(parse_case(plus(one_layer)).soils.front()).young, elastic(soil).young);
}

TEST(RandomProfile, CurvesAndStrengthsStay) {
  constexpr std::string_view curved = "density = 1700.0\nvs = 150.0\nvp = 500.0\ncurve = "
                                      "\"darendeli\"\nplasticity_index = 30.0\nmean_stress = "
                                      "50e3\nshear_strength = 40e3\n[[region]]";
  const auto clay = [&](std::string_view more) {
    auto text = plus(join({one_layer, more}));
    text = with("model = \"linear_elastic\"", "model = \"gqh\"", text);
    return parse_case(with("density = 1700.0\nyoung = 40e6\npoisson = 0.28\n[[region]]", curved, text));
  };
  const Soil median = clay("").soils.front();
  for (const Soil& soil : clay(random_c).soils) {
    EXPECT_EQ(*median.given_strength, *soil.given_strength);
    for (const double strain : {1e-5, 1e-4, 1e-3, 1e-2})
      EXPECT_EQ(median.curves->modulus_reduction(strain), soil.curves->modulus_reduction(strain));
    // Far out the backbone carries the strength whatever the stiffness: within the hyperbola's remainder.
    EXPECT_NEAR(1.0, materials::shear_backbone(soil.column_law)->stress(10.0) / 40e3, 0.01);
  }
}

TEST(RandomProfile, WaterCutsTheLayersAndLeavesTheFactors) {
  const auto wet = [](std::string_view level) {
    auto text =
        with("density = 1700.0\nyoung = 40e6\npoisson = 0.28\n[[region]]",
             "young = 40e6\npoisson = 0.28\nporosity = 0.4\npermeability = 1e-4\n[[region]]", ground());
    text = with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n[[stage]]", text);
    return parse_case(join({text, "[water]\nlevel = ", level, "\n"}));
  };
  const Case high = wet("-1.0");
  const Case low = wet("-6.0");
  ASSERT_EQ(5U, high.profile.size());
  EXPECT_FALSE(high.profile[0].wet);
  EXPECT_TRUE(high.profile[1].wet);
  EXPECT_EQ(high.profile[0].soil, high.profile[1].soil);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(high.random_profile->layers[i].factor, low.random_profile->layers[i].factor);
}

TEST(RandomProfile, SoilOverDepthKeepsItsSlices) {
  const auto text =
      with("young = 40e6\npoisson = 0.28\n[[region]]",
           "vs = { depth = [0.0, 10.0], value = [100.0, 200.0] }\nvp = 900.0\n[[region]]", ground());
  const Case scene = parse_case(text);
  ASSERT_EQ(10U, scene.soils.size());
  for (std::size_t i = 0; i < scene.soils.size(); ++i) {
    const double depth = 0.5 + static_cast<double>(i);
    EXPECT_NEAR((100.0 + 10.0 * depth) * scene.random_profile->factor_at(-depth),
                elastic(scene.soils[i]).s_wave_speed(), 1e-9);
  }
}

TEST(RandomProfile, GroundUnderAnotherSurfaceHasTheFactorOfItsLevel) {
  auto text = ground();
  text = with("left = { model = \"wave\" }", "left = { model = \"wave\", surface = -3.0 }", text);
  text = with("form = \"total\"", "form = \"blended\"", with("[0.0, -10.0]\n", "[0.0, -20.0]\n", text));
  text = with("[0.0, 0.0]]", "[10.0, 0.0], [10.0, -3.0], [0.0, -3.0]]", text);
  const Case scene = parse_case(text);
  double top = -3.0;
  for (const Layer& layer : layers(scene, scene.boundary.left)) {
    const double factor = scene.random_profile->factor_at(top - 0.5 * layer.thickness);
    EXPECT_NEAR(40e6 * factor * factor, layer.elastic.young, 1.0);
    top -= layer.thickness;
  }
  EXPECT_NEAR(-13.0, top, 1e-9);
}

TEST(RandomProfile, ParametersThatAreGivenStandForThoseOfTheClass) {
  const Case scene = parse_case(ground(join({random_c, "sigma_ln = 0.2\nseed = 7\nrealisation = 12\n"})));
  EXPECT_EQ(0.2, scene.random_profile->model.sigma_ln);
  EXPECT_EQ(0.344, scene.random_profile->model.b);
  EXPECT_EQ(7U, scene.random_profile->seed);
  EXPECT_EQ(12U, scene.random_profile->realisation);
  EXPECT_THAT(random_profile_text(scene),
              AllOf(HasSubstr("realisation 12 of seed 7: sigma_ln 0.2, rho_0 0.99, delta 3.9 m"),
                    HasSubstr("0 to 2.5"), HasSubstr("sand")));
  EXPECT_THAT(explain(scene, plan(scene)),
              AllOf(HasSubstr("Random profile\n"), HasSubstr("4e+07 times the factors of [random_profile]")));
}

/// The one error of the ground with this table.
std::string error_of(std::string_view random) {
  const auto errors = errors_of(ground(random));
  EXPECT_EQ(1U, errors.size()) << random << ::testing::PrintToString(errors);
  return errors.empty() ? "" : errors.front();
}

TEST(RandomProfile, ParametersThatAreMissingAreRefused) {
  EXPECT_THAT(
      error_of("[random_profile]\nseed = 2\n"),
      AllOf(HasSubstr("case.toml:34:1: [random_profile] missing 'site_class', or each of 'sigma_ln'")));
  EXPECT_THAT(error_of("[random_profile]\nsigma_ln = 0.3\nrho_0 = 0.9\ndelta = 4\nrho_200 = 1\nh_0 = 0\n"),
              HasSubstr("[random_profile] missing 'b': without 'site_class' each parameter is given"));
  EXPECT_THAT(error_of("[random_profile]\nsite_class = \"usgs_e\"\n"),
              HasSubstr("\"usgs_e\" is not known, did you mean"));
  EXPECT_THAT(error_of(join({random_c, "rho_0 = 1.2\n"})),
              HasSubstr("'rho_0' = 1.2 is out of range, must be in [0, 1]"));
}

TEST(RandomProfile, GroundThatCannotVaryIsRefused) {
  EXPECT_THAT(
      errors_of(plus(random_c)),
      Contains(HasSubstr("[random_profile] varies Vs of the layers of [[profile]], which the case does "
                         "not have")));
  EXPECT_THAT(
      error_of("[random_profile]\nsite_class = \"usgs_c\"\nlayer_thickness = 0.01\n"),
      HasSubstr("'layer_thickness' = 0.01 m cuts [[profile]] into 1000 layers, allowed: at most 500"));
  auto sand = with("model = \"linear_elastic\"\ndensity = 1700.0\nyoung = 40e6\npoisson = 0.28\n",
                   "library = \"pm4sand_dr55\"\n", ground());
  sand = with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n[[stage]]", sand);
  EXPECT_THAT(errors_of(sand),
              Contains(HasSubstr("soil 'sand' has a stiffness that follows the effective "
                                 "stress, and the rate of its pore pressure is calibrated")));
}

} // namespace
} // namespace tremolo::scene::testing
