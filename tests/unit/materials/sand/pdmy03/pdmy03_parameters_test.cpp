// PDMY03: cones, backbone, recommended sets, defaults and what is said of them.

#include "materials/law/law.hpp"
#include "materials/sand/pdmy03/pdmy03_surfaces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace tremolo::materials {
namespace {

using ::testing::HasSubstr;

constexpr double degree = std::numbers::pi / 180.0;

std::string refusal(const Pdmy03Input& input) {
  try {
    pdmy03(input);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Pdmy03Parameters, ConesMeetMohrCoulombWhereTheyShould) {
  // in triaxial compression s1 = N s3, in extension s3 is the largest: q/p' from the principal stresses
  for (const double phi : {20.0 * degree, 30.3 * degree, 42.2 * degree}) {
    const double n = (1.0 + std::sin(phi)) / (1.0 - std::sin(phi));
    EXPECT_NEAR(cone_ratio(Pdmy03Cone::triaxial_compression, phi), (n - 1.0) / ((n + 2.0) / 3.0), 1e-12);
    EXPECT_NEAR(cone_ratio(Pdmy03Cone::triaxial_extension, phi), (n - 1.0) / ((2.0 * n + 1.0) / 3.0), 1e-12);
    // plane strain with the middle stress half way: q = sqrt(3)/2 (s1 - s3), p' = (s1 + s3)/2
    EXPECT_NEAR(cone_ratio(Pdmy03Cone::plane_strain, phi),
                std::sqrt(3.0) / 2.0 * (n - 1.0) / ((n + 1.0) / 2.0), 1e-12);
    for (const Pdmy03Cone cone :
         {Pdmy03Cone::triaxial_compression, Pdmy03Cone::triaxial_extension, Pdmy03Cone::plane_strain}) {
      EXPECT_NEAR(cone_friction(cone, cone_ratio(cone, phi)), phi, 1e-12);
    }
  }
}

TEST(Pdmy03Parameters, SurfacesFollowTheOctahedralHyperbola) {
  const Pdmy03 law = pdmy03({.relative_density = 0.57});
  const double shear = 73.7e6;
  const double failure = 6.0 * std::sin(30.3 * degree) / (3.0 - std::sin(30.3 * degree));
  const double residual = 2.0 * 1.73e3 / failure;
  EXPECT_NEAR(law.residual_pressure, residual, 1e-9 * residual);
  const double strength = std::sqrt(2.0) / 3.0 * (101e3 + residual) * failure;
  // tau = G gamma/(1 + gamma/gamma_r) reaches the strength at an octahedral strain of 0.1
  const double reference = 0.1 / (shear * 0.1 / strength - 1.0);
  const auto tau = [&](double gamma) { return shear * gamma / (1.0 + gamma / reference); };
  ASSERT_EQ(law.surfaces, 20U);
  double gamma = 0.0;
  double stress = 0.0;
  for (std::size_t i = 1; i <= law.surfaces; ++i) {
    EXPECT_NEAR(law.ratio[i], failure * static_cast<double>(i) / 20.0, 1e-12);
    // surface i begins at a point of the curve, sqrt 2/3 M_i H_r, reached with the tangents before it
    const double begins = std::sqrt(2.0) / 3.0 * law.ratio[i] * (101e3 + residual);
    gamma = i == 1 ? begins / (shear - begins / reference)
                   : gamma + 2.0 * (begins - stress) / law.tangent_modulus[i - 1];
    stress = begins;
    EXPECT_NEAR(tau(gamma) / begins, 1.0, 1e-9) << i;
  }
  EXPECT_NEAR(gamma, 0.1, 1e-9);
  EXPECT_EQ(law.plastic_modulus[20], 0.0);
  for (std::size_t i = 1; i < 20; ++i) { // 1/E = 1/2G + 1/H'
    EXPECT_NEAR(1.0 / law.tangent_modulus[i], 1.0 / (2.0 * shear) + 1.0 / law.plastic_modulus[i], 1e-15);
  }
}

TEST(Pdmy03Parameters, TheRecommendedSets) {
  struct Row {
    double density, shear, bulk, friction, transformation;
  };
  const std::vector<std::pair<double, Row>> rows = {{0.33, {1940, 46.9e6, 125.1e6, 25.4, 20.4}},
                                                    {0.57, {1990, 73.7e6, 196.8e6, 30.3, 25.3}},
                                                    {0.74, {2030, 94.6e6, 252.6e6, 35.8, 30.8}},
                                                    {0.87, {2060, 111.9e6, 298.3e6, 42.2, 37.2}}};
  for (const auto& [relative_density, row] : rows) {
    const Pdmy03 law = pdmy03({.relative_density = relative_density});
    EXPECT_EQ(law.elastic.density, row.density);
    EXPECT_NEAR(law.elastic.shear_modulus(), row.shear, 1e-6 * row.shear);
    EXPECT_NEAR(law.elastic.bulk_modulus(), row.bulk, 1e-6 * row.bulk);
    EXPECT_NEAR(law.elastic.poisson, 1.0 / 3.0, 1e-3); // B/G = 8/3: K0 = 0.5
    EXPECT_NEAR(law.friction, row.friction * degree, 1e-12);
    EXPECT_NEAR(law.phase_transformation, row.transformation * degree, 1e-12);
    EXPECT_EQ(law.dilation[1], 3.0);
  }
  EXPECT_THAT(pdmy03({.relative_density = 0.33}).contraction,
              ::testing::ElementsAre(0.03, 5.0, 0.2, 16.0, 2.0));
  EXPECT_THAT(pdmy03({.relative_density = 0.57}).contraction,
              ::testing::ElementsAre(0.012, 3.0, 0.4, 9.0, 0.0));
  EXPECT_THAT(pdmy03({.relative_density = 0.74}).contraction,
              ::testing::ElementsAre(0.005, 1.0, 0.6, 4.6, -1.0));
  EXPECT_THAT(pdmy03({.relative_density = 0.87}).contraction,
              ::testing::ElementsAre(0.001, 0.0, 0.8, 2.2, 0.0));
  EXPECT_THAT(pdmy03({.relative_density = 0.74}).dilation, ::testing::ElementsAre(0.45, 3.0, -0.4));
}

TEST(Pdmy03Parameters, OtherDensitiesAreRefusedWithTheFourThatHaveASet) {
  for (const double density : {0.0, 0.34, 0.5, 0.65, 57.0, 1.0}) {
    const std::string text = refusal({.relative_density = density});
    for (const char* known : {"0.33", "0.57", "0.74", "0.87", "not interpolated"}) {
      EXPECT_THAT(text, HasSubstr(known)) << density;
    }
    EXPECT_THROW(pdmy03_recommended(density), std::invalid_argument);
  }
}

TEST(Pdmy03Parameters, WithoutADensityWhatIsMissingIsNamed) {
  EXPECT_THAT(refusal({}), HasSubstr("shear_modulus is missing"));
  Pdmy03Input input = pdmy03_recommended(0.57);
  input.relative_density.reset();
  EXPECT_EQ(refusal(input), ""); // complete
  input.contraction[3].reset();
  EXPECT_THAT(refusal(input), HasSubstr("contraction_d is missing"));
}

TEST(Pdmy03Parameters, ValuesOutOfRangeAreRefusedByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal({.relative_density = 0.57, .shear_modulus = -1.0}), HasSubstr("shear_modulus"));
  EXPECT_THAT(refusal({.relative_density = 0.57, .bulk_modulus = nan}), HasSubstr("bulk_modulus"));
  EXPECT_THAT(refusal({.relative_density = 0.57, .friction = 1.4}), HasSubstr("friction"));
  EXPECT_THAT(refusal({.relative_density = 0.57, .phase_transformation = 0.6}),
              HasSubstr("phase_transformation"));
  EXPECT_THAT(refusal({.relative_density = 0.57, .surfaces = 2.0}), HasSubstr("surfaces"));
  EXPECT_THAT(refusal({.relative_density = 0.57, .surfaces = 20.5}), HasSubstr("whole number"));
  EXPECT_THAT(refusal({.relative_density = 0.57, .surfaces = 41.0}), HasSubstr("surfaces"));
  EXPECT_THAT(refusal({.relative_density = 0.57, .peak_shear_strain = 1e-4}), HasSubstr("does not reach"));
  EXPECT_THROW(validate(Pdmy03{}), std::invalid_argument);
}

std::vector<ModulusReduction> darendeli_like() {
  return {{1e-5, 0.98}, {1e-4, 0.85}, {1e-3, 0.38}, {1e-2, 0.07}, {5e-2, 0.018}, {0.1, 0.0095}};
}

TEST(Pdmy03Parameters, AMeasuredCurveReplacesTheHyperbola) {
  const std::vector<ModulusReduction> curve = darendeli_like();
  const Pdmy03 law = pdmy03({.relative_density = 0.57, .modulus_reduction = curve});
  ASSERT_EQ(law.surfaces, curve.size());
  const double height = law.reference_pressure + law.residual_pressure;
  for (std::size_t i = 0; i < curve.size(); ++i) { // in simple shear q = sqrt 3 tau
    const double tau = 73.7e6 * curve[i].shear_strain * curve[i].modulus_ratio;
    EXPECT_NEAR(law.ratio[i + 1] * height, std::sqrt(3.0) * tau, 1e-6 * tau);
  }
  EXPECT_NEAR(cone_ratio(law.cone, law.friction), law.ratio[law.surfaces], 1e-12);
  EXPECT_NEAR(law.residual_pressure, 2.0 * 1.73e3 / law.ratio[law.surfaces], 1e-6);
  EXPECT_THAT(refusal({.relative_density = 0.57, .friction = 0.5, .modulus_reduction = curve}),
              HasSubstr("modulus_reduction already fixes"));
  EXPECT_THAT(refusal({.relative_density = 0.57, .phase_transformation = 1.0, .modulus_reduction = curve}),
              ::testing::AllOf(HasSubstr("phase_transformation_deg = 57.3 is outside [1, "),
                               HasSubstr("degrees, up to friction_deg, which the modulus reduction curve "
                                         "fixes")));
}

TEST(Pdmy03Parameters, SimpleShearUnderConstantPressureFollowsTheMeasuredCurve) {
  // below phase transformation and with no contraction the pressure stays: tau = G G/Gmax gamma at its points
  Pdmy03Input input = pdmy03_recommended(0.57);
  input.modulus_reduction = darendeli_like();
  input.friction.reset();
  input.contraction = {0.0, 0.0, 0.0, 0.0, 0.0};
  input.dilation = {0.0, 0.0, 0.0};
  const Pdmy03 law = pdmy03(input);
  const double p = law.reference_pressure;
  double sxx = -p, syy = -p, szz = -p, sxy = 0.0, work = 0.0;
  const double zero = 0.0;
  double shear = 1e-6;
  std::vector<double> state(state_variables(law).size());
  const Points points = {1, &sxx, &syy, &szz, &sxy, state.data(), &work, &zero, &zero, &shear, &zero};
  initialise(law, points);
  double strain = 0.0;
  for (std::size_t i = 0; i < 3; ++i) { // the first point is reached elastically, 2e-7 of strain too early
    const auto [target, ratio] = input.modulus_reduction[i];
    for (int n = 0, count = static_cast<int>(std::lround((target - strain) / 1e-6)); n < count; ++n) {
      update(law, points);
    }
    strain = target;
    EXPECT_NEAR(sxy, 73.7e6 * ratio * target, 73.7e6 * (2.1e-7 + 1e-3 * ratio * target)) << target;
  }
}

TEST(Pdmy03Parameters, CurvesThatAreNoneAreRefused) {
  const auto curve = [](std::vector<ModulusReduction> points) {
    return refusal({.relative_density = 0.57, .modulus_reduction = std::move(points)});
  };
  EXPECT_THAT(curve({{1e-4, 0.9}}), HasSubstr("1 points"));
  EXPECT_THAT(curve({{1e-4, 0.9}, {1e-3, 0.5}, {1e-3, 0.4}}), HasSubstr("point 3"));
  EXPECT_THAT(curve({{1e-4, 0.9}, {1e-3, 0.05}, {1e-2, 0.04}}), HasSubstr("point 2")); // stress falls
  EXPECT_THAT(curve({{1e-4, 0.5}, {1e-3, 0.6}, {1e-2, 0.1}}), HasSubstr("point 2"));   // stiffens
  EXPECT_THAT(curve({{1e-4, 0.9}, {1e-3, 0.6}, {1e-2, 0.5}}), HasSubstr("no friction angle"));
}

TEST(Pdmy03Parameters, EveryValueIsListedWithItsOrigin) {
  Pdmy03Input input;
  input.relative_density = 0.57;
  input.contraction[0] = 0.02;
  const Law law = pdmy03(input);
  const std::vector<ParameterValue> list = parameters(law);
  std::set<std::string> names;
  for (const ParameterValue& value : list) {
    EXPECT_TRUE(names.insert(std::string(value.name)).second) << value.name;
    EXPECT_FALSE(value.unit.empty());
    EXPECT_FALSE(value.meaning.empty());
    EXPECT_FALSE(value.origin.empty());
    EXPECT_TRUE(std::isfinite(value.value));
  }
  const auto find = [&](const std::string& name) {
    for (const ParameterValue& value : list) {
      if (value.name == name) {
        return value;
      }
    }
    throw std::runtime_error(name);
  };
  EXPECT_EQ(find("contraction_a").value, 0.02);
  EXPECT_EQ(find("contraction_a").origin, "given");
  EXPECT_THAT(find("friction_deg").origin,
              HasSubstr("table D_R 57 %, as known of Khosravifar et al. (2018)"));
  EXPECT_NEAR(find("friction_deg").value, 30.3, 1e-9);
  EXPECT_THAT(find("dilation_c").origin, HasSubstr("does not identify"));
  EXPECT_EQ(find("pressure_exponent").origin, "default");
  EXPECT_EQ(find("surfaces").value, 20.0);
  EXPECT_EQ(find("cone").word, "triaxial_compression");
  EXPECT_EQ(find("cone").origin, "default");
  const auto plane = parameters(pdmy03({.relative_density = 0.57, .cone = Pdmy03Cone::plane_strain}));
  const auto cone = std::ranges::find(plane, "cone", &ParameterValue::name);
  EXPECT_EQ(cone->word, "plane_strain");
  EXPECT_EQ(cone->origin, "given");
  EXPECT_EQ(find("void_ratio").origin, "fixed");
}

TEST(Pdmy03Parameters, NotesWarnOfTheConeInPlaneStrain) {
  const auto text = [](const Pdmy03& law) {
    std::string all;
    for (const std::string& note : notes(law)) {
      all += note;
    }
    return all;
  };
  EXPECT_THAT(text(pdmy03({.relative_density = 0.57})), HasSubstr("stronger in plane strain"));
  EXPECT_THAT(text(pdmy03({.relative_density = 0.57, .cone = Pdmy03Cone::plane_strain})),
              ::testing::Not(HasSubstr("stronger in plane strain")));
}

} // namespace
} // namespace tremolo::materials
