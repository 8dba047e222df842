// Soils of the laws for sand and clay: what their keys give, and what is refused with which words and where.

#include "case_text.hpp"

#include "scene/plan/plan.hpp"
#include "scene/soils/soil_library.hpp"
#include "scene/soils/soil_report.hpp"
#include "tests/support/paths.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>
#include <string>

namespace tremolo::scene::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The flat case with its soil's table replaced; it has gravity.
std::string with_soil(const std::string& keys) {
  const auto heavy = with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n[[stage]]");
  return with("model = \"linear_elastic\"\ndensity = 1700.0\nyoung = 40e6\npoisson = 0.28\n[[region]]",
              keys + "[[region]]", heavy);
}

const std::string pm4sand = "model = \"pm4sand\"\ndensity = 1900.0\nrelative_density = 0.55\n"
                            "shear_modulus_coefficient = 677.0\ncontraction_rate = 0.4\n";

template <class Law>
Law law_of(const std::string& keys) {
  return std::get<Law>(parse_case(with_soil(keys)).soils.at(0).law);
}

TEST(Sand, Pm4SandHasWhatIsGivenAndTheReportsDefaults) {
  const auto law = law_of<materials::Pm4Sand>(pm4sand + "phi_cv_deg = 31.5\nC_GD = 3.0\npoisson = 0.25\n");
  EXPECT_EQ(law.relative_density, 0.55);
  EXPECT_EQ(law.G_o, 677.0);
  EXPECT_EQ(law.h_po, 0.4);
  EXPECT_EQ(law.elastic.density, 1900.0);
  EXPECT_EQ(law.elastic.poisson, 0.25);
  EXPECT_DOUBLE_EQ(law.phi_cv, 31.5 * std::numbers::pi / 180.0);
  EXPECT_EQ(law.C_GD, 3.0);
  // Boulanger & Ziotopoulou (2017): h_o = (0.25 + D_R)/2 here, n_b = 0.5.
  EXPECT_DOUBLE_EQ(law.h_o, 0.4);
  EXPECT_EQ(law.n_b, 0.5);
}

TEST(Sand, EveryKeyOfPm4SandReachesItsParameter) {
  const auto law = law_of<materials::Pm4Sand>(
      pm4sand +
      "atmospheric_pressure = 1e5\ne_max = 0.9\ne_min = 0.4\nn_b = 0.6\nn_d = 0.2\nQ = 9.0\nR = 1.4\n"
      "m = 0.02\nh_o = 0.5\nA_do = 1.1\nz_max = 3.0\nc_z = 240.0\nc_eps = 0.3\nC_DR = 6.0\nC_kaf = 7.0\n"
      "F_sed_min = 0.2\np_sedo = 3e4\npost_shake = true\ntolerance = 1e-3\n");
  EXPECT_EQ(law.p_A, 1e5);
  EXPECT_EQ(law.e_max, 0.9);
  EXPECT_EQ(law.e_min, 0.4);
  EXPECT_EQ(law.n_b, 0.6);
  EXPECT_EQ(law.n_d, 0.2);
  EXPECT_EQ(law.Q, 9.0);
  EXPECT_EQ(law.R, 1.4);
  EXPECT_EQ(law.m, 0.02);
  EXPECT_EQ(law.h_o, 0.5);
  EXPECT_EQ(law.A_do, 1.1);
  EXPECT_EQ(law.z_max, 3.0);
  EXPECT_EQ(law.c_z, 240.0);
  EXPECT_EQ(law.c_eps, 0.3);
  EXPECT_EQ(law.C_DR, 6.0);
  EXPECT_EQ(law.C_kaf, 7.0);
  EXPECT_EQ(law.F_sed_min, 0.2);
  EXPECT_EQ(law.p_sedo, 3e4);
  EXPECT_TRUE(law.post_shake);
  EXPECT_EQ(law.integration.tolerance, 1e-3);
  EXPECT_EQ(law_of<materials::Pm4Sand>(pm4sand).integration.tolerance, materials::Pm4Integration{}.tolerance);
  EXPECT_FALSE(law_of<materials::Pm4Sand>(pm4sand).post_shake);
}

