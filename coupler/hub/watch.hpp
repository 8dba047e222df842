#pragma once

// Who has waited too long for whom. Only what gets on prolongs a wait: a frame, a later step, a beat that
// reports more work done. A solver that loops and beats all the same is stuck.

#include "coupler/client/participant_options.hpp"
#include "coupler/client/timeline.hpp"
#include "coupler/hub/admission/roster.hpp"
#include "coupler/hub/notes.hpp"
#include "coupler/hub/progress.hpp"
#include "coupler/mapping/face_exchange.hpp"
#include "coupler/mapping/pace.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::coupler {

class Watch {
public:
  /// @param deadlines,roster,notes outlive it
  Watch(const Deadlines& deadlines, Roster& roster, Notes& notes);

  /// All are there: whatever they owe, they owe from now on.
  void begin();

  void heard(const Participant& participant) { of(participant).last_heard = Clock::now(); }
  /// A message that gets the run on.
  void advanced(const Participant& participant);
  void source_beats(const Participant& source, const nlohmann::json& body);
  void domain_beats(const Participant& domain, const nlohmann::json& body);

  /// The source owes a frame from now on.
  void asked(const Participant& source) { of(source).pace.asked(); }
  /// Records what the domain waits for, if anything.
  void domain_waits_for(const std::optional<FaceExchange::Missing>& awaited);
  /// A source's steps below next_step have come.
  void arrived(const Participant& source, const std::string& field, std::uint64_t next_step);

  [[nodiscard]] bool domain_waits() const { return wait_.has_value(); }
  [[nodiscard]] const Progress& progress() const { return progress_; }
  /// Waiting times of the domain so far, by participant.
  [[nodiscard]] const TimelineReport& waits() { return timeline_.report(); }

  /// Whoever has not said HELLO in time.
  [[nodiscard]] std::optional<Failure> absent() const;
  /// Whoever has not got on in time.
  /// @param owed what the domain owes
  [[nodiscard]] std::optional<Failure> overdue(const std::string& owed);
  /// When a participant on another machine ends, no child process of this one does: the connection shows it.
  [[nodiscard]] std::optional<Failure> lost(const Participant& participant, bool connected);

private:
  /// State of a participant as the watch knows it.
  struct Signs {
    Clock::time_point last_heard = Clock::now();
    Pace pace{};
    double work_done = 0.0; ///< what its last beat said
    std::optional<Clock::time_point> line_lost{};
  };
  /// The domain's wait for a source.
  struct Wait {
    FaceExchange::Missing awaited;
    Clock::time_point since;
    bool noted = false; ///< that it is long
  };

  Signs& of(const Participant& participant) { return signs_[participant.index()]; }
  [[nodiscard]] std::optional<Failure> overdue_source();
  [[nodiscard]] std::string wait_text(const Participant& source, double waited, double patience);

  const Deadlines& deadlines_;
  Roster& roster_;
  Notes& notes_;
  Clock::time_point start_;
  std::vector<Signs> signs_;
  std::optional<Wait> wait_;
  Progress progress_;
  Timeline timeline_;
};

} // namespace tremolo::coupler
