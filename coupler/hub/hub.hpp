#pragma once

// The hub: the one place where all participants meet. A ROUTER socket and a table of participants; every
// message advances the table, every tick checks its deadlines. It never blocks and never starts or stops a
// process (launcher.hpp does), so it can be tested on its own.
//
//     participant               hub
//       HELLO  ------------------>   checked against what the run expects; REFUSE otherwise
//             <------------------  WELCOME to all, once all are there
//       READY (domain) ---------->   faces checked against what sources serve
//             <------------------  CREDIT to sources
//       frames ------------------>   to the domain (window) or into Eq. (6) (lockstep)
//       CHECKPOINT (domain) ----->   a set of files is complete, the run can be resumed from it
//       BYE (domain) ------------>
//             <------------------  BYE to sources
//       BYE (sources) ----------->   finished

#include "coupler/client/participant_options.hpp"
#include "coupler/client/timeline.hpp"
#include "coupler/hub/boundary_exchange.hpp"
#include "coupler/hub/checkpoint_set.hpp"
#include "coupler/hub/client_gate.hpp"
#include "coupler/hub/exchange_observer.hpp"
#include "coupler/launch/invitation.hpp"
#include "coupler/mapping/pace.hpp"
#include "coupler/mapping/timing.hpp"
#include "coupler/wire/field.hpp"
#include "coupler/wire/frame.hpp"
#include "coupler/wire/messages.hpp"
#include "coupler/wire/mode.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>
#include <zmq.hpp>

namespace tremolo::coupler {

enum class Role { source, domain };

std::string_view name(Role role);

struct ExpectedParticipant {
  std::string name;
  Role role = Role::source;
  bool elsewhere = false; ///< it comes from another machine, by JOIN
};

/// Where checkpoints of a run lie.
struct CheckpointOptions {
  std::filesystem::path folder{};              ///< RUN/checkpoints; empty: none are made
  std::size_t keep = 0;                        ///< the newest ones
  std::map<std::string, std::string> inputs{}; ///< see RunIdentity
};

struct HubOptions {
  std::uint64_t session = 0;
  Mode mode = Mode::window;
  std::uint32_t window_steps = default_window_steps;
  std::string case_text;                         ///< of the file that all must have read
  std::vector<ExpectedParticipant> participants; ///< one domain and its sources
  Deadlines deadlines;
  std::filesystem::path keys{};                 ///< folder of CURVE keys; empty: a local endpoint only
  std::function<void(const std::string&)> note; ///< told what was refused without ending the run
  ExchangeObserver* observer = nullptr;         ///< none, or one that outlives the hub
  std::string outer_endpoint{};  ///< for those from elsewhere, who alone use the keys; or empty
  std::vector<DataFile> files{}; ///< what they must have too
  CheckpointOptions checkpoints{};
  std::optional<CheckpointSet> resume{}; ///< where the run goes on from; none: from its beginning
};

/// Why the run cannot go on.
struct Failure {
  std::string participant; ///< the one it is about; empty if none
  std::string text;
};

/// Where the domain is.
struct Progress {
  std::string stage = "start";
  std::uint64_t step = 0;
  double time = 0.0;     ///< simulated, s
  double end_time = 0.0; ///< s
  friend bool operator==(const Progress&, const Progress&) = default;
};

/// What a participant says of itself at the end.
struct ParticipantReport {
  std::vector<PassTime> passes;
  double waiting = 0.0;          ///< for the exchange, s
  double particle_updates = 0.0; ///< the domain's; 0 otherwise
  TimelineReport timeline;       ///< empty of a participant that keeps none
};

class Hub {
public:
  /// @param endpoint "ipc:///..." or "tcp://127.0.0.1:*"
  /// @throws Error if it cannot be bound
  Hub(zmq::context_t& context, const std::string& endpoint, HubOptions options);

  /// The address to give to participants: with the port that was found.
  [[nodiscard]] const std::string& endpoint() const { return endpoint_; }

  /// The same for participants from elsewhere.
  [[nodiscard]] const std::string& outer_endpoint() const { return outer_endpoint_; }

  /// To poll on.
  [[nodiscard]] zmq::socket_ref socket() { return socket_; }

  /// Takes all messages that wait.
  void take_messages();

  /// Beats, and looks whether somebody has waited too long. Call it several times a second.
  void tick();

  /// Tells every participant that the run is over and why.
  void abort(const std::string& reason);

  /// The first failure, if any. The caller ends the run.
  [[nodiscard]] const std::optional<Failure>& failure() const { return failure_; }