TEST(Sand, ExplainNamesTheModelOfTheCase) {
  const auto scene = parse_case(with_soil("model = \"mkz\"\ndensity = 1700.0\nvs = 100.0\nvp = 200.0\n"
                                          "reference_strain = 5e-4\nbeta = 1.0\nexponent = 0.9\n"));
  EXPECT_THAT(explain(scene, plan(scene)), HasSubstr("\nSoils\n sand (mkz)\n"));
}

TEST(Sand, Pm4SandSaysWhatIsMissingOrTooMuch) {
  EXPECT_THAT(errors_of(with_soil(pm4sand + "young = 1e7\n")),
              ElementsAre(AllOf(
                  HasSubstr("case.toml:19:9: [soil.sand] 'young' does not apply to model = \"pm4sand\""))));
  EXPECT_THAT(errors_of(with_soil("model = \"pm4sand\"\ndensity = 1900.0\nrelative_density = 0.55\n"
                                  "shear_modulus_coefficient = 677.0\n")),
              ElementsAre(HasSubstr("missing 'contraction_rate'")));
  EXPECT_THAT(errors_of(with_soil(
                  "model = \"pm4sand\"\nshear_modulus_coefficient = 677.0\ncontraction_rate = 0.4\n")),
              ElementsAre(HasSubstr("missing 'density': model = \"pm4sand\" needs it"),
                          HasSubstr("missing 'relative_density': model = \"pm4sand\" needs it")));
  EXPECT_THAT(errors_of(with_soil(pm4sand + "relatve_density = 0.5\n")),
              ElementsAre(HasSubstr("unknown key 'relatve_density', did you mean 'relative_density'?")));
  EXPECT_THAT(errors_of(with_soil(pm4sand + "e_min = 0.9\n")), ElementsAre(HasSubstr("[soil.sand] e_m")));
}

TEST(Sand, DensityInPerCentIsOutOfRange) {
  auto keys = pm4sand;
  EXPECT_THAT(
      errors_of(with_soil(keys.replace(keys.find("0.55"), 4, "55.0"))),
      ElementsAre(
          "case.toml:16:20: [soil.sand] 'relative_density' = 55 is out of range, must be in [0.05, 1.2]"));
}

/// The key table refuses what the law would refuse, in the words and units of the file.
TEST(Sand, RangesOfTheLawsAreThoseOfTheKeys) {
  const auto refused = [](const std::string& soil, const std::string& line, const std::string& words) {
    EXPECT_THAT(errors_of(with_soil(soil + line + "\n")),
                ElementsAre(AllOf(HasSubstr("[soil.sand] '" + line.substr(0, line.find(' ')) + "' = "),
                                  HasSubstr(words))))
        << line;
  };
  refused(pm4sand, "phi_cv_deg = 0.576", "must be in [1, 60] degrees");
  refused(pm4sand, "Q = 4.0", "must be in [5, 20]");
  refused(pm4sand, "m = 0.2", "must be in [0.0001, 0.1]");
  refused(pm4sand, "C_GD = 0.5", "must be in [1, 100]");
  refused(pm4sand, "C_DR = 20.0", "must be in [0.1, 10]");
  refused(pm4sand, "C_kaf = 1.0", "must be in [4, 35]");
  const std::string pdmy = "model = \"pdmy03\"\nrelative_density = 0.57\n";
  refused(pdmy, "friction_deg = 70.0", "must be in [1, 65] degrees with model = \"pdmy03\"");
  refused(pdmy, "surfaces = 41", "must be in [3, 40] with model = \"pdmy03\"");
  refused(pdmy, "pressure_exponent = 1.5", "must be in [0, 1]");
  for (const char* ends : {"phi_cv_deg = 60.0\nQ = 5.0\nm = 1e-4\nC_GD = 1.0\nC_DR = 10.0\nC_kaf = 4.0\n",
                           "phi_cv_deg = 1.0\nQ = 20.0\nm = 0.1\nC_GD = 100.0\nC_DR = 0.1\nC_kaf = 35.0\n"})
    EXPECT_THAT(errors_of(with_soil(pm4sand + ends)), IsEmpty()) << ends;
  EXPECT_THAT(errors_of(with_soil(pdmy + "friction_deg = 65.0\nsurfaces = 40\n")), IsEmpty());
  EXPECT_THAT(errors_of(with_soil(pdmy + "friction_deg = 30.0\ncurve = \"curve.csv\"\n")),
              ElementsAre(HasSubstr("case.toml:16:16: [soil.sand] 'friction_deg' and 'curve' exclude each "
                                    "other: the curve fixes friction angle")));
}

