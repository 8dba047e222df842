// The rules of soils and layers, each with a case that keeps it and one that breaks it, and the message.

#include "rule_cases.hpp"
#include "scene/plan/plan.hpp"

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
  const std::string rayleigh = "[damping]\nmodel = \"rayleigh\"\nfrequencies = [1.0, 5.0]\n";
  EXPECT_THAT(errors_of(waves + rayleigh), IsEmpty());
  const auto refused = [&](std::string_view before, std::string_view after, const char* why) {
    const std::string changed = with(before, after) + std::string(layer) + "damping = 0.02\n" + rayleigh;
    EXPECT_THAT(errors_of(changed), Contains(HasSubstr(why)));
  };
  refused("angle_deg = 0.0", "angle_deg = 5.0", "known to \"wave\" at vertical incidence only");
  refused("wave = \"SV\"\n", "wave = \"SV\"\nkind = \"within\"\n", "under incident and outcrop motions only");
  refused("[halfspace]\n", "[halfspace]\ndamping = 0.01\n", "relative to the motion of undamped rock");
  refused("left = { model = \"wave\" }", "left = { model = \"eql\" }",
          "model = \"rayleigh\" is for columns and \"wave\"");
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

TEST(Rules, SoilIsThatOfHalfspace) {
  EXPECT_THAT(remarks_of(std::string(flat_case)), Not(Contains(HasSubstr("differs elastically"))));
  const auto softer = with("model = \"linear_elastic\"\ndensity = 1700.0\nyoung = 40e6",
                           "model = \"linear_elastic\"\ndensity = 1700.0\nyoung = 20e6");
  EXPECT_THAT(remarks_of(softer),
              Contains(HasSubstr("case.toml:13:1: warning: [soil.sand] soil 'sand' differs elastically from "
                                 "[halfspace]")));
  EXPECT_THAT(remarks_of(softer + std::string(layer)), Not(Contains(HasSubstr("differs elastically"))));
}

