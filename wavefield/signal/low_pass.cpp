// The slow part is kept as samples, 40 a period of its own highest frequency, between which the polynomial of
// fifth degree through six of them errs by (2 pi/40)^6/205 = 7e-8 there.

#include "wavefield/signal/low_pass.hpp"

#include "wavefield/signal/fourier.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <vector>

namespace tremolo::wavefield {
namespace {

constexpr double end_of_band = 2.2; ///< corners
constexpr double kernel_width =
    6.0; ///< over the corner: the filter's answer to an impulse is below 1e-10 there

class Samples {
public:
  Samples(double start, double dt, std::vector<double> values)
      : start_(start), dt_(dt), values_(std::move(values)) {}

  double at(double t) const {
    const double place = (t - start_) / dt_;
    const double left = std::floor(place);
    if (left < 2.0 || left + 4.0 > static_cast<double>(values_.size()))
      return 0.0;
    const double x = place - left;
    const double* v = &values_[static_cast<std::size_t>(left) - 2];
    double sum = 0.0;
    for (int i = 0; i < 6; ++i) {
      double weight = 1.0;
      for (int k = 0; k < 6; ++k)
        weight *= k == i ? 1.0 : (x + 2.0 - k) / (i - k);
      sum += weight * v[i];
    }
    return sum;
  }

private:
  double start_, dt_;
  std::vector<double> values_;
};

} // namespace

Signal low_passed(const Signal& signal, double corner) {
  const double margin = kernel_width / corner;
  const double highest = end_of_band * corner;
  const double fine = 0.25 / signal.highest_frequency;
  const auto every = static_cast<std::size_t>(std::max(1.0, std::floor(1.0 / (40.0 * highest * fine))));
  const double start = signal.begin - margin;
  RealFourier fourier(fast_length(
      static_cast<std::size_t>(std::ceil((signal.end - signal.begin + 2.0 * margin) / fine)) + 1));
  const auto samples = fourier.samples();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = start + static_cast<double>(i) * fine;
    samples[i] = t >= signal.begin && t <= signal.end ? signal.velocity(t) : 0.0;
  }
  fourier.forward();
  const double count = static_cast<double>(samples.size());
  for (std::size_t k = 0; k < fourier.bins().size(); ++k)
    fourier.bins()[k] *= std::exp(-std::pow(static_cast<double>(k) / (count * fine * corner), 4)) / count;
  fourier.inverse();
  std::vector<double> slow;
  for (std::size_t i = 0; i < samples.size(); i += every)
    slow.push_back(samples[i]);
  const auto kept =
      std::make_shared<const Samples>(start, static_cast<double>(every) * fine, std::move(slow));
  return {[kept](double t) { return kept->at(t); }, start, signal.end + margin, highest};
}

} // namespace tremolo::wavefield