TEST(Sand, Pdmy03OfARecommendedDensityIsComplete) {
  const auto law =
      law_of<materials::Pdmy03>("model = \"pdmy03\"\nrelative_density = 0.57\nfriction_deg = 31.0\n");
  EXPECT_EQ(law.relative_density, 0.57);
  EXPECT_DOUBLE_EQ(law.friction, 31.0 * std::numbers::pi / 180.0);
  EXPECT_DOUBLE_EQ(law.elastic.shear_modulus(), 73.7e6);
  EXPECT_EQ(law.contraction[0], 0.012);
}

TEST(Sand, Pdmy03BetweenTheSetsIsRefusedWithThem) {
  EXPECT_THAT(
      errors_of(with_soil("model = \"pdmy03\"\nrelative_density = 0.60\n")),
      ElementsAre(AllOf(HasSubstr("case.toml:15:20: [soil.sand]"), HasSubstr("0.57"), HasSubstr("0.74"))));
}

TEST(Sand, Pdmy03WithoutADensityNeedsEverything) {
  EXPECT_THAT(errors_of(with_soil("model = \"pdmy03\"\ndensity = 1900.0\n")),
              ElementsAre(HasSubstr("[soil.sand] ")));
  const auto law = law_of<materials::Pdmy03>(
      "model = \"pdmy03\"\ndensity = 1900.0\nshear_modulus = 80e6\nbulk_modulus = 200e6\nfriction_deg = "
      "32.0\n"
      "phase_transformation_deg = 26.0\ncontraction_a = 0.01\ncontraction_b = 2.0\ncontraction_c = 0.3\n"
      "contraction_d = 8.0\ncontraction_e = 0.5\ndilation_a = 0.2\ndilation_b = 2.5\ndilation_c = -0.2\n"
      "peak_shear_strain = 0.08\nreference_pressure = 80e3\npressure_exponent = 0.6\nsurfaces = 10\n"
      "liquefaction_1 = 0.9\nliquefaction_2 = 0.1\natmospheric_pressure = 100e3\nzero_pressure_strength = "
      "1e3\n"
      "cone = \"plane_strain\"\n");
  EXPECT_EQ(law.contraction, (std::array{0.01, 2.0, 0.3, 8.0, 0.5}));
  EXPECT_EQ(law.dilation, (std::array{0.2, 2.5, -0.2}));
  EXPECT_EQ(law.peak_shear_strain, 0.08);
  EXPECT_EQ(law.reference_pressure, 80e3);
  EXPECT_EQ(law.pressure_exponent, 0.6);
  EXPECT_EQ(law.surfaces, 10U);
  EXPECT_EQ(law.liquefaction_1, 0.9);
  EXPECT_EQ(law.liquefaction_2, 0.1);
  EXPECT_EQ(law.atmospheric_pressure, 100e3);
  EXPECT_EQ(law.zero_pressure_strength, 1e3);
  EXPECT_EQ(law.cone, materials::Pdmy03Cone::plane_strain);
}

TEST(Rules, LawsHaveLimits) {
  EXPECT_THAT(remarks_of(with_soil("model = \"pdmy03\"\nrelative_density = 0.57\n")),
              Contains(AllOf(HasSubstr("soil 'sand': "), HasSubstr("plane strain"))));
  EXPECT_THAT(remarks_of(with_soil("model = \"pdmy03\"\nrelative_density = 0.57\ncone = \"plane_strain\"\n")),
              ::testing::Not(Contains(HasSubstr("fixes a circular cone in triaxial compression"))));
}

