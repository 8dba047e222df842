// The rules of soils and layers, each with a case that keeps it and one that breaks it, and the message.

#include "rule_cases.hpp"

#include <gmock/gmock.h>

namespace tremolo::scene::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TEST(Rules, DampingSuitsModels) {
  const auto damped = with_columns() + std::string(layer) + "damping = 0.02\n";
  EXPECT_THAT(
      errors_of(damped),
      ElementsAre("case.toml:36:11: [[profile]] 'damping' = 0.02 has no effect without a damping model; set "
                  "[damping] model, e.g. to \"kelvin_voigt\""));
  EXPECT_THAT(errors_of(damped + "[damping]\nmodel = \"rayleigh\"\nfrequencies = [1.0, 5.0]\n"), IsEmpty());
  EXPECT_THAT(errors_of(damped + "[damping]\nmodel = \"hysteretic\"\n"),
              ElementsAre(::testing::HasSubstr(
                  "missing 'reference_hz': at which frequency the Kelvin-Voigt damping of a "
                  "column")));
  EXPECT_THAT(errors_of(damped + "[damping]\nmodel = \"hysteretic\"\nreference_hz = 3.0\n"), IsEmpty());
  const auto waves = std::string(flat_case) + std::string(layer) + "damping = 0.02\n";
  EXPECT_THAT(errors_of(waves + "[damping]\nmodel = \"hysteretic\"\n"), IsEmpty());
  EXPECT_THAT(errors_of(waves + "[damping]\nmodel = \"rayleigh\"\nfrequencies = [1.0, 5.0]\n"),
              ElementsAre(::testing::HasSubstr("model = \"rayleigh\" is for columns")));
}

constexpr std::string_view clay = "[soil.clay]\nmodel = \"mkz\"\ndensity = 1700.0\nvs = 80.0\nvp = 150.0\n";

TEST(Rules, ModelsKnowNonlinearSoil) {
  std::string layers(clay);
  layers +=
      "reference_strain = 5e-4\nbeta = 1.0\nexponent = 0.9\n[[profile]]\nthickness = 4.0\nsoil = \"clay\"\n";
  const auto layered = [&](std::string_view left) {
    return with("left = { model = \"wave\" }", left, plus(layers));
  };
  EXPECT_THAT(
      remarks_of(layered("left = { model = \"wave\" }")),
      Contains("case.toml:25:18: warning: [boundary.left] 'left-right-base': model \"wave\" takes layers "
               "of soil 'clay' as linear elastic"));
  EXPECT_THAT(remarks_of(layered("left = { model = \"fe\" }")), Not(Contains(HasSubstr("'left': "))));
}

TEST(Rules, SoilIsThatOfTheHalfspace) {
  EXPECT_THAT(remarks_of(std::string(flat_case)), Not(Contains(HasSubstr("differs elastically"))));
  const auto softer = with("model = \"linear_elastic\"\ndensity = 1700.0\nyoung = 40e6",
                           "model = \"linear_elastic\"\ndensity = 1700.0\nyoung = 20e6");
  EXPECT_THAT(remarks_of(softer),
              Contains(HasSubstr("case.toml:13:1: warning: [soil.sand] soil 'sand' differs elastically from "
                                 "[halfspace]")));
  EXPECT_THAT(remarks_of(softer + std::string(layer)), Not(Contains(HasSubstr("differs elastically"))));
}

TEST(Rules, SofteningGoesWithTheCells) {
  const auto soil = with(
      "model = \"linear_elastic\"\n",
      "model = \"mohr_coulomb\"\ncohesion_peak = 4e3\ncohesion_residual = 0.0\nfriction_peak_deg = 30.0\n"
      "friction_residual_deg = 25.0\nsoftening = 15.0\nreference_size = 0.25\n");
  EXPECT_THAT(
      remarks_of(soil + "[[refine]]\nbox = [5.0, -4.0, 15.0, 0.0]\nlevel = 2\n"),
      Contains("case.toml:19:13: note: [soil.sand] soil 'sand': softening eta = 60, 30, 15 on cells of "
               "1, 0.5, 0.25 m"));
  EXPECT_THAT(remarks_of(soil), Not(Contains(HasSubstr("softening eta"))));
}

} // namespace
} // namespace tremolo::scene::testing
