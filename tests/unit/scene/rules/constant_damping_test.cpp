// What a case says of constant damping: its keys, and what rules and plan make of it.

#include "rule_cases.hpp"
#include "scene/plan/plan.hpp"
#include "scene/soils/viscous_damping.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace tremolo::scene::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr const char* named = "[[profile]]\nthickness = 10.0\nsoil = \"sand\"\n";
constexpr const char* constant = "[damping]\nmodel = \"constant\"\nratio = 0.05\n";
constexpr const char* at_3_hz = "reference_hz = 3.0\n";

TEST(ConstantDampingOfACase, HasABandAndMechanisms) {
  const Case plain = parse_case(std::string(flat_case) + constant + at_3_hz);
  EXPECT_EQ(plain.damping.band.lowest_hz, 0.1);
  EXPECT_EQ(plain.damping.band.highest_hz, 25.0);
  EXPECT_EQ(plain.damping.band.mechanisms, 4);
  EXPECT_EQ(relaxation(plain.damping, 0.05).time.size(), 4U);
  const Case own =
      parse_case(std::string(flat_case) + constant + at_3_hz + "band = [0.3, 15.0]\nmechanisms = 3\n");
  EXPECT_EQ(own.damping.band.lowest_hz, 0.3);
  EXPECT_EQ(own.damping.band.highest_hz, 15.0);
  EXPECT_EQ(relaxation(own.damping, 0.05).time.size(), 3U);
}

TEST(ConstantDampingOfACase, NeedsAReferenceAndABandThatRises) {
  EXPECT_THAT(errors_of(std::string(flat_case) + constant),
              ElementsAre(HasSubstr("missing 'reference_hz': at which frequency \"constant\" damping")));
  EXPECT_THAT(errors_of(std::string(flat_case) + constant + at_3_hz + "band = [5.0, 2.0]\n"),
              ElementsAre(HasSubstr("[damping] 'band' = [5, 2] must rise")));
  EXPECT_THAT(errors_of(std::string(flat_case) + constant + at_3_hz + "mechanisms = 13\n"),
              ElementsAre(HasSubstr("'mechanisms' = 13")));
  EXPECT_THAT(errors_of(std::string(flat_case) + "[damping]\nmodel = \"kelvin_voigt\"\nratio = 0.05\n" +
                        at_3_hz + "band = [0.1, 25.0]\n"),
              ElementsAre(HasSubstr("band")));
}

TEST(ConstantDampingOfACase, IsTheSameInFreeFieldAndDomain) {
  const auto differs = HasSubstr("not damped like the domain");
  const auto alone = HasSubstr("they agree at");
  for (const std::string& text : {std::string(flat_case), with_columns()}) {
    const auto remarks = remarks_of(text + named + constant + at_3_hz);
    EXPECT_THAT(remarks, Not(Contains(differs)));
    EXPECT_THAT(remarks, Not(Contains(alone)));
    EXPECT_THAT(errors_of(text + named + constant + at_3_hz), IsEmpty());
  }
}

/// The critical step is that of the stiffness G_U.
TEST(ConstantDampingOfACase, ShortensTheStepByLittleAndSaysWhatItCosts) {
  const double undamped = plan(parse_case(std::string(flat_case))).critical_dt;
  const Case scene = parse_case(std::string(flat_case) + constant + at_3_hz);
  const Plan planned = plan(scene);
  EXPECT_NEAR(planned.critical_dt, undamped / std::sqrt(relaxation(scene.damping, 0.05).unrelaxed()), 1e-12);
  const std::string text = explain(scene, planned);
  EXPECT_THAT(text, HasSubstr("soil 'sand' 5 %, by 4 mechanisms within 1.3 % of it over 0.1 to 25 Hz"));
  EXPECT_THAT(text, HasSubstr("no soil of the domain has viscous damping"));
  EXPECT_THAT(remarks_of(std::string(flat_case) + constant + at_3_hz),
              Not(Contains(HasSubstr("sets the time step"))));
  const std::string much = "[damping]\nmodel = \"constant\"\nratio = 0.2\nreference_hz = 3.0\n";
  EXPECT_THAT(remarks_of(std::string(flat_case) + much),
              Contains(HasSubstr("constant damping sets the time step")));
}

/// asin(c_s/c_p sqrt(G/G_U)) for nu = 0.28: 33.56 degrees without damping.
TEST(ConstantDampingOfACase, LowersTheCriticalAngle) {
  const double unrelaxed = materials::relaxation({3.0, {}}, 0.05).unrelaxed();
  const double critical = std::asin(std::sqrt(0.22 / 0.72 / unrelaxed)) * 180.0 / std::numbers::pi;
  const auto at = [&](double angle) {
    return errors_of(with("angle_deg = 0.0", fmt::format("angle_deg = {:.2f}", angle),
                          with("left = { model = \"wave\" }", "left = { model = \"fe\" }")) +
                     named + constant + at_3_hz);
  };
  EXPECT_NEAR(critical, 29.55, 0.01);
  EXPECT_THAT(at(critical - 0.05), IsEmpty());
  EXPECT_THAT(at(critical + 0.05),
              Contains(HasSubstr("the critical angle of layer 1 from the top, soil 'sand'")));
}

} // namespace
} // namespace tremolo::scene::testing
