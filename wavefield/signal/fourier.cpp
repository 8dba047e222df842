#include "wavefield/signal/fourier.hpp"

#include <fftw3.h>

#include <new>

namespace tremolo::wavefield {
namespace {

template <class T>
struct FftwArray {
  explicit FftwArray(std::size_t count) : data(static_cast<T*>(fftw_malloc(count * sizeof(T)))) {
    if (!data)
      throw std::bad_alloc();
  }
  struct Free {
    void operator()(T* pointer) const { fftw_free(pointer); }
  };
  std::unique_ptr<T, Free> data;
};

struct DestroyPlan {
  void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
};
using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, DestroyPlan>;

} // namespace

struct RealFourier::Plans {
  explicit Plans(std::size_t n) : length(n), samples(n), bins(n / 2 + 1) {
    // fftw_complex is laid out as std::complex<double> (C++ standard, [complex.numbers]; FFTW manual,
    // sec. 4.1.1).
    auto* spectrum = reinterpret_cast<fftw_complex*>(bins.data.get());
    const int size = static_cast<int>(n);
    to_bins.reset(fftw_plan_dft_r2c_1d(size, samples.data.get(), spectrum, FFTW_ESTIMATE));
    to_samples.reset(fftw_plan_dft_c2r_1d(size, spectrum, samples.data.get(), FFTW_ESTIMATE));
  }
  std::size_t length;
  FftwArray<double> samples;
  FftwArray<std::complex<double>> bins;
  Plan to_bins, to_samples;
};

RealFourier::RealFourier(std::size_t length) : plans_(std::make_unique<Plans>(length)) {}
RealFourier::~RealFourier() = default;

std::span<double> RealFourier::samples() {
  return {plans_->samples.data.get(), plans_->length};
}
std::span<std::complex<double>> RealFourier::bins() {
  return {plans_->bins.data.get(), plans_->length / 2 + 1};
}
void RealFourier::forward() {
  fftw_execute(plans_->to_bins.get());
}
void RealFourier::inverse() {
  fftw_execute(plans_->to_samples.get());
}

std::size_t fast_length(std::size_t length) {
  for (std::size_t candidate = length + length % 2;; candidate += 2) {
    std::size_t rest = candidate;
    for (std::size_t prime : {2U, 3U, 5U})
      while (rest % prime == 0)
        rest /= prime;
    if (rest == 1)
      return candidate;
  }
}

} // namespace tremolo::wavefield
