#include "case_text.hpp"

#include "scene/plan/plan.hpp"
#include "scene/read/soil/curve_table.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::scene::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The flat case, linear in its domain, with a layer of hysteretic soil in its free field.
std::string with_clay(const std::string& keys) {
  return plus("[soil.clay]\ndensity = 1700.0\nvs = 100.0\nvp = 200.0\n" + keys +
              "[[profile]]\nthickness = 4.0\nsoil = \"clay\"\n");
}

TEST(HystereticSoil, BackboneAsGiven) {
  const auto scene =
      parse_case(with_clay("model = \"mkz\"\nreference_strain = 5e-4\nbeta = 1.2\nexponent = 0.9\n"));
  const auto& soil = scene.soils.at(*scene.profile.at(0).soil);
  const auto& law = std::get<materials::MasingShear>(soil.column_law);
  EXPECT_EQ(law.reference_strain, 5e-4);
  EXPECT_EQ(law.beta, 1.2);
  EXPECT_EQ(law.exponent, 0.9);
  EXPECT_TRUE(std::holds_alternative<materials::IwanShear>(soil.law));
  EXPECT_DOUBLE_EQ(soil.curves->modulus_reduction(5e-4), 1.0 / 2.2);
  EXPECT_FALSE(soil.curves->whole);
}

TEST(HystereticSoil, HyperbolaIsTheBackboneOfExponentOne) {
  const auto scene = parse_case(with_clay("model = \"hyperbolic\"\nreference_strain = 5e-4\n"));
  const auto& law = std::get<materials::MasingShear>(scene.soils.at(*scene.profile.at(0).soil).column_law);
  EXPECT_EQ(law.beta, 1.0);
  EXPECT_EQ(law.exponent, 1.0);
}

TEST(Rules, BackboneIsFitted) {
  const auto text =
      with_clay("model = \"mkz\"\ncurve = \"darendeli\"\nplasticity_index = 15\nmean_stress = 101325.0\n");
  const auto scene = parse_case(text);
  const auto& soil = scene.soils.at(*scene.profile.at(0).soil);
  const auto& law = std::get<materials::MasingShear>(soil.column_law);
  // Darendeli (2001): gamma_r = (0.0352 + 0.0010 PI) per cent at 1 atm and OCR 1, exponent 0.9190.
  EXPECT_NEAR(law.reference_strain, 0.000503, 0.000001);
  EXPECT_NEAR(law.exponent, 0.919, 0.001);
  EXPECT_TRUE(soil.curves->whole);
  EXPECT_THAT(remarks_of(text), ::testing::Contains(HasSubstr("soil 'clay': backbone fitted to its curve")));
}

TEST(HystereticSoil, SaysWhatIsMissingOrTooMuch) {
  EXPECT_THAT(errors_of(with_clay("model = \"mkz\"\nreference_strain = 5e-4\nbeta = 1.0\n")),
              ElementsAre(HasSubstr("missing 'exponent': without 'curve' the backbone is given")));
  EXPECT_THAT(
      errors_of(with_clay("model = \"mkz\"\ncurve = \"darendeli\"\nplasticity_index = 15\nmean_stress = "
                          "1e5\nbeta = 1.0\n")),
      ElementsAre(HasSubstr("'beta' and 'curve' exclude each other")));
  EXPECT_THAT(errors_of(with_clay("model = \"hyperbolic\"\nreference_strain = 5e-4\ncurve = \"darendeli\"\n"
                                  "plasticity_index = 15\nmean_stress = 1e5\n")),
              ::testing::Contains(HasSubstr("'curve' does not apply to model = \"hyperbolic\"")));
  EXPECT_THAT(errors_of(with_clay("model = \"mkz\"\ncurve = \"none.csv\"\n")),
              ElementsAre(HasSubstr("none.csv: there is no such file")));
  EXPECT_THAT(errors_of(with_clay("model = \"mkz\"\nreference_strain = 5e-4\nbeta = 1.0\nexponent = 1.5\n")),
              ElementsAre(HasSubstr("'exponent' = 1.5 is out of range, must be in [0.1, 1]")));
}

