#include "materials/law/law.hpp"
#include "tests/support/pm4sand_soil.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <set>
#include <stdexcept>

namespace tremolo::materials::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Pm4SandInput input() {
  return {.density = 1900.0, .relative_density = 0.55, .G_o = 677.0, .h_po = 0.4};
}

std::map<std::string_view, ParameterValue> by_name(const Pm4Sand& law) {
  std::map<std::string_view, ParameterValue> result;
  for (const ParameterValue& parameter : parameters(law)) {
    result[parameter.name] = parameter;
  }
  return result;
}

/// Values worked out by hand from table 2 of the report.
TEST(Pm4Parameters, DefaultsFollowTheDensity) {
  struct Expected {
    int density;
    double h_o, C_DR, C_kaf, c_eps, F_sed_min;
  };
  for (const Expected& expected :
       {Expected{35, 0.30, 5.0, 5.16038, 0.5, 0.0745297}, Expected{55, 0.40, 10.0, 10.36558, 0.5, 0.1253610},
        Expected{75, 0.50, 10.0, 30.88278, 0.2, 0.2108606}}) {
    const Pm4Sand law = report_sand(expected.density);
    EXPECT_NEAR(law.h_o, expected.h_o, 1e-12);
    EXPECT_NEAR(law.C_DR, expected.C_DR, 1e-12);
    EXPECT_NEAR(law.C_kaf, expected.C_kaf, 1e-5);
    EXPECT_NEAR(law.c_eps, expected.c_eps, 1e-12);
    EXPECT_NEAR(law.F_sed_min, expected.F_sed_min, 1e-6);
    EXPECT_NEAR(law.M, 1.0892780700, 1e-9); // 2 sin 33 degrees
    EXPECT_NEAR(law.bulk_ratio, 13.0 / 6.0, 1e-12);
  }
  const Pm4Sand dense = pm4sand({.density = 1900.0, .relative_density = 0.65, .G_o = 800.0, .h_po = 0.5});
  EXPECT_NEAR(dense.c_eps, 0.35, 1e-12); // half way
  const Pm4Sand loose = pm4sand({.density = 1900.0, .relative_density = 0.10, .G_o = 300.0, .h_po = 0.5});
  EXPECT_NEAR(loose.C_kaf, 4.098880, 1e-6);
  EXPECT_EQ(loose.C_DR, 1.0); // the report's line would be negative
  EXPECT_NEAR(loose.h_o, 0.3, 1e-12);
}

TEST(Pm4Parameters, DefaultsFollowWhatIsGiven) {
  Pm4SandInput given = input();
  given.p_A = 100e3;
  const Pm4Sand law = pm4sand(given);
  EXPECT_EQ(law.p_sedo, 20e3);
  EXPECT_NEAR(law.elastic.shear_modulus(), 677.0 * 100e3, 1e-3);
}

TEST(Pm4Parameters, AreListedWithTheirOrigin) {
  Pm4SandInput given = input();
  given.h_o = 0.5;
  given.z_max = 3.0;
  const auto list = by_name(pm4sand(given));
  const std::set<std::string_view> names = {"density",
                                            "relative_density",
                                            "shear_modulus_coefficient",
                                            "contraction_rate",
                                            "atmospheric_pressure",
                                            "e_max",
                                            "e_min",
                                            "n_b",
                                            "n_d",
                                            "phi_cv_deg",
                                            "poisson",
                                            "Q",
                                            "R",
                                            "m",
                                            "h_o",
                                            "A_do",
                                            "z_max",
                                            "c_z",
                                            "c_eps",
                                            "C_GD",
                                            "C_DR",
                                            "C_kaf",
                                            "F_sed_min",
                                            "p_sedo",
                                            "tolerance",
                                            "post_shake"};
  EXPECT_EQ(list.size(), names.size());
  for (const std::string_view name : names) {
    ASSERT_TRUE(list.contains(name)) << name;
    EXPECT_FALSE(list.at(name).meaning.empty());
    EXPECT_TRUE(std::isfinite(list.at(name).value)) << name;
  }
  EXPECT_EQ(list.at("h_o").origin, "given");
  EXPECT_EQ(list.at("h_o").value, 0.5);
  EXPECT_EQ(list.at("z_max").origin, "given");
  EXPECT_EQ(list.at("c_eps").origin, "default: 0.5 - 1.5 (D_R - 0.55) in [0.2, 0.5]");
  EXPECT_NE(list.at("A_do").origin.find("initial stress"), std::string::npos);
  EXPECT_EQ(list.at("p_sedo").unit, "Pa");
  EXPECT_EQ(list.at("phi_cv_deg").unit, "degrees");
  EXPECT_NEAR(list.at("phi_cv_deg").value, 33.0, 1e-12);
}

