// Responses of the laws as CSV, `picture,series,x,y` with strains in per cent and stresses in kPa:
// draw_responses.py makes the pictures of docs/materials from it.

#include "materials/law/driver.hpp"

#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <numbers>
#include <string>

using namespace tremolo::materials;

namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr double kPa = 1e3;

void print(const char* picture, const std::string& series, double x, double y) {
  std::printf("%s,%s,%.7g,%.7g\n", picture, series.c_str(), x, y);
}

PointStep shear(double change) {
  return {.xy = Control::strain(change)};
}

/// tau against gamma along straight parts between `turns`.
void print_shear(const char* picture, const std::string& series, PointTest point,
                 std::initializer_list<double> turns, int steps) {
  print(picture, series, 100.0 * point.strain().xy, point.stress().xy / kPa);
  for (const double turn : turns) {
    const double change = (turn - point.strain().xy) / steps;
    for (int n = 0; n < steps; ++n) {
      point.apply(shear(change));
      print(picture, series, 100.0 * point.strain().xy, point.stress().xy / kPa);
    }
  }
}

/// Plane-strain compression along y under lateral stress; s_1 against eps_1.
void print_compression(const char* picture, const std::string& series, const Law& law, double lateral,
                       double strain, int steps) {
  PointTest point(law, {-lateral, -lateral, -lateral, 0.0});
  print(picture, series, 0.0, lateral / kPa);
  for (int n = 0; n < steps; ++n) {
    point.apply({.xx = Control::stress(-lateral), .yy = Control::strain(-strain / steps)});
    print(picture, series, -100.0 * point.strain().yy, -point.stress().yy / kPa);
  }
}

/// Simple shear under constant vertical stress without lateral strain, from K0 = 0.5; tau against gamma.
void print_drained_shear(const char* picture, const std::string& series, const Law& law, double vertical) {
  PointTest point(law, {-0.5 * vertical, -vertical, -0.5 * vertical, 0.0});
  for (int n = 0; n < 400; ++n) {
    point.apply({.yy = Control::stress(-vertical), .xy = Control::strain(5e-4)});
    print(picture, series, 100.0 * point.strain().xy, point.stress().xy / kPa);
  }
}

void print_linear_elastic() {
  const LinearElastic soil{{1700.0, 40e6, 0.28}};
  PointTest straight(soil, {});
  PointTest turning(soil, {});
  constexpr int steps = 400;
  for (int n = 0; n < steps; ++n) {
    PointStep step = shear(3.0 / steps);
    straight.apply(step);
    step.rotation = -1.5 / steps; // of simple shear: half the shear strain, clockwise
    turning.apply(step);
    print("elastic_shear", "without rotation", 100.0 * straight.strain().xy, straight.stress().xy / kPa);
    print("elastic_shear", "simple shear (Jaumann rate)", 100.0 * turning.strain().xy,
          turning.stress().xy / kPa);
  }
  PointTest oedometer(soil, {});
  for (int n = 0; n < 20; ++n) {
    oedometer.apply({.yy = Control::strain((n < 12 ? -1.0 : 1.0) * 1e-4)});
    print("elastic_oedometer", "vertical", -100.0 * oedometer.strain().yy, -oedometer.stress().yy / kPa);
    print("elastic_oedometer", "horizontal", -100.0 * oedometer.strain().yy, -oedometer.stress().xx / kPa);
  }
}

MohrCoulomb slope_soil() {
  MohrCoulomb soil;
  soil.elastic = {1700.0, 40e6, 0.28};
  soil.cohesion_peak = 4.0 * kPa;
  soil.friction_peak = 45.0 * degree;
  soil.friction_residual = 28.0 * degree;
  soil.softening = 15.0;
  return soil;
}

MohrCoulomb perfect(double friction_deg, double dilation_deg, double cohesion) {
  MohrCoulomb soil;
  soil.elastic = {1700.0, 40e6, 0.28};
  soil.cohesion_peak = soil.cohesion_residual = cohesion;
  soil.friction_peak = soil.friction_residual = friction_deg * degree;
  soil.dilation_peak = soil.dilation_residual = dilation_deg * degree;
  return soil;
}