materials::Backbone backbone_of(const Case& scene) {
  return *materials::shear_backbone(scene.soils.at(*scene.profile.at(0).soil).column_law);
}

const std::string darendeli_clay = "curve = \"darendeli\"\nplasticity_index = 15\nmean_stress = 101325.0\n";

TEST(HystereticSoil, WithAStrengthReachesIt) {
  const auto text = with_clay("model = \"gqh\"\nshear_strength = 12e3\n" + darendeli_clay);
  const auto scene = parse_case(text);
  const auto backbone = backbone_of(scene);
  EXPECT_DOUBLE_EQ(backbone.strength(), 12e3);
  EXPECT_GT(backbone.stress(0.1), 0.95 * 12e3);
  EXPECT_TRUE(scene.soils.at(*scene.profile.at(0).soil).curves->whole);
  EXPECT_THAT(remarks_of(text), ::testing::Contains(HasSubstr("times the strength given, 12 kPa")));
  const auto given =
      parse_case(with_clay("model = \"gqh\"\nshear_strength = 12e3\ntheta = [-5, 4, 1, 1, 0.99]\n"));
  EXPECT_EQ(backbone_of(given).shape->first, -5.0);
  EXPECT_EQ(backbone_of(given).shape->fifth, 0.99);
}

/// The strength of the law in the domain: what a factor of safety is taken of.
TEST(HystereticSoil, OfAnyBackboneKnowsTheStrengthThatItIsGiven) {
  const auto strength = [](const std::string& keys) {
    const auto scene = parse_case(with_clay(keys));
    return std::get<materials::IwanShear>(scene.soils.at(*scene.profile.at(0).soil).law).strength;
  };
  EXPECT_EQ(strength("model = \"gqh\"\nshear_strength = 12e3\n" + darendeli_clay), 12e3);
  EXPECT_EQ(strength("model = \"hyperbolic\"\nreference_strain = 5e-4\nshear_strength = 5e3\n"), 5e3);
  EXPECT_FALSE(strength("model = \"hyperbolic\"\nreference_strain = 5e-4\n"));
}

TEST(Rules, BackboneHasGivenStrength) {
  const auto with_strength = [](const std::string& strength) {
    return remarks_of(
        with_clay("model = \"mkz\"\nreference_strain = 5e-4\nbeta = 1.0\nexponent = 0.9\n" + strength));
  };
  EXPECT_THAT(with_strength(""), ::testing::Not(::testing::Contains(HasSubstr("times the strength given"))));
  EXPECT_THAT(with_strength("shear_strength = 14e3\n"),
              ::testing::Contains(::testing::EndsWith("1.02 times the strength given, 14 kPa")));
  EXPECT_THAT(
      with_strength("shear_strength = 5e3\n"),
      ::testing::Contains(::testing::AllOf(HasSubstr("at 10 % shear strain its backbone has 14.32 kPa, 2.86 "
                                                     "times the strength given, 5 kPa"),
                                           HasSubstr("model = \"gqh\" keeps to the strength"))));
}

TEST(HystereticSoil, UnloadsWithTheDampingOfItsCurve) {
  const auto fitted = parse_case(with_clay("model = \"mkz\"\nunloading = \"mrdf\"\n" + darendeli_clay));
  EXPECT_TRUE(backbone_of(fitted).loops.any());
  EXPECT_TRUE(std::get<materials::IwanShear>(fitted.soils.at(*fitted.profile.at(0).soil).law).loops.any());
  const auto given = parse_case(with_clay(
      "model = \"hyperbolic\"\nreference_strain = 5e-4\nunloading = \"mrdf\"\nmrdf = [0.8, 0.4, 0.7]\n"));
  EXPECT_EQ(backbone_of(given).loops.loss, 0.4);
  EXPECT_FALSE(backbone_of(parse_case(with_clay("model = \"mkz\"\n" + darendeli_clay))).loops.any());
}

