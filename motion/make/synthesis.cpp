#include "motion/make/synthesis.hpp"

#include "base/random/variates.hpp"
#include "motion/fourier.hpp"
#include "motion/read/read.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

namespace tremolo::motion {

namespace {

constexpr double pi = std::numbers::pi;

double time_at(const SynthesisRecipe& recipe, std::size_t i) {
  return recipe.dt * static_cast<double>(i);
}

/// |h| at a frequency in Hz.
double gain(const SynthesisFilter& filter, double f) {
  const std::complex<double> i(0.0, 1.0);
  const double f0 = filter.frequency;
  const double f1 = filter.high_pass;
  const auto soil =
      (f0 * f0 + 2.0 * i * filter.damping * f0 * f) / (f0 * f0 - f * f + 2.0 * i * filter.damping * f0 * f);
  const auto high = f * f / (f1 * f1 - f * f + 2.0 * i * filter.high_pass_damping * f1 * f);
  const double taper =
      std::clamp((filter.last_frequency - f) / (filter.last_frequency - filter.taper_start), 0.0, 1.0);
  return std::abs(soil * high) * 0.5 * (1.0 - std::cos(pi * taper));
}

std::vector<double> filtered(const SynthesisRecipe& recipe, std::span<const double> noise) {
  auto bins = transform(noise);
  const double df = 1.0 / (static_cast<double>(noise.size()) * recipe.dt);
  for (std::size_t j = 0; j < bins.size(); ++j)
    bins[j] *= gain(recipe.filter, df * static_cast<double>(j));
  auto a = inverse_transform(bins, noise.size());
  a.resize(recipe.count);
  return a;
}

/// w(t).
std::vector<double> modulation(const SynthesisRecipe& recipe) {
  const SynthesisEnvelope& envelope = recipe.envelope;
  std::vector<double> w(recipe.count);
  for (std::size_t i = 0; i < w.size(); ++i) {
    const double t = time_at(recipe, i);
    const double x = std::max(t - envelope.start, 0.0) / envelope.time;
    const double burst =
        envelope.burst * std::exp(-std::pow((t - envelope.burst_time) / envelope.burst_width, 2));
    w[i] = std::sqrt(std::pow(x, envelope.shape - 1.0) * std::exp(-x) + burst);
  }
  return w;
}

/// Velocity and displacement at the end.
Eigen::Vector2d ends(std::span<const double> acceleration, double dt) {
  const auto velocity = integrate(acceleration, dt);
  return {velocity.back(), integrate(velocity, dt).back()};
}

/// Subtracts w (p + q t) so that velocity and displacement end at zero.
void remove_drift(std::vector<double>& a, const std::vector<double>& w, const SynthesisRecipe& recipe) {
  std::vector<double> wt(w);
  for (std::size_t i = 0; i < wt.size(); ++i)
    wt[i] *= time_at(recipe, i);
  Eigen::Matrix2d shapes;
  shapes << ends(w, recipe.dt), ends(wt, recipe.dt);
  const Eigen::Vector2d pq = shapes.partialPivLu().solve(ends(a, recipe.dt));
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] -= pq[0] * w[i] + pq[1] * wt[i];
}

/// The accelerogram of these parameters in g, with the target's Arias intensity.
std::vector<double> realised(const SynthesisRecipe& recipe, std::span<const double> noise) {
  const auto w = modulation(recipe);
  auto a = filtered(recipe, noise);
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i] *= w[i];
  remove_drift(a, w, recipe);
  double squares = 0.0;
  for (const double value : a)
    squares += value * value;
  const double scale = std::sqrt(recipe.target.arias / (0.5 * pi * standard_gravity * squares * recipe.dt));
  // Rounded so that no digit of the file depends on the last bits of a transform; + 0 makes no -0.
  constexpr double digits = 1e10;
  for (double& value : a)
    value = std::nearbyint(scale * value * digits) / digits + 0.0;
  return a;
}

constexpr Eigen::Index unknowns = 4;
using Parameters = Eigen::Vector<double, unknowns>;

/// Logarithms of what is sought: all are positive, and steps are relative.
Parameters parameters(const SynthesisRecipe& recipe) {
  return Parameters(recipe.filter.frequency, recipe.filter.high_pass, recipe.envelope.time,
                    recipe.envelope.burst)
      .array()
      .log();
}

SynthesisRecipe with_parameters(SynthesisRecipe recipe, const Parameters& logarithms) {
  const Parameters values = logarithms.array().exp();
  recipe.filter.frequency = values[0];
  recipe.filter.high_pass = values[1];
  recipe.envelope.time = values[2];
  recipe.envelope.burst = values[3];
  return recipe;
}

struct Misfit {
  std::string_view measure;
  double relative;
};

/// The first four depend on the parameters, the last follows from the scale.
std::array<Misfit, unknowns + 1> misfits(const Measures& found, const SynthesisTarget& target) {
  return {{{"mean period", found.mean_period / target.mean_period - 1.0},
           {"PGV", found.pgv / target.pgv - 1.0},
           {"duration", found.significant_duration / target.significant_duration - 1.0},
           {"PGA", found.pga / target.pga - 1.0},
           {"Arias intensity", found.arias / target.arias - 1.0}}};
}

Misfit worst(const std::array<Misfit, unknowns + 1>& all) {
  return *std::ranges::max_element(all, {}, [](const Misfit& one) { return std::abs(one.relative); });
}

/// The search, for one seed, for the parameters that meet the target.
class Search {
public:
  explicit Search(const SynthesisRecipe& recipe)
      : recipe_(recipe), noise_(white_noise(recipe.seed, fast_length(recipe.count))) {}

