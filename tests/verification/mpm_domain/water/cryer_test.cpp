// A long cylinder of saturated soil, drained at its surface, after a load on it that water has taken (Cryer
// 1963, Q. J. Mech. Appl. Math. 16, 401-412, of the sphere; de Leeuw 1965, Proc. 6th Int. Conf. Soil Mech.,
// 1, 287-291, of plane strain). Its surface consolidates first and tightens round the centre, where pressure
// rises before it falls: strains and flow are coupled in a way that diffusion of the pressure alone misses.
//
// From the balance of forces M e = p - p_0 + C(t), e the volume strain, and from a surface without total
// stress C = G <p - p_0>/(M - G), < > the mean over the disc. With storage n/K_f, a = 1 + M n/K_f,
// b = G/(M - G) and kappa = k/(rho_f g),
//
//     a dp/dt + b d<p>/dt = kappa M lap p,        p(R) = 0,        p(0, r) = p_0,
//
// whose eigenfunctions J_0(s r/R) - J_0(s) decay with kappa M s^2/(a R^2) and follow from
//
//     (a + b) J_0(s) = 2 b J_1(s)/s,
//     p/p_0 = sum (a + b) J_0(s)/(b J_1(s)^2 - a J_0(s)^2) (J_0(s r/R) - J_0(s)) exp(-kappa M s^2 t/(a R^2)).
//
// Soil starts with p_0 and as much effective tension, so that no total stress loads it: nothing rings.

#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/step/stepper.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

constexpr double modulus = 1e7; // M, Pa
constexpr double porosity = 0.4;
constexpr materials::PoreFluid fluid{.bulk_modulus = 4e8};
constexpr double radius = 1.0; // R, m
constexpr double cell = 0.1;   // m

class Cryer {
public:
  /// @param shear_ratio  G/M
  explicit Cryer(double shear_ratio)
      : a_(1.0 + modulus * porosity / fluid.bulk_modulus), b_(shear_ratio / (1.0 - shear_ratio)) {
    constexpr double step = 1e-3;
    for (double s = step; roots_.size() < 60; s += step)
      if ((mismatch(s) > 0.0) != (mismatch(s + step) > 0.0))
        roots_.push_back(refined(s, s + step));
  }

  /// p/p_0 at r/R after the time factor kappa M t/(a R^2)
  double pressure(double position, double time) const {
    double sum = 0.0;
    for (const double s : roots_) {
      const double j0 = std::cyl_bessel_j(0, s), j1 = std::cyl_bessel_j(1, s);
      sum += (a_ + b_) * j0 / (b_ * j1 * j1 - a_ * j0 * j0) * (std::cyl_bessel_j(0, s * position) - j0) *
             std::exp(-s * s * time);
    }
    return sum;
  }

private:
  double mismatch(double s) const {
    return (a_ + b_) * s * std::cyl_bessel_j(0, s) - 2.0 * b_ * std::cyl_bessel_j(1, s);
  }
  double refined(double low, double high) const {
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      ((mismatch(middle) > 0.0) == (mismatch(low) > 0.0) ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }

  double a_, b_;
  std::vector<double> roots_;
};

TEST(Cryer, ClosedFormStartsFromItsPressureAndRisesAtTheCentre) {
  const Cryer exact(0.5);
  EXPECT_NEAR(exact.pressure(0.0, 2e-3), 1.0, 0.2);
  EXPECT_GT(exact.pressure(0.0, 0.05), 1.05);
  EXPECT_NEAR(exact.pressure(1.0, 0.05), 0.0, 1e-12);
}

/// Root mean square of the error of p/p_0 in the disc without its rim, at each of some time factors.
std::vector<double> errors_of(const std::vector<double>& factors) {
  constexpr double poisson = 0.0;         // G/M = 1/2
  constexpr double start = 1e3;           // p_0, Pa
  constexpr double permeability = 2.5e-4; // slow against waves across the disc
  constexpr int sides = 48;
  Spec spec;
  spec.box = {-1.5 * radius, -1.5 * radius, 1.5 * radius, 1.5 * radius};
  spec.cell_size = cell;
  spec.gravity = 1e-6; // with the permeability scaled alike: drag as it is, and no weight
  spec.scheme.fraction = 0.9;
  spec.water = {2.0 * radius, fluid};
  Soil soil{.name = "soil", .law = materials::LinearElastic{{1990.0, modulus, poisson}}};
  soil.pores = {
      .porosity = porosity, .grain_density = 2650.0, .permeability = permeability * spec.gravity / 9.81};
  spec.soils = {soil};
  Region disc{0, {}};
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / sides;
    disc.polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  spec.regions = {disc};
  Domain domain(spec);
  domain.boundary.remove_faces();
  double area = 0.0;
  for (Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      area += set.volume[k];
      set.pore_pressure[k] += start;
      for (std::vector<double>* s : {&set.sxx, &set.syy, &set.szz})
        (*s)[k] += start;
    }
  // The disc has steps of particles round it.
  const double edge2 = area / std::numbers::pi;
  Stepper stepper(domain, 0.0, {});
  const Cryer exact(0.5);
  const double diffusivity =
      permeability / (1000.0 * 9.81) * modulus / (1.0 + modulus * porosity / fluid.bulk_modulus);
  std::vector<double> errors;
  for (const double factor : factors) {
    while (stepper.time() < factor * edge2 / diffusivity)
      stepper.step();
    double squares = 0.0;
    int count = 0;
    for (const Particles& set : domain.sets)
      for (std::size_t k = 0; k < set.size(); ++k) {
        // A pressure is the mean of its cell.
        const double x = (std::floor(set.x_initial[k] / cell) + 0.5) * cell;
        const double y = (std::floor(set.y_initial[k] / cell) + 0.5) * cell;
        const double r = std::hypot(x, y) / std::sqrt(edge2);
        const double p = excess_pressure(set, k) / start;
        if (r > 0.85)
          continue;
        const double error = p - exact.pressure(r, stepper.time() * diffusivity / edge2);
        squares += error * error;
        ++count;
      }
    errors.push_back(std::sqrt(squares / count));
  }
  return errors;
}

TEST(Cryer, PressureRisesAtTheCentreBeforeItFalls) {
  const std::vector<double> errors = errors_of({0.02, 0.05, 0.1, 0.2, 0.3});
  EXPECT_LT(errors[0], 0.02); // the pressure has changed in the outermost cells alone
  for (std::size_t i = 1; i < errors.size(); ++i)
    EXPECT_LT(errors[i], 0.01) << i;
}

} // namespace
} // namespace tremolo::mpm_domain
