#pragma once

// One session of conformance.hpp: the rows of its report, and the exchange with the program that fills them.

#include "coupler/conformance/conformance.hpp"
#include "coupler/mapping/face_exchange.hpp"
#include "coupler/mapping/served_series.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tremolo::coupler::conformance {

/// The rows of the report.
enum Row : std::size_t {
  hello,
  handshake,
  fields,
  points,
  times,
  steps,
  finite,
  rates,
  momentum,
  quiet_start,
  leaves,
  repeats,
  aborts,
  orphaned,
  row_count
};

/// A row that fails and, with it, the session.
struct Objection {
  Row row;
  std::string text;
};

class Report {
public:
  Report();
  void set(Row row, Verdict verdict, std::string finding);
  void pass(Row row, std::string finding) { set(row, Verdict::pass, std::move(finding)); }
  [[nodiscard]] const std::vector<Check>& checks() const { return checks_; }

private:
  std::vector<Check> checks_;
};

/// The session from the program's start to the domain's end time.
class Session {
public:
  /// @param options,demand must outlive the session
  Session(const ProbeOptions& options, const Demand& demand, Report& report)
      : options_(options), demand_(demand), report_(report), probe_(options) {}

  /// @throws Objection
  void shake_hands();

  /// Asks for all that the domain needs until end_time, as the domain does.
  /// @throws Objection
  void exchange(double end_time);

  [[nodiscard]] const std::vector<ServedSeries>& series() const { return series_; }
  [[nodiscard]] SourceProbe& probe() { return probe_; }

private:
  void check_handshake(const nlohmann::json& said);
  void check_fields(const nlohmann::json& said);
  void check_points();
  void check_times();
  void grant_credits();
  void wait_for(const FaceExchange::Missing& missing);
  void take_frame(std::span<const std::byte> bytes);

  const ProbeOptions& options_;
  const Demand& demand_;
  Report& report_;
  SourceProbe probe_;
  SourceDescription source_;
  std::optional<FaceExchange> exchange_;
  std::vector<ServedSeries> series_;
  Clock::time_point last_heard_ = Clock::now();
};

} // namespace tremolo::coupler::conformance
