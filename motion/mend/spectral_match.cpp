// The response of an oscillator at one time is a weighted sum of the samples before, with the weights of its
// response to a single sample. They are computed once for each period, and c_ij is a product of two rows.

#include "motion/mend/spectral_match.hpp"

#include "motion/spectra.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tremolo::motion {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double steps_a_period = 5.0;
constexpr std::size_t periods_a_decade = 80;
constexpr double coupling = 0.7; ///< share of c_ij that is kept beside the diagonal, for steadiness
constexpr double relaxation = 0.8;

void validate(const TargetSpectrum& target) {
  const auto& t = target.periods;
  if (t.size() < 2 || t.size() != target.acceleration.size())
    throw std::invalid_argument("a target spectrum needs at least two periods, and an acceleration for each");
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (!(t[i] > (i == 0 ? 0.0 : t[i - 1])) || !std::isfinite(t[i]))
      throw std::invalid_argument(
          fmt::format("row {} of the target spectrum: period {:g} s, must be > {:g} s", i + 1, t[i],
                      i == 0 ? 0.0 : t[i - 1]));
    if (!(target.acceleration[i] > 0.0) || !std::isfinite(target.acceleration[i]))
      throw std::invalid_argument(
          fmt::format("row {} of the target spectrum: acceleration {:g} m/s2, must be > 0", i + 1,
                      target.acceleration[i]));
  }
  if (!(target.damping >= 0.005 && target.damping <= 0.5))
    throw std::invalid_argument(
        fmt::format("damping of the target spectrum {:g}, must be in [0.005, 0.5]", target.damping));
}

std::vector<double> matched_periods(const TargetSpectrum& target) {
  const double first = target.periods.front();
  const double last = target.periods.back();
  const auto count =
      static_cast<std::size_t>(std::ceil(static_cast<double>(periods_a_decade) * std::log10(last / first)));
  return spaced_periods(first, last, std::max<std::size_t>(count + 1, 2));
}

/// An oscillator, and what is wanted of it.
struct Oscillator {
  double period;               ///< s
  double wanted;               ///< m
  std::vector<double> impulse; ///< displacement at sample k after a single sample of 1 m/s2, m
};

std::vector<Oscillator> oscillators(const TargetSpectrum& target, std::size_t count, double dt) {
  std::vector<double> sample(count + 1, 0.0);
  sample[1] = 1.0;
  std::vector<Oscillator> all;
  for (const double period : matched_periods(target)) {
    const double frequency = 2.0 * pi / period;
    auto impulse = oscillator(sample, dt, period, target.damping);
    impulse.erase(impulse.begin());
    all.push_back({period, target.at(period) / (frequency * frequency), std::move(impulse)});
  }
  return all;
}

/// The largest displacement of an oscillator.
struct Peak {
  std::size_t sample = 0;
  double displacement = 0.0; ///< m, with its sign
};

std::vector<Peak> peaks(const std::vector<double>& acceleration, double dt,
                        const std::vector<Oscillator>& all, double damping) {
  std::vector<Peak> found;
  for (const Oscillator& one : all) {
    const auto u = oscillator(acceleration, dt, one.period, damping);
    const auto largest = std::ranges::max_element(u, {}, [](double x) { return std::abs(x); });
    found.push_back({static_cast<std::size_t>(largest - u.begin()), *largest});
  }
  return found;
}

double misfit(const std::vector<Peak>& found, const std::vector<Oscillator>& all) {
  double worst = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i)
    worst = std::max(worst, std::abs(std::abs(found[i].displacement) / all[i].wanted - 1.0));
  return worst;
}

std::vector<double> wavelet(const Oscillator& one, std::size_t peak, std::size_t count, double dt,
                            double damping) {
  const double root = std::sqrt(1.0 - damping * damping);
  const double frequency = 2.0 * pi / one.period * root;
  const double delay = std::atan(root / damping) / frequency;
  const double width = 1.178 * std::pow(one.period, 0.93);
  const double centre = static_cast<double>(peak) * dt - delay;
  std::vector<double> samples(count, 0.0);
  for (std::size_t k = 0; k < count; ++k) {
    const double t = static_cast<double>(k) * dt - centre;
    if (std::abs(t) < 6.0 * width)
      samples[k] = std::cos(frequency * t) * std::exp(-t * t / (width * width));
  }
  return samples;
}