  /// Levenberg-Marquardt steps until the target is met; then or where they end, what was reached.
  Synthesised operator()() const {
    constexpr int most_steps = 25;
    Synthesised now = realisation(recipe_);
    double damping = 1e-3;
    for (int step = 1; step <= most_steps && !met(now); ++step) {
      const Parameters r = residual(now);
      Synthesised next = realisation(
          with_parameters(recipe_, parameters(now.recipe) + correction(parameters(now.recipe), r, damping)));
      const bool better = residual(next).norm() < r.norm();
      damping *= better ? 0.3 : 5.0;
      if (better) {
        now = std::move(next);
        now.steps = step;
      }
    }
    return now;
  }

  bool met(const Synthesised& motion) const {
    return std::abs(worst(misfits(motion.measures, recipe_.target)).relative) <= recipe_.target.tolerance;
  }

private:
  Synthesised realisation(const SynthesisRecipe& recipe) const {
    Record record{.unit = Unit::g, .dt = recipe.dt, .samples = realised(recipe, noise_)};
    const Measures found = measures(record);
    return {std::move(record), recipe, found, 0};
  }

  Parameters residual(const Synthesised& motion) const {
    const auto all = misfits(motion.measures, recipe_.target);
    Parameters r;
    for (Eigen::Index i = 0; i < unknowns; ++i)
      r[i] = all[static_cast<std::size_t>(i)].relative;
    return r;
  }

  /// (J^T J + lambda I)^-1 J^T r by central differences, no longer than a fifth.
  Parameters correction(const Parameters& x, const Parameters& r, double damping) const {
    constexpr double difference = 0.02;
    constexpr double longest = 0.2;
    using Matrix = Eigen::Matrix<double, unknowns, unknowns>;
    Matrix slope;
    for (Eigen::Index k = 0; k < unknowns; ++k) {
      const Parameters d = difference * Parameters::Unit(k);
      slope.col(k) = (residual(realisation(with_parameters(recipe_, x + d))) -
                      residual(realisation(with_parameters(recipe_, x - d)))) /
                     (2.0 * difference);
    }
    const Matrix normal = slope.transpose() * slope + damping * Matrix::Identity();
    const Parameters full = -normal.ldlt().solve(slope.transpose() * r);
    return full * std::min(1.0, longest / full.cwiseAbs().maxCoeff());
  }

  SynthesisRecipe recipe_;
  std::vector<double> noise_;
};

void refuse_unless(bool sound, const char* what) {
  if (!sound)
    throw std::invalid_argument(fmt::format("synthesis: {}", what));
}

bool positive(std::initializer_list<double> values) {
  return std::ranges::all_of(values, [](double value) { return value > 0.0 && std::isfinite(value); });
}

void require_sound(const SynthesisRecipe& recipe) {
  const auto& [pga, pgv, arias, duration, mean_period, tolerance] = recipe.target;
  refuse_unless(positive({recipe.dt}) && recipe.count >= 16 &&
                    static_cast<double>(recipe.count) <= most_samples,
                "dt must be > 0, and samples at least 16");
  refuse_unless(positive({pga, pgv, arias, duration, mean_period, tolerance}),
                "every target and the tolerance must be > 0");
  refuse_unless(recipe.seeds >= 1, "at least 1 seed");
  const SynthesisFilter& filter = recipe.filter;
  refuse_unless(positive({filter.frequency, filter.damping, filter.high_pass, filter.high_pass_damping}),
                "frequencies and damping of the filter must be > 0");
  refuse_unless(filter.taper_start >= 0.0 && filter.taper_start < filter.last_frequency &&
                    filter.last_frequency <= 0.5 / recipe.dt,
                "0 <= taper_start < last_frequency <= 1/(2 dt)");
  const SynthesisEnvelope& envelope = recipe.envelope;
  refuse_unless(positive({envelope.time, envelope.burst, envelope.burst_width}) && envelope.shape > 1.0,
                "the envelope's time, burst and burst_width must be > 0, its shape > 1");
  const double duration_s = recipe.dt * static_cast<double>(recipe.count);
  refuse_unless(envelope.start >= 0.0 && envelope.start < duration_s && std::isfinite(envelope.burst_time),
                "the envelope must start within the motion");
}

} // namespace

Synthesised synthesise(const SynthesisRecipe& recipe) {
  require_sound(recipe);
  SynthesisRecipe trial = recipe;
  Misfit nearest{"", HUGE_VAL};
  for (int seed = 0; seed < recipe.seeds; ++seed, ++trial.seed) {
    const Search search(trial);
    Synthesised motion = search();
    if (search.met(motion))
      return motion;
    const Misfit left = worst(misfits(motion.measures, recipe.target));
    if (std::abs(left.relative) < std::abs(nearest.relative))
      nearest = left;
  }
  throw std::runtime_error(fmt::format(
      "no motion of {} seeds from {} meets the target; the nearest misses the {} by {:.2g} %: start "
      "values nearer to the answer, or another seed, may",
      recipe.seeds, recipe.seed, nearest.measure, 100.0 * nearest.relative));
}

std::vector<double> white_noise(std::uint32_t seed, std::size_t count) {
  std::mt19937 generator(seed);
  const auto symmetric = [&] { // 53 bits
    const auto a = static_cast<double>(generator() >> 5U);
    const auto b = static_cast<double>(generator() >> 6U);
    return 2.0 * ((a * 67108864.0 + b) / 9007199254740992.0) - 1.0;
  };
  std::vector<double> noise;
  noise.reserve(count + 1);
  while (noise.size() < count) {
    const auto [first, second] = normal_pair(symmetric);
    noise.push_back(second);
    noise.push_back(first);
  }
  noise.resize(count);
  return noise;
}

} // namespace tremolo::motion
