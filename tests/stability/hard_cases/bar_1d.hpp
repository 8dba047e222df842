#pragma once

// A bar of particles in one dimension with box averages of any half size l, 0 for the linear shape functions
// of the first Material Point Method (Sulsky, Chen and Schreyer 1994): the wrong variant of cases that box
// averages pass.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tremolo::test_support {

class Bar1D {
public:
  /// A ring of `cells` cells and `particles` particles under uniform stress -preload (Pa), drifting by
  /// `crossings` cells at `drift` (m/s).
  static Bar1D preloaded_ring(int cells, int particles, double h, double l, double preload, double drift,
                              int crossings) {
    Bar1D bar(cells, particles, h, l, 0.0);
    bar.ring_ = true;
    std::fill(bar.stress_.begin(), bar.stress_.end(), -preload);
    std::fill(bar.v_.begin(), bar.v_.end(), drift);
    const double dt = 0.3 * h / wave_speed;
    const auto steps = static_cast<long>(crossings * h / (drift * dt));
    for (long step = 0; step < steps; ++step) {
      bar.step(dt);
      for (const double s : bar.stress_)
        bar.noise_ = std::max(bar.noise_, std::abs(s + preload));
    }
    return bar;
  }

  /// A free block, two particles a cell, whose ends stand `offset` cells beyond nodes.
  static Bar1D block(int cells, double h, double l, double offset) {
    Bar1D bar(cells, 2 * cells, h, l, offset * h);
    return bar;
  }

  double noise() const { return noise_; } ///< largest change of stress so far, Pa

  /// 2/omega_max in units of h/c, by power iteration on a = M^-1 K u.
  double critical_step() const {
    std::vector<double> u(mass_size());
    for (std::size_t i = 0; i < u.size(); ++i)
      u[i] = std::sin(3.7 * static_cast<double>(i * i) + 1.0);
    const std::vector<double> m = masses();
    double square = 0.0;
    for (int n = 0; n < 2000; ++n) {
      std::vector<double> a(u.size(), 0.0);
      for (const double x : x_) {
        double strain = 0.0;
        for (int i = first(x); i < first(x) + 4; ++i)
          strain += weights(i, x).g * u[at(i)];
        for (int i = first(x); i < first(x) + 4; ++i)
          a[at(i)] += volume_ * modulus() * strain * weights(i, x).g;
      }
      double uu = 0.0;
      double ua = 0.0;
      double largest = 0.0;
      for (std::size_t i = 0; i < u.size(); ++i) {
        uu += m[i] * u[i] * u[i];
        ua += u[i] * a[i];
        a[i] = m[i] > 0.0 ? a[i] / m[i] : 0.0;
        largest = std::max(largest, std::abs(a[i]));
      }
      square = ua / uu;
      for (std::size_t i = 0; i < u.size(); ++i)
        u[i] = a[i] / largest;
    }
    return 2.0 / std::sqrt(square) * wave_speed / h_;
  }

private:
  static constexpr double density = 1700.0;               // kg/m3
  static constexpr double wave_speed = 173.4364837735801; // m/s
  static constexpr int margin = 3;                        // cells

  struct Weight {
    double s, g;
  };

  Bar1D(int cells, int particles, double h, double l, double offset)
      : cells_(cells), h_(h), l_(l), volume_(cells * h / particles),
        v_(static_cast<std::size_t>(particles), 0.0), stress_(static_cast<std::size_t>(particles), 0.0) {
    for (int k = 0; k < particles; ++k)
      x_.push_back((k + 0.5) * volume_ + offset);
  }

  static double modulus() { return density * wave_speed * wave_speed; }
  std::size_t mass_size() const { return static_cast<std::size_t>(cells_ + 2 * margin + 1); }
  /// Storage of node i: of a ring modulo its cells.
  std::size_t at(int i) const {
    return static_cast<std::size_t>(ring_ ? (i % cells_ + cells_) % cells_ : i + margin);
  }
  int first(double x) const { return static_cast<int>(std::floor(x / h_)) - 1; }

  /// The hat function of node i and its slope, averaged over the box [x - l, x + l].
  Weight weights(int i, double x) const {
    const double u = x / h_ - i;
    if (l_ == 0.0)
      return std::abs(u) >= 1.0 ? Weight{0.0, 0.0} : Weight{1.0 - std::abs(u), (u > 0.0 ? -1.0 : 1.0) / h_};
    const auto hat = [](double w) { return 1.0 - std::abs(w); };
    const double a = std::clamp(u - l_ / h_, -1.0, 1.0);
    const double b = std::clamp(u + l_ / h_, -1.0, 1.0);
    return {0.25 * h_ / l_ * (b * (1.0 + hat(b)) - a * (1.0 + hat(a))), 0.5 / l_ * (hat(b) - hat(a))};
  }

  std::vector<double> masses() const {
    std::vector<double> m(mass_size(), 0.0);
    for (const double x : x_)
      for (int i = first(x); i < first(x) + 4; ++i)
        m[at(i)] += density * volume_ * weights(i, x).s;
    return m;
  }

  /// FLIP, stress last.
  void step(double dt) {
    const std::vector<double> m = masses();
    std::vector<double> v(m.size(), 0.0);
    std::vector<double> f(m.size(), 0.0);
    for (std::size_t k = 0; k < x_.size(); ++k)
      for (int i = first(x_[k]); i < first(x_[k]) + 4; ++i) {
        const Weight w = weights(i, x_[k]);
        v[at(i)] += density * volume_ * w.s * v_[k];
        f[at(i)] -= volume_ * w.g * stress_[k];
      }
    for (std::size_t i = 0; i < m.size(); ++i) {
      v[i] = m[i] > 0.0 ? (v[i] + dt * f[i]) / m[i] : 0.0;
      f[i] = m[i] > 0.0 ? f[i] / m[i] : 0.0;
    }
    for (std::size_t k = 0; k < x_.size(); ++k) {
      double way = 0.0;
      double strain = 0.0;
      for (int i = first(x_[k]); i < first(x_[k]) + 4; ++i) {
        const Weight w = weights(i, x_[k]);
        v_[k] += dt * w.s * f[at(i)];
        way += dt * w.s * v[at(i)];
        strain += dt * w.g * v[at(i)];
      }
      x_[k] += way;
      stress_[k] += modulus() * strain;
    }
  }

  int cells_;
  double h_, l_, volume_;
  bool ring_ = false;
  std::vector<double> x_, v_, stress_;
  double noise_ = 0.0;
};

} // namespace tremolo::test_support
