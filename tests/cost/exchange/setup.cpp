#include "setup.hpp"

#include <chrono>
#include <ctime>
#include <fmt/format.h>

namespace tremolo::cost {

namespace {

constexpr double depth = 100.0; ///< of the boundary, m

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double cpu_seconds() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

} // namespace

std::string source_name(std::size_t index) {
  return fmt::format("source{}", index);
}

coupler::FieldDescription field(const Setup& setup) {
  coupler::FieldDescription field{
      .name = "total", .start_time = -2.0 * time_step, .time_step = time_step, .step_count = setup.steps + 8};
  for (std::size_t i = 0; i < setup.points; ++i)
    field.y.push_back(depth * (static_cast<double>(i) / static_cast<double>(setup.points - 1) - 1.0));
  field.steps_per_frame = steps_per_frame(field, setup.window_steps);
  return field;
}

std::vector<coupler::SourceDescription> sources(const Setup& setup) {
  std::vector<coupler::SourceDescription> list;
  for (std::size_t s = 0; s < setup.sources; ++s)
    list.push_back({source_name(s), static_cast<std::uint32_t>(s + 1), {field(setup)}});
  return list;
}

std::vector<coupler::ExchangedFace> faces(const Setup& setup) {
  std::vector<coupler::ExchangedFace> list;
  for (std::size_t s = 0; s < setup.sources; ++s)
    for (std::size_t i = 0; i < setup.points; ++i)
      list.push_back(
          {.position = {0.0, -depth * (static_cast<double>(i) + 0.5) / static_cast<double>(setup.points)},
           .dashpot = {{-1.0, 0.0}, 3e5, 1e5},
           .static_traction = {},
           .source = source_name(s),
           .field = "total"});
  return list;
}

void fill(std::uint64_t step, std::span<double> values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = static_cast<double>(step + i);
}

Meter::Meter() : wall_start_(wall_seconds()), cpu_start_(cpu_seconds()) {}

Cost Meter::cost(std::uint64_t steps) const {
  const double scale = 1e6 / static_cast<double>(steps);
  return {scale * (wall_seconds() - wall_start_), scale * (cpu_seconds() - cpu_start_)};
}

} // namespace tremolo::cost