/// Subtracts w (p + q t), so that the samples have neither velocity nor displacement at the end.
void balance(std::vector<double>& samples) {
  const auto count = static_cast<double>(samples.size() - 1);
  Eigen::Matrix2d ends = Eigen::Matrix2d::Zero(); // velocity and displacement of w and w t
  Eigen::Vector2d left = Eigen::Vector2d::Zero();
  const auto window = [&](double k) { return std::pow(std::sin(pi * k / count), 2); };
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto k = static_cast<double>(i);
    const Eigen::Vector2d lever(1.0, count - k);
    ends += lever * Eigen::RowVector2d(window(k), window(k) * k);
    left += lever * samples[i];
  }
  const Eigen::Vector2d p = ends.fullPivLu().solve(left);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto k = static_cast<double>(i);
    samples[i] -= window(k) * (p[0] + p[1] * k);
  }
}

/// The sum of wavelets that one step adds.
std::vector<double> added(const std::vector<Oscillator>& all, const std::vector<Peak>& found,
                          std::size_t count, double dt, double damping) {
  const auto n = static_cast<Eigen::Index>(all.size());
  std::vector<std::vector<double>> wavelets;
  for (std::size_t j = 0; j < all.size(); ++j)
    wavelets.push_back(wavelet(all[j], found[j].sample, count, dt, damping));
  Eigen::MatrixXd c(n, n);
  Eigen::VectorXd wanted(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto& [sample, displacement] = found[static_cast<std::size_t>(i)];
    const Oscillator& one = all[static_cast<std::size_t>(i)];
    // Relative to what is wanted: displacements grow with the square of the period.
    wanted[i] = (std::copysign(one.wanted, displacement) - displacement) / one.wanted;
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto& f = wavelets[static_cast<std::size_t>(j)];
      double sum = 0.0;
      for (std::size_t k = 0; k <= sample; ++k)
        sum += one.impulse[sample - k] * f[k];
      c(i, j) = (i == j ? 1.0 : coupling) * sum / one.wanted;
    }
  }
  const Eigen::VectorXd b = c.colPivHouseholderQr().solve(wanted);
  std::vector<double> sum(count, 0.0);
  for (Eigen::Index j = 0; j < n; ++j)
    for (std::size_t k = 0; k < count; ++k)
      sum[k] += relaxation * b[j] * wavelets[static_cast<std::size_t>(j)][k];
  balance(sum);
  return sum;
}

/// Factor that brings the spectrum to the target on the average of logarithms.
double scale(const std::vector<Peak>& found, const std::vector<Oscillator>& all) {
  double sum = 0.0;
  for (std::size_t i = 0; i < all.size(); ++i)
    sum += std::log(all[i].wanted / std::abs(found[i].displacement));
  return std::exp(sum / static_cast<double>(all.size()));
}

} // namespace

double TargetSpectrum::at(double period) const {
  const auto next = std::upper_bound(periods.begin() + 1, periods.end() - 1, period);
  const auto i = static_cast<std::size_t>(next - periods.begin());
  const double share = std::log(period / periods[i - 1]) / std::log(periods[i] / periods[i - 1]);
  return acceleration[i - 1] * std::pow(acceleration[i] / acceleration[i - 1], share);
}

double shortest_matched_period(double dt) {
  return steps_a_period * dt;
}

SpectralMatch spectrally_matched(std::span<const double> acceleration, double dt,
                                 const TargetSpectrum& target, const MatchSettings& settings) {
  validate(target);
  if (target.periods.front() < shortest_matched_period(dt) * (1.0 - 1e-9))
    throw std::invalid_argument(
        fmt::format("the target spectrum begins at {:g} s; a step of {:g} s resolves periods "
                    "from {:g} s",
                    target.periods.front(), dt, shortest_matched_period(dt)));
  const double duration = dt * static_cast<double>(acceleration.size());
  if (target.periods.back() > 0.5 * duration)
    throw std::invalid_argument(
        fmt::format("the target spectrum ends at {:g} s, more than half of the record's {:g} s",
                    target.periods.back(), duration));
  if (std::ranges::all_of(acceleration, [](double a) { return a == 0.0; }))
    throw std::invalid_argument("a record of zeros has no spectrum to match");

  const auto all = oscillators(target, acceleration.size(), dt);
  std::vector<double> now(acceleration.begin(), acceleration.end());
  auto found = peaks(now, dt, all, target.damping);
  const double factor = scale(found, all);
  for (double& a : now)
    a *= factor;
  for (Peak& peak : found)
    peak.displacement *= factor;

  const double before = misfit(found, all);
  SpectralMatch best{now, before, before, 0};
  for (int step = 1; step <= settings.steps && best.after > settings.tolerance; ++step) {
    const auto change = added(all, found, now.size(), dt, target.damping);
    for (std::size_t k = 0; k < now.size(); ++k)
      now[k] += change[k];
    found = peaks(now, dt, all, target.damping);
    if (const double worst = misfit(found, all); worst < best.after) {
      best.acceleration = now;
      best.after = worst;
      best.steps = step;
    }
  }
  return best;
}

} // namespace tremolo::motion