TEST(Rules, StiffnessFollowsPressure) {
  const auto grows = Contains(HasSubstr("soil 'sand': stiffness grows with pressure"));
  EXPECT_THAT(remarks_of(with_soil(pm4sand)), grows);
  EXPECT_THAT(remarks_of(with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n[[stage]]")),
              ::testing::Not(grows));
}

TEST(Rules, SandHasWeight) {
  const auto text = with_soil(pm4sand);
  EXPECT_THAT(errors_of(text), IsEmpty());
  EXPECT_THAT(errors_of(std::string(flat_case)), IsEmpty()); // elastic soil has its stiffness without weight
  EXPECT_THAT(errors_of(with("[[stage]]\nkind = \"gravity\"\n", "", text)),
              ElementsAre(HasSubstr(
                  "case.toml:14:9: [soil.sand] model = \"pm4sand\" begins with the stress that gravity")));
}

TEST(Rules, SoilsSuitModels) {
  const auto layered = [](const std::string& soil, const std::string& model) {
    return with("left = { model = \"wave\" }", "left = { model = \"" + model + "\" }",
                plus("[soil.layer]\n" + soil + "[[profile]]\nthickness = 4.0\nsoil = \"layer\"\n"));
  };
  const std::string clay = "model = \"multi_yield_clay\"\ndensity = 1700.0\nvs = 100.0\nvp = 1000.0\n"
                           "undrained_strength = 40e3\n";
  const std::string cone =
      "model = \"drucker_prager\"\ndensity = 1700.0\nvs = 100.0\nvp = 200.0\ncohesion = 5e3\n"
      "friction_deg = 30.0\n";
  EXPECT_THAT(errors_of(layered(pm4sand, "fe")),
              ElementsAre(HasSubstr("[soil.layer] model = \"pm4sand\" begins with the stress that gravity")));
  EXPECT_THAT(
      errors_of(with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n[[stage]]", layered(pm4sand, "fe"))),
      IsEmpty());
  EXPECT_THAT(errors_of(layered(clay, "fe")), IsEmpty());
  EXPECT_THAT(errors_of(layered(clay, "ode")),
              ElementsAre(HasSubstr("with which multi_yield_clay (soil 'layer')")));
  EXPECT_THAT(errors_of(layered(cone, "ode")),
              ElementsAre(HasSubstr("soil 'layer' is drucker_prager; use model = \"fe\"")));
  EXPECT_THAT(errors_of(layered(cone, "fe")), IsEmpty());
  EXPECT_THAT(errors_of(layered(pm4sand, "wave")), IsEmpty());
}

TEST(PlasticSoil, DruckerPragerAndItsCone) {
  const std::string keys =
      "model = \"drucker_prager\"\ndensity = 1700.0\nvs = 100.0\nvp = 200.0\ncohesion = 5e3\n"
      "friction_deg = 30.0\ndilation_deg = 10.0\n";
  const auto law = law_of<materials::DruckerPrager>(keys);
  EXPECT_EQ(law.cohesion, 5e3);
  EXPECT_DOUBLE_EQ(law.friction, std::numbers::pi / 6.0);
  EXPECT_DOUBLE_EQ(law.dilation, std::numbers::pi / 18.0);
  EXPECT_EQ(law.match, materials::ConeMatch::plane_strain);
  EXPECT_EQ(law_of<materials::DruckerPrager>(keys + "cone = \"triaxial_extension\"\n").match,
            materials::ConeMatch::triaxial_extension);
  EXPECT_THAT(errors_of(with_soil("model = \"drucker_prager\"\ndensity = 1700.0\nvs = 100.0\nvp = 200.0\n"
                                  "cohesion = 5e3\n")),
              ElementsAre(HasSubstr("missing 'friction_deg': model = \"drucker_prager\" needs it")));
  EXPECT_THAT(errors_of(with_soil(keys + "dilation_deg_ = 40.0\n")), ElementsAre(HasSubstr("unknown key")));
}

TEST(PlasticSoil, ClayOfNestedSurfaces) {
  const std::string keys = "model = \"multi_yield_clay\"\ndensity = 1700.0\nvs = 100.0\nvp = 1000.0\n"
                           "undrained_strength = 40e3\n";
  const auto law = law_of<materials::MultiYieldClay>(keys + "surfaces = 12\npeak_strain = 0.05\n");
  EXPECT_EQ(law.undrained_strength, 40e3);
  EXPECT_EQ(law.peak_strain, 0.05);
  EXPECT_EQ(law.elements.size(), 12U);
  EXPECT_THAT(errors_of(with_soil(keys + "surfaces = 13\n")),
              ElementsAre(HasSubstr("[soil.sand] 'surfaces' = 13 must be a multiple of 4")));
  EXPECT_THAT(errors_of(with_soil(keys + "curve = \"none.csv\"\n")),
              ElementsAre(HasSubstr("none.csv: there is no such file")));
}

TEST(Library, EverySoilIsReadAndSaysWhereItIsFrom) {
  ASSERT_FALSE(soil_library().empty());
  for (const LibrarySoil& soil : soil_library()) {
    EXPECT_THAT(errors_of(with_soil("library = \"" + std::string(soil.name) + "\"\n")), IsEmpty())
        << soil.name;
    EXPECT_FALSE(soil.title.empty()) << soil.name;
    EXPECT_FALSE(soil.source.empty()) << soil.name;
    EXPECT_FALSE(soil.basis.empty()) << soil.name;
  }
}

TEST(Library, IsOverriddenKeyByKey) {
  const auto scene = parse_case(with_soil("library = \"pm4sand_dr55\"\ncontraction_rate = 0.7\n"));
  const auto& law = std::get<materials::Pm4Sand>(scene.soils.at(0).law);
  EXPECT_EQ(law.h_po, 0.7);
  EXPECT_EQ(law.G_o, 677.0);
  const auto parameters = parameters_in_force(scene.soils[0], "soil.sand", scene.values);
  const auto origin = [&](std::string_view name) {
    return std::ranges::find(parameters, name, &ParameterInForce::name)->origin;
  };
  EXPECT_EQ(origin("shear_modulus_coefficient"), "library pm4sand_dr55");
  EXPECT_EQ(origin("contraction_rate"), "case.toml:15:20");
  EXPECT_THAT(origin("n_b"), HasSubstr("default"));
  EXPECT_EQ(std::ranges::find(parameters, "phi_cv_deg", &ParameterInForce::name)->value, 33.0);
  EXPECT_THAT(explain(scene, plan(scene)), HasSubstr("(library pm4sand_dr55)"));
}

TEST(Library, UnknownSoilNamesTheNearestAndNothingElseIsMissing) {
  EXPECT_THAT(
      errors_of(with_soil("library = \"hostun_dr54\"\n")),
      ElementsAre("case.toml:14:11: [soil.sand] 'hostun_dr54' is not in the library of soils, did you mean "
                  "'hostun_dr45'?"));
}

TEST(Library, ModelOfASoilStays) {
  EXPECT_THAT(errors_of(with_soil("library = \"pm4sand_dr55\"\nmodel = \"pdmy03\"\n")),
              Contains(HasSubstr("'pm4sand_dr55' of the library is \"pm4sand\"")));
  EXPECT_THAT(errors_of(with_soil("library = \"pm4sand_dr55\"\nmodel = \"pm4sand\"\n")), IsEmpty());
}

TEST(Library, SoilOfTheSlopeCaseIsThatOfTheCase) {
  const auto slope = load(source_dir() + "/cases/slope_oblique/uniform.toml");
  const auto* soil = library_soil("slope_softening");
  ASSERT_NE(soil, nullptr);
  for (const auto& [key, value] : *soil->keys)
    EXPECT_THAT(slope.values,
                Contains(::testing::Field(&ValueInForce::key, "soil.slope." + std::string(key.str()))));
  const auto& law = std::get<materials::MohrCoulomb>(slope.soils.at(0).law);
  const auto ours = law_of<materials::MohrCoulomb>("library = \"slope_softening\"\n");
  EXPECT_EQ(ours.cohesion_peak, law.cohesion_peak);
  EXPECT_EQ(ours.friction_residual, law.friction_residual);
  EXPECT_EQ(ours.elastic.young, law.elastic.young);
  EXPECT_DOUBLE_EQ(ours.softening, 2.0 * law.softening); // cells of 1 m instead of 0.5 m
}

} // namespace
} // namespace tremolo::scene::testing