  [[nodiscard]] bool finished() const;
  /// Whether a participant has said BYE: its process may end.
  [[nodiscard]] bool has_left(const std::string& participant) const;
  [[nodiscard]] const Progress& progress() const { return progress_; }
  [[nodiscard]] const std::map<std::string, ParticipantReport>& reports() const { return reports_; }

private:
  /// What has come of a source's field and how far it may go.
  struct Outlet {
    std::uint64_t next_step = 0;
    std::uint64_t credit = 0;
    std::vector<double> last; ///< values of the step before next_step
    struct {
      std::uint64_t steps = 0;
      std::vector<double> last;
    } before; ///< the same at the checkpoint that the run was resumed from
  };
  struct Participant {
    ExpectedParticipant expected;
    std::uint32_t number = 0;
    std::string routing_id; ///< empty before HELLO
    std::string usher{};    ///< routing id of the `tremolo join` that was invited for it
    std::optional<Clock::time_point> line_lost{};
    std::string build;
    Clock::time_point last_heard;
    Pace pace;
    double work_done = 0.0; ///< what its last beat said
    bool left = false;
    std::vector<FieldDescription> fields;
    std::vector<Outlet> outlets;
    std::vector<std::uint64_t> needed; ///< steps of each field until the end, where somebody looks on
  };
  /// The domain's wait for a source.
  struct Wait {
    BoundaryExchange::Missing awaited;
    Clock::time_point since;
    bool noted = false; ///< that it is long
  };
  /// A step of the domain in mode lockstep that still lacks source steps.
  struct PendingStep {
    std::uint64_t step = 0;
    double time = 0.0;
    std::vector<eq6::Vector> v_domain;
  };

  void take(const std::string& routing_id, zmq::message_t& raw);
  void take_hello(const std::string& routing_id, const Message& message);
  void take_join(const std::string& routing_id, const nlohmann::json& join, zmq::message_t& raw);
  bool has_foreign_key(const std::string& routing_id, const nlohmann::json& claim, zmq::message_t& raw);
  bool is_word_of_usher(const std::string& routing_id, const Message& message);
  void watch_line(Participant& participant, bool connected);
  void listen_to_others();
  std::optional<std::string> objection(const Participant& participant, const nlohmann::json& hello) const;
  void welcome_all();
  void take_message(Participant& participant, const Message& message);
  void take_ready(Participant& domain, const nlohmann::json& body);
  void take_checkpoint(const nlohmann::json& body);
  void save_source(const Participant& source, const CheckpointSet& set) const;
  void load_source(Participant& source) const;
  static void remember_last_step(Outlet& outlet, const FieldDescription& field, const Frame& frame);
  void take_credit(const nlohmann::json& body);
  void take_beat(Participant& participant, const nlohmann::json& body);
  void take_progress(Participant& domain, const nlohmann::json& body);
  void take_bye(Participant& participant, const nlohmann::json& body);
  void take_source_frame(Participant& source, zmq::message_t& raw);
  void take_velocities(Participant& domain, std::span<const std::byte> bytes);
  void answer_pending_step();
  void grant_new_credits();
  void begin_observation(const BoundaryExchange& exchange, double start_time, double end_time);
  void observe(std::span<const std::byte> bytes);
  void request_needed_steps();
  /// Sends BYE to the sources, once an observer has seen all that the domain needed of them.
  void dismiss_sources();
  void grant(Participant& source, std::uint32_t field, std::uint64_t steps);
  [[nodiscard]] bool owes_a_frame(const Participant& source) const;
  void note_wait(const std::optional<BoundaryExchange::Missing>& awaited);

  void check_connect_deadline();
  void check_domain_deadline();
  void check_source_deadline();

  void refuse(const std::string& routing_id, const std::string& reason);
  void fail(const std::string& participant, const std::string& text);
  void send(const Participant& participant, const Message& message);
  /// False where the connection is gone.
  bool send_to(const std::string& routing_id, const Message& message);
  bool send_bytes(const std::string& routing_id, std::span<const std::byte> bytes);
  bool send_raw(const std::string& routing_id, zmq::message_t& raw);

  [[nodiscard]] Participant* find_name(const std::string& name);
  [[nodiscard]] Participant* find_routing_id(const std::string& routing_id);
  [[nodiscard]] Participant& domain();
  [[nodiscard]] std::vector<SourceDescription> sources() const;

  HubOptions options_;
  std::optional<ClientGate> gate_;
  zmq::socket_t socket_;
  std::string endpoint_;
  std::string outer_endpoint_;
  std::vector<Participant> participants_;
  Clock::time_point start_;
  Clock::time_point last_beat_;
  bool welcomed_ = false;
  bool ready_ = false;
  std::size_t face_count_ = 0;
  std::uint64_t next_domain_step_ = 0;
  std::optional<BoundaryExchange> exchange_; ///< mode lockstep
  std::optional<PendingStep> pending_;       ///< mode lockstep
  bool dismissed_ = false;                   ///< the sources have been sent BYE
  std::optional<Wait> wait_;
  Timeline timeline_; ///< mode lockstep: for whom the hub lets the domain wait
  std::optional<Failure> failure_;
  Progress progress_;
  std::map<std::string, ParticipantReport> reports_;
};

} // namespace tremolo::coupler
