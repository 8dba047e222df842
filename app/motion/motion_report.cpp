#include "app/motion/motion_report.hpp"

#include "base/text/text_file.hpp"
#include "motion/measures.hpp"
#include "motion/mend/process.hpp"
#include "motion/spectra.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace tremolo::app {
namespace {

constexpr double shortest_period = 0.01; // s
constexpr double longest_period = 10.0;  // s
constexpr std::size_t periods = 200;

motion::Record acceleration_of(const motion::Record& record) {
  return motion::with_unit(record, motion::Unit::m_s2);
}

/// "  read as                PEER; unit g as the file says"; empty where no file was read.
std::string origin_line(const motion::Origin& origin) {
  if (origin.format.empty())
    return "";
  std::string text = fmt::format("  {:<22} {}", "read as", origin.format);
  if (!origin.component.empty())
    text += fmt::format("; '{}'{}", origin.component,
                        origin.components > 1 ? fmt::format(" of {} components", origin.components) : "");
  text += fmt::format("; unit {}", origin.unit);
  text += fmt::format("; baseline: {}\n", origin.baseline.empty() ? "nothing is said" : origin.baseline);
  return text;
}

} // namespace

std::string motion_report(const motion::Record& record, const std::string& name) {
  const auto m = motion::measures(record);
  const std::size_t count = record.samples.size();
  std::string text =
      fmt::format("{}: {} in {}, {} samples every {} s ({:g} s), {}\n", name, motion::name(record.quantity()),
                  motion::name(record.unit), count, record.dt, static_cast<double>(count - 1) * record.dt,
                  record.kind ? motion::name(*record.kind) : "not said whether incident, outcrop or within");
  text += origin_line(record.origin);
  const auto add = [&text](const char* measure, double value, const char* unit,
                           const std::string& note = "") {
    text += fmt::format("  {:<22}{:>12.5g} {}{}\n", measure, value, unit, note);
  };
  add("PGA", m.pga, "m/s2", fmt::format("  ({:.5g} g)", m.pga / motion::standard_gravity));
  add("PGV", m.pgv, "m/s");
  add("PGD", m.pgd, "m");
  add("Arias intensity", m.arias, "m/s");
  add("duration D5-75", m.duration_5_75, "s");
  add("duration D5-95", m.significant_duration, "s");
  add("CAV", m.cav, "m/s");
  add("mean period", m.mean_period, "s");
  add("residual velocity", m.residual_velocity, "m/s");
  add("residual displacement", m.residual_displacement, "m");
  return text;
}

std::string motion_warning(const motion::Record& record) {
  return motion::residual_warning(motion::measures(record)).value_or("");
}

std::string unit_warning(const motion::Record& record) {
  if (!record.overruled_unit)
    return "";
  return fmt::format(
      "--unit {}, but the file says {}: the motion is taken {:.4g} times as strong as its file says",
      motion::name(record.unit), motion::name(*record.overruled_unit),
      motion::in_si(record.unit) / motion::in_si(*record.overruled_unit));
}

void write_histories(const motion::Record& record, const std::filesystem::path& file) {
  const auto a = acceleration_of(record).samples;
  const auto v = motion::with_unit(record, motion::Unit::m_s).samples;
  const auto d = motion::with_unit(record, motion::Unit::m).samples;
  std::string text = "t,a,v,d\n";
  for (std::size_t i = 0; i < a.size(); ++i)
    text +=
        fmt::format("{:.9g},{:.9g},{:.9g},{:.9g}\n", static_cast<double>(i) * record.dt, a[i], v[i], d[i]);
  write_text_file(file, text);
}

void write_response_spectrum(const motion::Record& record, double damping,
                             const std::filesystem::path& file) {
  const auto a = acceleration_of(record).samples;
  std::string text = response_heading;
  for (const auto& one : motion::response_spectrum(
           a, record.dt, motion::tabulated_periods(shortest_period, longest_period, periods), damping))
    text += fmt::format("{:.9g},{:.9g},{:.9g},{:.9g}\n", one.period, one.displacement, one.velocity,
                        one.acceleration);
  write_text_file(file, text);
}

void write_target_spectrum(const motion::TargetSpectrum& target, const std::filesystem::path& file) {
  std::string text = "period,acceleration\n";
  for (std::size_t i = 0; i < target.periods.size(); ++i)
    text += fmt::format("{:.9g},{:.9g}\n", target.periods[i], target.acceleration[i]);
  write_text_file(file, text);
}

void write_fourier_spectrum(const motion::Record& record, const std::filesystem::path& file) {
  std::string text = fourier_heading;
  for (const auto& [frequency, amplitude] :
       motion::fourier_spectrum(acceleration_of(record).samples, record.dt))
    text += fmt::format("{:.9g},{:.9g}\n", frequency, amplitude);
  write_text_file(file, text);
}

void write_tables(const motion::Record& record, double damping, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  write_histories(record, folder / "histories.csv");
  write_response_spectrum(record, damping, folder / "response.csv");
  write_fourier_spectrum(record, folder / "fourier.csv");
}

} // namespace tremolo::app
