// Error of the FE column against exact responses, and the CPU time it takes, over elements and steps. Linear:
// a Kelvin-Voigt layer on rock, exact by Fourier sums. Nonlinear: the simple wave in a hyperbolic half-space,
//     c(g) = V0/(1 + g/gr),   v = V0 gr ln(1 + g/gr),   v constant along t = t' + y/c,
// solved for t' by bisection. Prints CSV: problem, scheme, element m, step s, relative error, CPU s.

#include "freefield/fe/fe_column.hpp"
#include "tests/support/layered_column.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <vector>

namespace {

using namespace tremolo::freefield;
using tremolo::materials::Elasticity;
using tremolo::materials::MasingShear;

const Elasticity soil = Elasticity::from_wave_speeds(1800.0, 200.0, 320.0);

double ricker(double t) {
  const double a = std::pow(std::numbers::pi * 3.0 * (t - 0.5), 2);
  return (1.0 - 2.0 * a) * std::exp(-a);
}

/// Root-mean-square error of the velocity at a level over times that every step divides, relative to the
/// peak.
void march(const char* problem, const char* scheme, const Profile& profile, const FeColumnSettings& settings,
           const InputVelocity& motion, double level, const std::vector<double>& times,
           const std::vector<double>& exact) {
  const std::clock_t begin = std::clock();
  FeColumn column(profile, settings, motion);
  double squares = 0.0;
  double peak = 0.0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    while (column.time() < times[i] - 0.5 * settings.time_step) {
      column.step();
    }
    ColumnSample s;
    column.sample({&level, 1}, {&s, 1});
    squares += std::pow(s.vx - exact[i], 2);
    peak = std::max(peak, std::abs(exact[i]));
  }
  const double cpu = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  std::printf("%s,%s,%g,%g,%.4e,%.4e\n", problem, scheme, settings.max_element_size, settings.time_step,
              std::sqrt(squares / static_cast<double>(times.size())) / peak, cpu);
  std::fflush(stdout);
}

struct Scheme {
  const char* name;
  Integrator integrator;
  Tangent tangent = Tangent::consistent;
  double hht_alpha = 0.0;
};

constexpr Scheme schemes[] = {{"central differences", Integrator::central_difference},
                              {"Newmark", Integrator::newmark},
                              {"HHT -0.1", Integrator::newmark, Tangent::consistent, -0.1},
                              {"Newmark (initial tangent)", Integrator::newmark, Tangent::initial}};

/// Elements halved four times; implicit with steps of 1, 2 and 4 crossing times of an element, explicit with
/// as much of the limit as divides the interval between samples.
void study(const char* problem, const Profile& profile, BaseKind base, const Damping& damping,
           const InputVelocity& motion, double level, double interval, const std::vector<double>& times,
           const std::vector<double>& exact, bool nonlinear) {
  for (const Scheme& scheme : schemes) {
    if (scheme.tangent == Tangent::initial && !nonlinear) {
      continue;
    }
    for (const double size : {2.0, 1.0, 0.5, 0.25, 0.125}) {
      for (const double courant : {1.0, 2.0, 4.0}) {
        const bool implicit = scheme.integrator == Integrator::newmark;
        if (!implicit && courant > 1.0) {
          continue;
        }
        const double longest = implicit ? courant * size / soil.s_wave_speed()
                                        : 0.95 * central_difference_limit(profile, size, damping);
        const double step = interval / std::ceil(interval / longest * (1.0 - 1e-12));
        march(problem, scheme.name, profile,
              {.max_element_size = size,
               .time_step = step,
               .integrator = scheme.integrator,
               .damping = damping,
               .base = base,
               .hht_alpha = scheme.hht_alpha,
               .tangent = scheme.tangent},
              motion, level, times, exact);
      }
    }
  }
}

std::vector<double> sample_times(double interval, double end) {
  std::vector<double> times;
  for (int i = 1; i * interval <= end + 1e-9; ++i) {
    times.push_back(i * interval);
  }
  return times;
}

void linear() {
  const Elasticity rock = Elasticity::from_wave_speeds(2200.0, 800.0, 1600.0);
  const Damping damping = RayleighDamping{1.0, 6.0};
  const Profile profile{.layers = {{30.0, soil, 0.02}}, .half_space = rock};
  const auto c = coefficients(damping, 0.02);
  const double interval = 0.04;
  const auto times = sample_times(interval, 4.0);
  const tremolo::testing::LayeredColumn column({{30.0, soil.density, soil.shear_modulus(), c.alpha, c.beta}},
                                               rock.density * rock.s_wave_speed(), 3.0, 0.5);
  std::vector<double> exact;
  for (const auto& motion : column.at(0.0, times)) {
    exact.push_back(motion.velocity);
  }
  study(
      "linear", profile, BaseKind::compliant, damping,
      [](double t) {
        return Velocity{ricker(t), 0.0};
      },
      0.0, interval, times, exact, false);
}

/// Velocity of the face.
double rise(double t) {
  return t <= 0.0 ? 0.0 : t >= 0.2 ? 0.5 : 0.25 * (1.0 - std::cos(std::numbers::pi * t / 0.2));
}

void simple_wave() {
  constexpr double height = 60.0;
  constexpr double reference = 1e-3;
  const double v0 = soil.s_wave_speed();
  const Profile profile{
      .surface_level = height,
      .layers = {layer_of(height, MasingShear{.elastic = soil, .reference_strain = reference})},
      .half_space = soil};
  const double y = 8.0;
  const double interval = 0.04;
  const auto times = sample_times(interval, 0.48);
  std::vector<double> exact;
  for (const double t : times) {
    const auto arrival = [&](double start) {
      return start + y / v0 * std::exp(rise(start) / (v0 * reference));
    };
    double low = t - 10.0;
    double high = t;
    for (int i = 0; i < 100; ++i) {
      const double middle = 0.5 * (low + high);
      (arrival(middle) < t ? low : high) = middle;
    }
    exact.push_back(rise(low));
  }
  study(
      "simple wave", profile, BaseKind::rigid, KelvinVoigtDamping{1.0},
      [](double t) {
        return Velocity{rise(t), 0.0};
      },
      y, interval, times, exact, true);
}

} // namespace

int main() {
  std::printf("problem,scheme,element_m,step_s,relative_error,cpu_s\n");
  linear();
  simple_wave();
  return 0;
}
