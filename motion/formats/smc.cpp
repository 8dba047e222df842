// SMC (USGS): 11 lines of text, 48 integers in 6 lines of fields of 10, 50 reals in 10 lines of fields of 15,
// comments, and samples in fields of 10 that touch. -32768 and 1.7e38 stand for unknown.
// Integer 14 is the azimuth, 16 the number of comments, 17 that of samples; real 2 is the sampling rate in
// Hz, 30 and 32 are the largest and the smallest sample. Converse & Brady, USGS Open-File Report 92-296A.

#include "motion/formats/formats.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tremolo::motion {

namespace {

constexpr double unknown_integer = -32768.0;
constexpr double unknown_real = 1e37; // from here on

ScaledUnit unit_of(const Lines& lines) {
  switch (trimmed(lines.text()).front()) {
  case '1':
  case '2':
    return {Unit::cm_s2};
  case '3':
    return {Unit::cm_s};
  case '4':
    return {Unit::cm};
  default:
    lines.refuse("no kind of SMC file, which are 1 uncorrected, 2 corrected acceleration, 3 velocity, 4 "
                 "displacement");
  }
}

void skip(Lines& lines, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i)
    if (!lines.next())
      lines.refuse("the file ends in its header");
}

std::string component(const std::vector<double>& integers) {
  const double vertical = integers[12];
  const double horizontal = integers[13];
  if (horizontal != unknown_integer && vertical != 0.0 && vertical != 180.0)
    return fmt::format("{:g} degrees", horizontal);
  return vertical == unknown_integer ? "" : "vertical";
}

std::size_t count_of(const Lines& lines, double value, double most, const char* what) {
  if (!(value >= 0.0 && value <= most) || value != std::floor(value))
    lines.refuse(fmt::format("{} {}, must be a whole number up to {:g}", value, what, most));
  return static_cast<std::size_t>(value);
}

} // namespace

std::vector<Trace> read_smc(Lines& lines, const ReadAs&) {
  skip(lines, 1);
  const ScaledUnit unit = unit_of(lines);
  Trace trace{.stated = stated(unit)};
  trace.baseline = says(lines.text(), "UNCORRECTED") ? "not corrected" : "corrected by the network";
  skip(lines, 10);
  const auto integers = fixed_fields(lines, 10, 48);
  const auto reals = fixed_fields(lines, 15, 50);
  const auto comments = count_of(lines, integers[15], 10000.0, "comments");
  const auto count = count_of(lines, integers[16], most_samples, "samples");
  trace.component = component(integers);
  if (!(reals[1] > 0.0 && reals[1] < unknown_real))
    lines.refuse(fmt::format("a sampling rate of {:g} Hz, must be > 0", reals[1]));
  trace.dt = 1.0 / reals[1];
  const double largest = std::max(std::abs(reals[29]), std::abs(reals[31]));
  if (largest < unknown_real)
    trace.peak = {{largest, 0.0}, unit};
  skip(lines, comments);
  trace.line = lines.number();
  trace.samples = fixed_fields(lines, 10, count);
  while (lines.next())
    if (!trimmed(lines.text()).empty())
      lines.refuse(fmt::format("more samples than the {} that the header announces", count));
  return {std::move(trace)};
}

} // namespace tremolo::motion
