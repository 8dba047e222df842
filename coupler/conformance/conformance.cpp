#include "coupler/conformance/conformance.hpp"

#include "coupler/conformance/conformance_session.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <fmt/format.h>
#include <utility>

namespace tremolo::coupler {

using namespace conformance;

namespace {

/// Time that a hub grants the surviving processes after a failure before it kills them, s.
constexpr double abort_grace_s = 1.0;
/// Deadline of the session in which the hub vanishes, s, and what a client adds to it.
constexpr double orphan_step_deadline_s = 0.5;
constexpr double client_grace_s = 1.0;

Verdict grade(double value, double warning, double failure) {
  return value > failure ? Verdict::failure : value > warning ? Verdict::warning : Verdict::pass;
}

void check_rates(const std::vector<ServedSeries>& all, const ConformanceLimits& limits, Report& report) {
  double worst = 0.0;
  for (const auto& series : all)
    worst = std::max(worst, rate_defect(series));
  report.set(
      rates, grade(worst, limits.rate_defect_warning, limits.rate_defect_failure),
      fmt::format("differences of the values and Simpson's sums of the rates differ by {:.2e} (warning {}, "
                  "failure {})",
                  worst, limits.rate_defect_warning, limits.rate_defect_failure));
}

void check_momentum(const std::vector<ServedSeries>& all, const Demand& demand,
                    const ConformanceLimits& limits, Report& report) {
  std::string finding;
  double worst = 0.0;
  for (const auto& series : all)
    if (const auto density = density_from_momentum(series)) {
      worst =
          std::max({worst, *density / demand.largest_density - 1.0, 1.0 - *density / demand.least_density});
      finding += fmt::format("{}'{}' obeys rho a = div sigma with rho = {:.5g} kg/m3",
                             finding.empty() ? "" : ", ", series.field.name, *density);
    }
  if (finding.empty())
    return report.set(momentum, Verdict::skipped, "needs motion at three levels of a layer");
  report.set(momentum, grade(worst, limits.density_warning, limits.density_failure),
             fmt::format("{}; the case has {:.5g} to {:.5g}", finding, demand.least_density,
                         demand.largest_density));
}

void check_quiet_start(const std::vector<ServedSeries>& all, const ConformanceLimits& limits,
                       Report& report) {
  double worst = 0.0;
  Peaks peak;
  for (const auto& series : all) {
    if (series.steps() == 0)
      continue;
    const Peaks first = peaks(series, 0, 0);
    const Peaks whole = peaks(series, 0, series.steps() - 1);
    peak = {std::max(peak.velocity, whole.velocity), std::max(peak.stress, whole.stress)};
    for (const auto& [start, most] :
         {std::pair{first.velocity, whole.velocity}, {first.stress, whole.stress}})
      worst = std::max(worst, most > 0.0 ? start / most : 0.0);
  }
  if (peak.velocity == 0.0)
    return report.set(quiet_start, Verdict::warning, "all velocities are zero");
  report.set(quiet_start, grade(worst, limits.start_warning, limits.start_failure),
             fmt::format("first step {:.1e} of the peaks {:.4g} m/s and {:.4g} Pa (warning {}, failure {})",
                         worst, peak.velocity, peak.stress, limits.start_warning, limits.start_failure));
}

/// Bit by bit, as far as both sessions received steps: how far depends on what was in flight at the end.
void check_repetition(const std::vector<ServedSeries>& first, const std::vector<ServedSeries>& second,
                      Report& report) {
  for (std::size_t f = 0; f < first.size(); ++f) {
    const auto& a = first[f];
    const auto& b = second[f];
    if (to_json(a.field) != to_json(b.field))
      return report.set(repeats, Verdict::failure,
                        fmt::format("the second run describes '{}' otherwise than the first", a.field.name));
    const std::size_t common = std::min(a.values.size(), b.values.size());
    for (std::size_t i = 0; i < common; ++i)
      if (std::bit_cast<std::uint64_t>(a.values[i]) != std::bit_cast<std::uint64_t>(b.values[i]))
        return report.set(repeats, Verdict::failure,
                          fmt::format("'{}', step {}: {:.17g} in the first run, {:.17g} in the second",
                                      a.field.name, i / a.field.values_per_step(), a.values[i], b.values[i]));
  }
  report.pass(repeats, "two runs give the same bits");
}

void check_end(SourceProbe& probe, Row row, const Message& last, double deadline, Report& report) {
  const auto start = Clock::now();
  probe.send(last);
  const bool ended = probe.ends_within(deadline);
  const std::string finding =
      ended ? fmt::format("after {:.2f} s (deadline {} s)", seconds_since(start), deadline)
            : fmt::format("still there after {} s", deadline);
  const bool well = ended && (row != leaves || probe.process().succeeded());
  report.set(row, well ? Verdict::pass : Verdict::failure, ended && !well ? probe.last_words() : finding);
}

std::vector<ServedSeries> whole_run(const ProbeOptions& options, const Demand& demand, Report& report,
                                    Row end_row, const Message& last, double deadline) {
  Session session(options, demand, report);
  session.shake_hands();
  session.exchange(demand.end_time);
  check_end(session.probe(), end_row, last, deadline, report);
  return session.series();
}

void check_orphan(ProbeOptions options, const Demand& demand, Report& report) {
  options.deadlines.step = orphan_step_deadline_s;
  Report unused;
  Session session(options, demand, unused);
  session.shake_hands();
  session.exchange(demand.start_time);
  session.probe().vanish();
  const auto start = Clock::now();
  // It may notice after its deadline and spend another one on a last message.
  const double limit = 2.0 * orphan_step_deadline_s + client_grace_s + options.deadlines.shutdown;
  if (session.probe().ends_within(limit))
    report.pass(orphaned, fmt::format("{:.1f} s after the hub's last word (deadline {} s)",
                                      seconds_since(start), limit));
  else
    report.set(orphaned, Verdict::failure,
               fmt::format("still there {} s after the hub's last word, with --step-deadline {}", limit,
                           orphan_step_deadline_s));
}

} // namespace

std::string_view name(Verdict verdict) {
  constexpr std::array<std::string_view, 4> names{"pass", "WARN", "FAIL", "-"};
  return names[static_cast<std::size_t>(verdict)];
}

std::vector<Check> conform(const ProbeOptions& options, const Demand& demand,
                           const ConformanceLimits& limits) {
  Report report;
  try {
    const auto first = whole_run(options, demand, report, leaves, {"BYE"}, options.deadlines.shutdown);
    check_rates(first, limits, report);
    check_momentum(first, demand, limits, report);
    check_quiet_start(first, limits, report);
    const auto second =
        whole_run(options, demand, report, aborts,
                  {"ABORT", {{"reason", "tremolo conform asks the program to end"}}}, abort_grace_s);
    check_repetition(first, second, report);
    check_orphan(options, demand, report);
  } catch (const Objection& objection) {
    report.set(objection.row, Verdict::failure, objection.text);
  }
  return report.checks();
}

bool conforms(const std::vector<Check>& checks) {
  return std::ranges::find(checks, Verdict::failure, &Check::verdict) == checks.end();
}

} // namespace tremolo::coupler
