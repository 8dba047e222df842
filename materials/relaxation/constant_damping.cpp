// With x = f/f_1 in the band [1, B], B = f_2/f_1, the ratio Im G*/Re G* of N mechanisms is x R(x^2), R of
// degree (N - 1, N). The R whose x R is nearest to a constant, with 2 N + 1 equal extremes, is Zolotarev's
// (Akhiezer 1990, Elements of the Theory of Elliptic Functions): with kappa^2 = 1 - 1/B^2, K = K(kappa),
//
//     c_l = (sn/cn)^2(l K/2N),   R(X) = D prod_{l<N} (X + c_2l)/prod_{l<=N} (X + c_{2l-1}),
//
// extremes at x = 1/dn(l K/2N), of which the first two alternate; D puts their mean at 1. Its partial
// fractions, R = sum_k A_k/(X + c_{2k-1}), are mechanisms of weak damping,
//
//     theta_k = 1/(2 pi f_1 sqrt c_{2k-1}),   r_k = A_k/sqrt c_{2k-1}:   sum_k r_k w theta_k/(1 + (w
//     theta_k)^2) = 1.
//
// For any ratio xi the complex modulus with exactly Im/Re = 2 xi x R(x^2) is G_U prod (s + z_j)/(s +
// lambda_j), lambda_j and -z_j being the roots of
//
//     F(s) = 1 + 2 xi sum_k r_k s theta_k/(1 - (s theta_k)^2) = 0:
//
// one lambda above each 1/theta_k and one z below each, before the next. Hence tau_j = 1/lambda_j and
//
//     y_j = M_j/G_U = -prod_i (z_i - lambda_j)/[lambda_j prod_{i != j} (lambda_i - lambda_j)].

#include "materials/relaxation/constant_damping.hpp"

#include "base/require.hpp"

#include <gsl/gsl_sf_elljac.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>

namespace tremolo::materials {
namespace {

/// Jacobi's functions of the band at the points l K/2N.
struct EllipticPoint {
  double c = 0.0;       ///< (sn/cn)^2
  double extreme = 0.0; ///< 1/dn
};

EllipticPoint elliptic_point(double width, int l, int mechanisms) {
  const double parameter = 1.0 - 1.0 / (width * width); // kappa^2
  const double quarter = std::comp_ellint_1(std::sqrt(parameter));
  double sn = 0.0, cn = 0.0, dn = 0.0;
  gsl_sf_elljac_e(l * quarter / (2 * mechanisms), parameter, &sn, &cn, &dn);
  return {(sn / cn) * (sn / cn), 1.0 / dn};
}

/// Mechanisms of weak damping.
struct UnitTable {
  std::vector<double> pole; ///< 1/theta_k, rad/s, rising
  std::vector<double> r;
  double error = 0.0; ///< E: x R alternates between 1 - E and 1 + E
};

UnitTable unit_table(const DampingBand& band) {
  const int n = band.mechanisms;
  const double width = band.highest_hz / band.lowest_hz;
  std::vector<double> poles, zeros;
  for (int l = 1; l < 2 * n; ++l)
    (l % 2 == 1 ? poles : zeros).push_back(elliptic_point(width, l, n).c);
  UnitTable table;
  std::vector<double> residues;
  for (const double pole : poles) {
    double residue = 1.0;
    for (const double zero : zeros)
      residue *= zero - pole;
    for (const double other : poles)
      if (other != pole)
        residue /= other - pole;
    residues.push_back(residue);
    table.pole.push_back(2.0 * std::numbers::pi * band.lowest_hz * std::sqrt(pole));
  }
  const auto value = [&](double x) {
    double sum = 0.0;
    for (std::size_t k = 0; k < poles.size(); ++k)
      sum += residues[k] * x / (x * x + poles[k]);
    return sum;
  };
  const double first = value(1.0), second = value(elliptic_point(width, 1, n).extreme);
  table.error = std::abs(second - first) / (second + first);
  for (std::size_t k = 0; k < poles.size(); ++k)
    table.r.push_back(2.0 / (first + second) * residues[k] / std::sqrt(poles[k]));
  return table;
}

/// F on the real axis.
double characteristic(const UnitTable& table, double ratio, double s) {
  double sum = 0.0;
  for (std::size_t k = 0; k < table.pole.size(); ++k) {
    const double x = s / table.pole[k];
    sum += table.r[k] * x / ((1.0 - x) * (1.0 + x));
  }
  return 1.0 + 2.0 * ratio * sum;
}

/// The root of a function that is of one sign near `negative` and of the other near `positive`, to the last
/// digit.
template <class Function>
double bisected(const Function& function, double negative, double positive) {
  for (;;) {
    const double middle = 0.5 * (negative + positive);
    if (middle == negative || middle == positive)
      return middle;
    (function(middle) < 0.0 ? negative : positive) = middle;
  }
}

} // namespace

void validate(const ConstantDamping& damping) {
  require_positive("reference frequency of constant damping", damping.reference_hz, "Hz");
  const DampingBand& band = damping.band;
  require_positive("lower end of the band of constant damping", band.lowest_hz, "Hz");
  require(band.highest_hz > band.lowest_hz && std::isfinite(band.highest_hz),
          "upper end of the band of constant damping", band.highest_hz,
          "above the lower, " + shortest(band.lowest_hz) + " Hz");
  require(band.mechanisms >= 1 && band.mechanisms <= 12, "number of mechanisms of constant damping",
          band.mechanisms, "in [1, 12]");
}

double worst_error_of_ratio(const DampingBand& band) {
  return unit_table(band).error;
}

Relaxation relaxation(const ConstantDamping& damping, double ratio) {
  validate(damping);
  require(ratio >= 0.0 && ratio < 1.0, "ratio of constant damping", ratio, "in [0, 1)");
  if (ratio == 0.0)
    return {};
  const UnitTable table = unit_table(damping.band);
  const std::size_t n = table.pole.size();
  const auto above = [&](double s) { return characteristic(table, ratio, s); };
  const auto below = [&](double z) { return characteristic(table, -ratio, z); };
  std::vector<double> lambda, z;
  for (std::size_t k = 0; k < n; ++k) {
    const double pole = table.pole[k];
    double next = 2.0 * pole;
    if (k + 1 < n)
      next = table.pole[k + 1];
    else
      while (above(next) < 0.0)
        next *= 2.0;
    lambda.push_back(bisected(above, pole, next));
    z.push_back(bisected(below, pole, k > 0 ? table.pole[k - 1] : 0.0));
  }
  Relaxation result;
  std::complex<double> at_reference = 1.0; // G*/G_U
  double rest = 1.0;                       // G_R/G_U
  for (std::size_t j = 0; j < n; ++j) {
    double y = -1.0 / lambda[j];
    for (std::size_t i = 0; i < n; ++i) {
      y *= z[i] - lambda[j];
      if (i != j)
        y /= lambda[i] - lambda[j];
    }
    result.time.push_back(1.0 / lambda[j]);
    result.weight.push_back(y);
    rest -= y;
    at_reference -= y / (1.0 + std::complex(0.0, 2.0 * std::numbers::pi * damping.reference_hz) / lambda[j]);
  }
  result.relaxed = rest / std::abs(at_reference);
  for (double& weight : result.weight)
    weight /= rest;
  return result;
}

} // namespace tremolo::materials