TEST(HystereticSoil, SaysWhatStrengthAndUnloadingLack) {
  EXPECT_THAT(errors_of(with_clay("model = \"gqh\"\n" + darendeli_clay)),
              ElementsAre(HasSubstr("missing 'shear_strength': model = \"gqh\" needs it")));
  EXPECT_THAT(errors_of(with_clay("model = \"gqh\"\nshear_strength = 12e3\n")),
              ElementsAre(HasSubstr("missing 'theta': without 'curve' the backbone is given")));
  EXPECT_THAT(errors_of(with_clay("model = \"gqh\"\nshear_strength = 12e3\ntheta = [2, 0, 1, 1, 1]\n")),
              ElementsAre(HasSubstr("theta1 = 2 is outside")));
  EXPECT_THAT(errors_of(with_clay("model = \"gqh\"\nshear_strength = 12\ntheta = [0, 0, 1, 1]\n")),
              ElementsAre(HasSubstr("theta")));
  EXPECT_THAT(errors_of(with_clay("model = \"hyperbolic\"\nreference_strain = 5e-4\nunloading = \"mrdf\"\n")),
              ElementsAre(HasSubstr("missing 'mrdf': without 'curve' there is no damping to fit it to")));
  EXPECT_THAT(errors_of(with_clay("model = \"hyperbolic\"\nreference_strain = 5e-4\nunloading = \"mrdf\"\n"
                                  "mrdf = [1.2, 0.1, 1.0]\n")),
              ElementsAre(HasSubstr("p1 of the reduction of loops = 1.2 is outside [0, 1]")));
}

TEST(HystereticSoil, OfALayerAloneCostsTheDomainNothing) {
  const auto text = with_clay("model = \"mkz\"\nreference_strain = 5e-4\nbeta = 1.0\nexponent = 0.9\n");
  const auto layered = plan(parse_case(text));
  const auto flat = plan(parse_case(std::string(flat_case)));
  EXPECT_EQ(layered.memory_bytes, flat.memory_bytes);
  EXPECT_EQ(layered.critical_dt, flat.critical_dt);
  EXPECT_THAT(remarks_of(text),
              ::testing::Contains(HasSubstr("model \"wave\" takes layers of soil 'clay' as linear")));
}

class CurveTable : public ::testing::Test {
protected:
  std::string error_of(const std::string& text) const {
    const auto file = folder_.write("curve.csv", text);
    try {
      read_curve_table(file);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  }

  tremolo::testing::TemporaryFolder folder_;
};

TEST_F(CurveTable, IsReadAsItStands) {
  const auto file = folder_.write(
      "curve.csv", "# measured\nstrain,modulus_reduction,damping\n1e-5, 0.99, 0.01\r\n1e-3,0.4,0.12\n");
  const auto curves = read_curve_table(file);
  EXPECT_EQ(curves.strain, (std::vector{1e-5, 1e-3}));
  EXPECT_EQ(curves.modulus_ratio, (std::vector{0.99, 0.4}));
  EXPECT_EQ(curves.damping_ratio, (std::vector{0.01, 0.12}));
}

TEST_F(CurveTable, NamesTheLineOfWhatIsWrong) {
  const std::string header = "strain,modulus_reduction,damping\n";
  EXPECT_THAT(error_of("gamma,g,d\n1,2,3\n"), HasSubstr("curve.csv:1: expected the header"));
  EXPECT_THAT(error_of(header + "1e-5,0.99\n"), HasSubstr("curve.csv:2: expected three numbers"));
  EXPECT_THAT(error_of(header + "1e-5,0.99,x\n"), HasSubstr("curve.csv:2: expected three numbers"));
  EXPECT_THAT(error_of(header + "1e-5,0.99,0.1,7\n"), HasSubstr("curve.csv:2: expected three numbers"));
  EXPECT_THAT(error_of(header + "1e-3,0.9,0.1\n1e-5,0.99,0.1\n"), HasSubstr("curve.csv"));
  EXPECT_THAT(error_of(header), HasSubstr("curve.csv"));
  EXPECT_THAT(error_of(header + std::string(5000, '1')), HasSubstr("more than 4096 characters"));
}

} // namespace
} // namespace tremolo::scene::testing
