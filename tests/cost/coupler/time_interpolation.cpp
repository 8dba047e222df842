// What the exchange's interpolation in time costs and what it gives: cubic Hermite from values and rates, as
// the coupler has it (mapping.hpp), against linear interpolation of the values alone, which is here only.
// Prints CSV:
//
//     signal    harmonic: sin(w t), error = largest / amplitude, to be held against (w dt)^2/8 and (w
//     dt)^4/384;
//               ricker:   f(t) of peak frequency w/2 pi, error = 2-norm over the 2-norm of f
//     method    linear or hermite
//     omega_dt  w times the source's step
//     error
//     ns        CPU time of one face and step, four points in depth

#include "coupler/mapping/mapping.hpp"

#include <cmath>
#include <ctime>
#include <fmt/format.h>
#include <functional>
#include <numbers>
#include <string_view>
#include <vector>

namespace {

using namespace tremolo;
using namespace tremolo::coupler;

constexpr double omega = 2.0 * std::numbers::pi * 3.0; // rad/s
constexpr double end_time = 2.0;                       // s
constexpr std::size_t levels = 81;
constexpr std::size_t faces = 160;

struct Signal {
  std::string_view name;
  std::function<double(double)> value;
  std::function<double(double)> rate;
};

double a(double t) {
  return std::pow(0.5 * omega * (t - 1.0), 2);
}

const Signal harmonic{"harmonic", [](double t) { return std::sin(omega * t); },
                      [](double t) { return omega * std::cos(omega * t); }};
const Signal ricker{
    "ricker", [](double t) { return (1.0 - 2.0 * a(t)) * std::exp(-a(t)); },
    [](double t) { return 0.5 * omega * omega * (t - 1.0) * (2.0 * a(t) - 3.0) * std::exp(-a(t)); }};

FieldDescription field_of(double dt) {
  FieldDescription field{.name = "total",
                         .start_time = 0.0,
                         .time_step = dt,
                         .step_count = static_cast<std::uint64_t>(std::ceil(end_time / dt)) + 2};
  for (std::size_t i = 0; i < levels; ++i)
    field.y.push_back(-40.0 + 0.5 * static_cast<double>(i));
  return field;
}

/// All steps of a signal that is the same at all levels.
std::vector<double> values_of(const FieldDescription& field, const Signal& signal) {
  std::vector<double> values;
  values.reserve(field.step_count * field.values_per_step());
  for (std::uint64_t n = 0; n < field.step_count; ++n)
    for (std::size_t i = 0; i < levels; ++i) {
      values.insert(values.end(), 5, signal.value(field.time(n)));
      values.insert(values.end(), 5, signal.rate(field.time(n)));
    }
  return values;
}

/// The counterpart of FreeFieldHistory::evaluate without rates.
eq6::FreeField linear(const FieldDescription& field, const std::vector<double>& values, const FaceMap& face,
                      double time) {
  const double position = (time - field.start_time) / field.time_step;
  const auto i = static_cast<std::uint64_t>(position);
  const double s = position - static_cast<double>(i);
  const double* before = values.data() + i * field.values_per_step() + face.first_point * values_per_point;
  const double* after = before + field.values_per_step();
  std::array<double, 5> sum{};
  for (std::size_t k = 0; k < face.points; ++k, before += values_per_point, after += values_per_point)
    for (std::size_t c = 0; c < sum.size(); ++c)
      sum[c] += face.weights[k] * ((1.0 - s) * before[c] + s * after[c]);
  return {{sum[0], sum[1]}, {sum[2], sum[3], sum[4]}};
}

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

using Evaluate = std::function<eq6::FreeField(const FaceMap&, double)>;

double error_of(const Signal& signal, const FaceMap& face, const Evaluate& evaluate) {
  const bool largest = signal.name == harmonic.name;
  double most = 0.0;
  double difference = 0.0;
  double norm = 0.0;
  constexpr int samples = 9973; // no multiple of any step
  for (int i = 0; i < samples; ++i) {
    const double t = end_time * i / samples;
    const double exact = signal.value(t);
    const double error = evaluate(face, t).velocity.x - exact;
    most = std::max(most, std::abs(error));
    difference += error * error;
    norm += exact * exact;
  }
  return largest ? most : std::sqrt(difference / norm);
}

double ns_of(const std::vector<FaceMap>& maps, const auto& evaluate) {
  double sum = 0.0;
  std::size_t evaluations = 0;
  const double start = cpu_seconds();
  while (cpu_seconds() - start < 0.2)
    for (int step = 0; step < 1000; ++step)
      for (const auto& map : maps) {
        const eq6::FreeField f = evaluate(map, 0.00197 * step);
        sum += f.velocity.x + f.velocity.y + f.stress.xx + f.stress.yy + f.stress.xy;
        ++evaluations;
      }
  const double ns = 1e9 * (cpu_seconds() - start) / static_cast<double>(evaluations);
  return std::isfinite(sum) ? ns : 0.0; // the sum keeps the compiler from leaving out the work
}

} // namespace

int main() {
  fmt::print("signal,method,omega_dt,error,ns\n");
  for (const Signal& signal : {harmonic, ricker})
    for (const double omega_dt : {1.6, 0.8, 0.4, 0.2, 0.1, 0.05}) {
      const FieldDescription field = field_of(omega_dt / omega);
      const auto values = values_of(field, signal);
      FreeFieldHistory history(field, 0.0, 0.0, field.step_count);
      history.append(std::as_bytes(std::span(values)));
      std::vector<FaceMap> maps;
      for (std::size_t i = 0; i < faces; ++i)
        maps.push_back(map_face(field, {0.0, -39.9 + 0.249 * static_cast<double>(i)}));
      const auto by_hermite = [&](const FaceMap& face, double t) { return history.evaluate(face, t); };
      const auto by_line = [&](const FaceMap& face, double t) { return linear(field, values, face, t); };
      fmt::print("{},linear,{},{:.4e},{:.1f}\n", signal.name, omega_dt, error_of(signal, maps[80], by_line),
                 ns_of(maps, by_line));
      fmt::print("{},hermite,{},{:.4e},{:.1f}\n", signal.name, omega_dt,
                 error_of(signal, maps[80], by_hermite), ns_of(maps, by_hermite));
    }
}
