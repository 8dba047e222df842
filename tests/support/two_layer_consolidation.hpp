#pragma once

// Consolidation of two layers on an impervious base from an excess pressure of 1 in both, drained at the
// surface: p and k dp/dy are continuous between them, and p is a sum of eigenfunctions whose decay s^2
// follows from
//
//     k1 b1 cos(b1 h1) cos(b2 h2) = k2 b2 sin(b1 h1) sin(b2 h2),      b_i = s/sqrt(c_i)
//
// (Carslaw and Jaeger 1959, Conduction of Heat in Solids, for temperature).

#include <cmath>
#include <vector>

namespace tremolo::test_support {

/// Layer 1 lies above.
class TwoLayers {
public:
  /// @param h1  thickness, m; c1: c_v, m2/s; k1: permeability, m/s
  TwoLayers(double h1, double c1, double k1, double h2, double c2, double k2)
      : h1_(h1), c1_(c1), k1_(k1), h2_(h2), c2_(c2), k2_(k2) {
    double previous = mismatch(1e-9);
    for (double s = 1e-4; roots_.size() < 60; s += 1e-4) {
      const double now = mismatch(s);
      if ((now > 0.0) != (previous > 0.0))
        roots_.push_back(refined(s - 1e-4, s));
      previous = now;
    }
  }

  /// p at depth d (m) below the drained surface after time t (s).
  double pressure(double d, double t) const {
    double sum = 0.0;
    for (const double s : roots_)
      sum += coefficient(s) * shape(s, d) * std::exp(-s * s * t);
    return sum;
  }

private:
  double b1(double s) const { return s / std::sqrt(c1_); }
  double b2(double s) const { return s / std::sqrt(c2_); }
  /// Zero where flux and pressure are continuous.
  double mismatch(double s) const {
    return k1_ * b1(s) * std::cos(b1(s) * h1_) * std::cos(b2(s) * h2_) -
           k2_ * b2(s) * std::sin(b1(s) * h1_) * std::sin(b2(s) * h2_);
  }
  double refined(double low, double high) const {
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      ((mismatch(middle) > 0.0) == (mismatch(low) > 0.0) ? low : high) = middle;
    }
    return 0.5 * (low + high);
  }
  double shape(double s, double d) const {
    return d <= h1_ ? std::sin(b1(s) * d) / std::sin(b1(s) * h1_)
                    : std::cos(b2(s) * (h1_ + h2_ - d)) / std::cos(b2(s) * h2_);
  }
  /// Orthogonal with the weight k/c = m_v rho_f g of each layer.
  double coefficient(double s) const {
    constexpr int n = 2000;
    double top = 0.0, bottom = 0.0;
    for (int i = 0; i < n; ++i) {
      const double d1 = h1_ * (i + 0.5) / n;
      const double d2 = h1_ + h2_ * (i + 0.5) / n;
      const double w1 = k1_ / c1_ * h1_ / n, w2 = k2_ / c2_ * h2_ / n;
      top += w1 * shape(s, d1) + w2 * shape(s, d2);
      bottom += w1 * shape(s, d1) * shape(s, d1) + w2 * shape(s, d2) * shape(s, d2);
    }
    return top / bottom;
  }

  double h1_, c1_, k1_, h2_, c2_, k2_;
  std::vector<double> roots_;
};

} // namespace tremolo::test_support