TEST(Rules, SofteningGoesWithCells) {
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

/// The flat case with sand that yields.
std::string with_strength(const char* more, const char* poisson = "0.28") {
  return with("model = \"linear_elastic\"\ndensity = 1700.0\nyoung = 40e6\npoisson = 0.28\n",
              std::string("model = \"mohr_coulomb\"\ndensity = 1700.0\nyoung = 40e6\npoisson = ") + poisson +
                  "\ncohesion_peak = 4e3\ncohesion_residual = 4e3\nsoftening = 0.0\n" + more);
}
constexpr const char* friction = "friction_peak_deg = 30.0\nfriction_residual_deg = 30.0\n";
constexpr const char* no_friction = "friction_peak_deg = 0.0\nfriction_residual_deg = 0.0\n";

TEST(Rules, SofteningNeedsTheSizeThatItHoldsFor) {
  const auto softening = [](const char* more) {
    return with("softening = 0.0\n", std::string("softening = 15.0\n") + more, with_strength(friction));
  };
  EXPECT_THAT(
      errors_of(softening("")),
      ElementsAre(HasSubstr("[soil.sand] missing 'reference_size', m: the cell size for which 'softening' = "
                            "15 holds")));
  EXPECT_THAT(errors_of(softening("reference_size = 1.0\n")), IsEmpty());
  EXPECT_THAT(errors_of(with_strength(friction)), IsEmpty());
}

TEST(Rules, FreeFieldYieldsLikeSoil) {
  const auto elastic = HasSubstr("the free field is elastic, the soil 'sand' beside it is not");
  EXPECT_THAT(remarks_of(std::string(flat_case)), Not(Contains(elastic)));
  // 2 rho c_s v = 2 * 1700 kg/m3 * 95.87 m/s * 0.1 m/s
  EXPECT_THAT(remarks_of(with_strength(friction)),
              Contains(HasSubstr(
                  "case.toml:30:18: warning: [boundary.left] the free field is elastic, the soil 'sand' "
                  "beside it is not: the side shakes it with shear stresses of the order of 32.6 kPa")));
  const auto columns =
      with_columns(with_strength(friction)) + "[[profile]]\nthickness = 10.0\nsoil = \"sand\"\n";
  EXPECT_THAT(remarks_of(columns), Not(Contains(elastic)));
}

TEST(Rules, DomainIsDampedLikeFreeField) {
  const auto damped = std::string(flat_case) + std::string(layer) + "damping = 0.05\n";
  // 1 - exp(-2 pi 3 Hz 0.05 4 m / 80 m/s)
  const auto differs = HasSubstr("the free field is not damped like the domain beside it");
  EXPECT_THAT(
      remarks_of(damped + "[damping]\nmodel = \"hysteretic\"\n"),
      Contains(HasSubstr(
          "warning: [damping] the free field is not damped like the domain beside it: a shear wave of 3 Hz "
          "loses 4.6 % of its amplitude on its way up through the free field, and 0 % on its way up through "
          "the domain")));
  EXPECT_THAT(remarks_of(std::string(flat_case) + std::string(layer)), Not(Contains(differs)));

  // One soil, one damping; the half-space below has none.
  const std::string kelvin = "[damping]\nmodel = \"kelvin_voigt\"\nratio = 0.05\nreference_hz = 3.0\n";
  const auto named = [](double thickness) {
    return fmt::format("[[profile]]\nthickness = {}\nsoil = \"sand\"\n", thickness);
  };
  EXPECT_THAT(remarks_of(std::string(flat_case) + named(10.0) + kelvin), Not(Contains(differs)));
  EXPECT_THAT(remarks_of(std::string(flat_case) + named(5.0) + kelvin), Contains(differs));
  EXPECT_THAT(remarks_of(std::string(flat_case) + kelvin), Contains(differs));
}

TEST(Rules, DampingOfTheDomainHasTheFrequenciesOfTheFreeField) {
  const std::string named = "[[profile]]\nthickness = 10.0\nsoil = \"sand\"\n[damping]\nratio = 0.05\n";
  const auto alone = HasSubstr("they agree at 3 Hz alone");
  const std::string hysteretic = named + "model = \"hysteretic\"\n";
  EXPECT_THAT(
      errors_of(std::string(flat_case) + hysteretic),
      ElementsAre(HasSubstr("missing 'reference_hz': at which frequency the Kelvin-Voigt damping of the "
                            "domain")));
  EXPECT_THAT(remarks_of(std::string(flat_case) + hysteretic + "reference_hz = 3.0\n"), Contains(alone));
  EXPECT_THAT(remarks_of(with_columns() + hysteretic + "reference_hz = 3.0\n"), Not(Contains(alone)));
  EXPECT_THAT(remarks_of(std::string(flat_case) + named + "model = \"kelvin_voigt\"\nreference_hz = 3.0\n"),
              Not(Contains(alone)));
  EXPECT_THAT(remarks_of(with_columns() + named + "model = \"rayleigh\"\nfrequencies = [1.0, 4.0]\n"),
              Not(Contains(alone)));
}

TEST(Rules, ParticlesTakeAllDamping) {
  const std::string sand = with("poisson = 0.28\n[[region]]", "poisson = 0.28\ndamping = 0.02\n[[region]]");
  const std::string rayleigh = "[damping]\nmodel = \"rayleigh\"\nfrequencies = [1.0, 4.0]\n";
  EXPECT_THAT(remarks_of(sand + rayleigh), Not(Contains(HasSubstr("Rayleigh's damping"))));
  EXPECT_THAT(
      remarks_of(with("angle_deg = 0.0", "angle_deg = 40.0", sand) + rayleigh),
      Contains(HasSubstr("the domain has the part of Rayleigh's damping that is proportional to stiffness "
                         "alone: 0.2 of its ratio at 1 Hz and 0.8 at 4 Hz")));
  EXPECT_THAT(remarks_of(sand + "[damping]\nmodel = \"kelvin_voigt\"\nreference_hz = 3.0\n"),
              Not(Contains(HasSubstr("Rayleigh's damping"))));
}

TEST(Rules, OneSoilHasOneDamping) {
  const std::string kelvin = "[damping]\nmodel = \"kelvin_voigt\"\nratio = 0.05\nreference_hz = 3.0\n";
  const std::string named = "[[profile]]\nthickness = 10.0\nsoil = \"sand\"\n";
  const std::string own = with("poisson = 0.28\n[[region]]", "poisson = 0.28\ndamping = 0.02\n[[region]]");
  for (const auto& [text, ratio] : {std::pair(std::string(flat_case), 0.05), std::pair(own, 0.02)}) {
    const Case scene = parse_case(text + named + kelvin);
    EXPECT_EQ(scene.soils.front().damping, ratio);
    EXPECT_EQ(scene.profile.front().damping, ratio);
  }
  EXPECT_THAT(errors_of(std::string(flat_case) + named + "damping = 0.02\n" + kelvin),
              ElementsAre(HasSubstr("'damping' and 'soil' exclude each other")));
  EXPECT_THAT(errors_of(own + named),
              ElementsAre(HasSubstr("'damping' = 0.02 has no effect without a damping model")));
}

/// t = 0.65 h/c_p becomes sqrt(t^2 + beta^2) - beta, beta = xi/(pi f).
TEST(Rules, DampingLeavesTheStep) {
  const std::string damped =
      std::string(flat_case) + "[damping]\nmodel = \"kelvin_voigt\"\nratio = 0.05\n" + "reference_hz = 3.0\n";
  const double undamped = plan(parse_case(std::string(flat_case))).critical_dt;
  const double beta = 0.05 / (std::numbers::pi * 3.0);
  const Plan plan_of_damped = plan(parse_case(damped));
  EXPECT_NEAR(plan_of_damped.critical_dt, std::hypot(undamped, beta) - beta, 1e-12);
  EXPECT_THAT(explain(parse_case(damped), plan_of_damped), HasSubstr("soil 'sand' 5 % at 3 Hz"));
  // t = 3.7478 ms, beta = 5.3052 ms: 1.1903 ms, t being 3.15 times as long.
  EXPECT_THAT(explain(parse_case(damped), plan_of_damped),
              HasSubstr("\n             set by soil 'sand' on cells of 1 m; 0.003748 s without damping\n"));
  EXPECT_THAT(remarks_of(damped),
              Contains(HasSubstr("note: [damping] viscous damping sets the time step: the critical step is "
                                 "0.00119 s, that of soil 'sand' on cells of 1 m, and 0.00375 s without "
                                 "damping, 3.15 times as long")));
  EXPECT_THAT(remarks_of(std::string(flat_case)), Not(Contains(HasSubstr("sets the time step"))));
  EXPECT_THAT(errors_of(with("[[stage]]", fmt::format("[time]\ndt = {}\n\n[[stage]]", undamped), damped)),
              ElementsAre(HasSubstr("exceeds the critical step sqrt(t^2 + beta^2) - beta")));
}

TEST(Rules, YieldingSoilDoesNotLock) {
  const auto own_dilatation = [](std::string text) {
    return text.replace(text.find("[mesh]\n"), 7, "[mesh]\ndilatation = \"particle\"\n");
  };
  EXPECT_THAT(remarks_of(with_strength(friction, "0.495")), Not(Contains(HasSubstr("lock"))));
  EXPECT_THAT(remarks_of(own_dilatation(with_strength(friction))), Not(Contains(HasSubstr("lock"))));
  EXPECT_THAT(remarks_of(own_dilatation(with_strength(friction, "0.495"))),
              Contains(HasSubstr("warning: [soil.sand] soil 'sand': Poisson's ratio 0.495 is above 0.45")));
  EXPECT_THAT(remarks_of(with("poisson = 0.28\n[[region]]", "poisson = 0.495\n[[region]]")),
              Not(Contains(HasSubstr("lock"))));
}

TEST(Rules, TensionHasALimit) {
  EXPECT_THAT(remarks_of(with_strength(friction)), Not(Contains(HasSubstr("limit of tension"))));
  EXPECT_THAT(remarks_of(with_strength(no_friction)),
              Contains(HasSubstr("note: [soil.sand] soil 'sand' has no limit of tension")));
  EXPECT_THAT(remarks_of(with_strength((std::string(no_friction) + "tension_cutoff = 0.0\n").c_str())),
              Not(Contains(HasSubstr("limit of tension"))));
}

TEST(Rules, SaturatedSoilHasWater) {
  const auto heavy = with("density = 1700.0\nyoung = 40e6\npoisson = 0.28\n[[region]]",
                          "density = 2000.0\nyoung = 40e6\npoisson = 0.28\n[[region]]");
  EXPECT_THAT(remarks_of(heavy), Not(Contains(HasSubstr("no water"))));
  EXPECT_THAT(
      remarks_of(with("[[stage]]\n", "[[stage]]\nkind = \"gravity\"\n[[stage]]\n", heavy)),
      Contains(HasSubstr("warning: [soil.sand] soil 'sand': 2000 kg/m3 is the density of saturated soil, but "
                         "the domain has no water: all of the weight is effective stress, 2 times that")));
}

TEST(Rules, OneStressAtRestForDomainAndColumns) {
  const auto text =
      with("model = \"linear_elastic\"\n", "model = \"linear_elastic\"\nrest_coefficient = 0.7\n",
           plus("[[profile]]\nthickness = 10.0\nsoil = \"sand\"\n"));
  const Case scene = parse_case(text);
  EXPECT_EQ(materials::elasticity(scene.soils[0].law).rest_coefficient(), 0.7);
  EXPECT_EQ(materials::elasticity(scene.soils[0].column_law).rest_coefficient(), 0.7);
  EXPECT_EQ(scene.profile[0].elastic.rest_coefficient(), 0.7);
  const Case plain = parse_case(std::string(flat_case));
  EXPECT_NEAR(materials::elasticity(plain.soils[0].law).rest_coefficient(), 0.28 / 0.72, 1e-15);
}

} // namespace
} // namespace tremolo::scene::testing