TEST(Pm4Parameters, OutsideTheirRangeAreRefused) {
  const auto refused = [](auto change) {
    Pm4SandInput wrong = input();
    change(wrong);
    EXPECT_THROW(pm4sand(wrong), std::invalid_argument);
  };
  refused([](Pm4SandInput& i) { i.density = 0.0; });
  refused([](Pm4SandInput& i) { i.density.reset(); });
  refused([](Pm4SandInput& i) { i.h_po.reset(); });
  refused([](Pm4SandInput& i) { i.relative_density = 55.0; }); // per cent
  refused([](Pm4SandInput& i) { i.relative_density = nan; });
  refused([](Pm4SandInput& i) { i.G_o = -1.0; });
  refused([](Pm4SandInput& i) { i.h_po = 0.0; });
  refused([](Pm4SandInput& i) { i.h_po = nan; });
  refused([](Pm4SandInput& i) { i.phi_cv = 33.0; }); // degrees
  refused([](Pm4SandInput& i) { i.e_min = 0.9; });
  refused([](Pm4SandInput& i) { i.poisson = 0.6; });
  refused([](Pm4SandInput& i) { i.C_DR = 20.0; }); // not limited in silence
  refused([](Pm4SandInput& i) { i.C_kaf = 1.0; });
  refused([](Pm4SandInput& i) { i.A_do = nan; });
  refused([](Pm4SandInput& i) { i.z_max = -1.0; });
  for (std::optional<double> Pm4SandInput::*member :
       {&Pm4SandInput::p_A, &Pm4SandInput::e_max, &Pm4SandInput::n_b, &Pm4SandInput::n_d, &Pm4SandInput::Q,
        &Pm4SandInput::R, &Pm4SandInput::m, &Pm4SandInput::h_o, &Pm4SandInput::c_z, &Pm4SandInput::c_eps,
        &Pm4SandInput::C_GD, &Pm4SandInput::C_DR, &Pm4SandInput::C_kaf, &Pm4SandInput::F_sed_min,
        &Pm4SandInput::p_sedo, &Pm4SandInput::tolerance}) {
    refused([member](Pm4SandInput& i) { i.*member = nan; });
  }
}

TEST(Pm4Parameters, ReachTheLawsInterface) {
  const Law law = report_sand(55);
  EXPECT_EQ(name(law), "pm4sand");
  EXPECT_FALSE(traits(law).three_dimensional);
  EXPECT_NEAR(elasticity(law).shear_modulus(), 677.0 * 101.3e3, 1.0);
  EXPECT_TRUE(std::holds_alternative<LinearElastic>(without_softening(law)));
  EXPECT_TRUE(std::get<Pm4Sand>(after_shaking(law)).post_shake);
  const Law elastic = LinearElastic{elasticity(law)};
  EXPECT_TRUE(std::holds_alternative<LinearElastic>(after_shaking(elastic)));
  EXPECT_EQ(parameters(law).size(), 26U);

  std::set<std::string_view> names;
  for (const StateVariable& variable : state_variables(law)) {
    EXPECT_TRUE(names.insert(variable.name).second) << variable.name;
    EXPECT_FALSE(variable.meaning.empty());
  }
}

} // namespace
} // namespace tremolo::materials::test