void print_mohr_coulomb() {
  const double lateral = 50.0 * kPa;
  const MohrCoulomb soil = slope_soil();
  for (double l = 0.0; l <= 0.15; l += 0.0025) { // the exact solution, l the plastic multiplier
    const double decay = std::exp(-soil.softening * 2.0 / std::sqrt(3.0) * l);
    const double sine =
        std::sin(soil.friction_residual + (soil.friction_peak - soil.friction_residual) * decay);
    const double n = (1.0 + sine) / (1.0 - sine);
    const double s1 = n * lateral + 2.0 * soil.cohesion_peak * decay * std::sqrt(n);
    const double nu = soil.elastic.poisson;
    print("mc_compression", "exact", 100.0 * ((1.0 - nu * nu) / soil.elastic.young * (s1 - lateral) + l),
          s1 / kPa);
  }
  print_compression("mc_compression", "steps of 0.02 %", soil, lateral, 0.15, 750);
  print_compression("mc_compression", "steps of 1 %", soil, lateral, 0.15, 15);
  print_drained_shear("mc_shear", "softening 45 to 28 degrees", soil, 100.0 * kPa);
  print_drained_shear("mc_shear", "45 degrees and 4 kPa", without_softening(soil), 100.0 * kPa);
  print_drained_shear("mc_shear", "30 degrees; psi = 0", perfect(30.0, 0.0, 0.0), 100.0 * kPa);
  print_drained_shear("mc_shear", "30 degrees; psi = 10", perfect(30.0, 10.0, 0.0), 100.0 * kPa);
}

void print_drucker_prager() {
  const auto soil = [](ConeMatch match, double friction_deg) {
    return DruckerPrager{{1700.0, 40e6, 0.28}, 0.0, friction_deg * degree, 0.0, match};
  };
  struct Named {
    ConeMatch match;
    const char* name;
  };
  constexpr Named cones[] = {{ConeMatch::plane_strain, "plane strain"},
                             {ConeMatch::triaxial_compression, "triaxial compression"},
                             {ConeMatch::triaxial_extension, "triaxial extension"}};
  for (const Named& one : cones) {
    print_compression("dp_compression", one.name, soil(one.match, 30.0), 100.0 * kPa, 0.1, 200);
    for (double friction = 5.0; friction <= 45.0; friction += 1.0) {
      const double slope = cone(soil(one.match, friction)).slope;
      // mobilised in plane strain with psi = 0: sin(phi) = eta
      print("dp_mobilised", one.name, friction, slope < 1.0 ? std::asin(slope) / degree : 90.0);
    }
  }
  print_compression("dp_compression", "Mohr-Coulomb", perfect(30.0, 0.0, 0.0), 100.0 * kPa, 0.1, 200);
}

void print_clay() {
  const double s_u = 50.0 * kPa;
  const MultiYieldClay clay = multi_yield_clay({1700.0, 2.98 * 25e6, 0.49}, s_u); // G = 25 MPa
  const PointStress level = {-100.0 * kPa, -100.0 * kPa, -100.0 * kPa, 0.0};
  print_shear("clay_loops", "cycles", PointTest(clay, level), {2e-3, -2e-3, 5e-3, -5e-3, 2e-2, -2e-2, 2e-2},
              100);
  for (const double share : {0.0, 0.4, 0.8}) {
    PointStress start = level;
    start.xy = share * s_u;
    print_shear("clay_strength", "static shear " + std::to_string(share).substr(0, 3) + " s_u",
                PointTest(clay, start), {0.01, 0.005, 0.12}, 200);
  }
}

void print_hysteretic() {
  const Elasticity elastic = {1900.0, 2.6 * 50e6, 0.3}; // G = 50 MPa
  struct Named {
    double exponent;
    const char* name;
  };
  constexpr Named backbones[] = {{1.0, "hyperbola"}, {0.8, "MKZ; s = 0.8"}};
  for (const Named& one : backbones) {
    const MasingShear law = {elastic, 5e-4, 1.0, one.exponent};
    print_shear("hysteretic_loops", one.name, PointTest(law, {}), {2e-3, -2e-3, 1e-3, 0.0, 2e-3}, 100);
    for (double strain = 1e-6; strain < 0.05; strain *= 1.1) {
      print("hysteretic_modulus", one.name, 100.0 * strain, law.backbone().secant(strain) / 50e6);
      print("hysteretic_damping", one.name, 100.0 * strain, 100.0 * masing_damping(law.backbone(), strain));
    }
  }
}

} // namespace

int main() {
  std::puts("picture,series,x,y");
  print_linear_elastic();
  print_mohr_coulomb();
  print_drucker_prager();
  print_clay();
  print_hysteretic();
}
