#include "coupler/launch/launcher.hpp"

#include "base/text/text_file.hpp"
#include "coupler/launch/child_process.hpp"
#include "coupler/launch/termination.hpp"
#include "coupler/wire/handshake/messages.hpp"
#include "coupler/wire/sockets.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <memory>
#include <optional>
#include <random>

namespace tremolo::coupler {

namespace {

constexpr std::chrono::milliseconds tick{50};
/// Time for the surviving processes to close their files after a failure before they are killed, s.
constexpr double abort_grace_s = 1.0;
/// Longer time after an interrupt by the user, which is not urgent; a second Ctrl-C ends the run at once, s.
constexpr double interrupt_grace_s = 10.0;
constexpr double last_words_s = 0.1;
/// A rank of the domain that fails writes its reason before the eight lines that MPI_Abort has.
constexpr std::size_t shown_lines = 16;

std::uint64_t random_number() {
  std::random_device device;
  return (static_cast<std::uint64_t>(device()) << 32) | device();
}

HubOptions hub_options(const LaunchOptions& launch) {
  HubOptions hub{.session = random_number(),
                 .mode = launch.mode,
                 .window_steps = launch.window_steps,
                 .case_text = read_text_file(launch.case_file),
                 .participants = {},
                 .deadlines = launch.deadlines,
                 .keys = launch.keys,
                 .note = launch.note,
                 .observer = launch.observer,
                 .outer_endpoint = launch.outer_endpoint,
                 .run_number = session_text(random_number()),
                 .files = launch.files,
                 .checkpoints = launch.checkpoints,
                 .resume = launch.resume};
  for (const auto& process : launch.processes)
    hub.participants.push_back({process.name, process.role, process.elsewhere.has_value()});
  return hub;
}

class Run {
public:
  explicit Run(const LaunchOptions& options)
      : options_(options), endpoint_(options.transport), hub_options_(hub_options(options)),
        context_(new_context(options.processes.size())), hub_(context_, endpoint_.address(), hub_options_) {
    const auto log_folder = options_.out / "log";
    std::filesystem::create_directories(log_folder);
    for (const auto& process : options_.processes)
      if (is_awaited(process))
        options_.note(fmt::format("waiting {} s for '{}'; on its machine: {}", options_.deadlines.connect,
                                  process.name, fmt::join(command(process).words, " ")));
      else
        children_.push_back(std::make_unique<ChildProcess>(process.name, command(process),
                                                           log_folder / (process.name + ".log")));
  }

  std::vector<ProcessSummary> to_its_end() {
    while (!all_ended() || !all_heard()) {
      wait_for_news();
      if (const auto signal = signals_.termination())
        stop_interrupted(*signal);
      watch_children();
      hub_.tick();
      if (hub_.failure())
        stop_failed(*hub_.failure());
      end_stragglers();
      options_.on_progress(hub_.progress());
    }
    for (const auto& child : children_)
      if (!child->succeeded() && !child->killed())
        stop_failed({child->name(), ""});
    return summaries();
  }

private:
  /// Whether the user starts it: there is no child then to watch, only what it says to the hub.
  static bool is_awaited(const ProcessSpec& process) {
    return process.elsewhere && process.elsewhere->started_by.empty();
  }

  Command command(const ProcessSpec& process) const {
    if (process.elsewhere)
      return {process.elsewhere->command(hub_.outer_endpoint(), hub_options_.run_number)};
    std::vector<std::string> words{process.program.string()};
    words.insert(words.end(), process.arguments.begin(), process.arguments.end());
    const ParticipantOptions options{
        .case_file = options_.case_file,
        .name = process.name,
        .endpoint = hub_.endpoint(),
        .session = hub_options_.session,
        .threads = process.threads,
        .out = options_.out,
        .deadlines = options_.deadlines,
        .keys = options_.outer_endpoint.empty() ? options_.keys : std::filesystem::path{},
        .resume = options_.resume && process.role == Role::domain ? options_.resume->folder
                                                                  : std::filesystem::path()};
    const auto common = command_line(options);
    words.insert(words.end(), common.begin(), common.end());
    auto variables = environment(options);
    variables.insert(variables.end(), process.environment.begin(), process.environment.end());
    return {std::move(words), std::move(variables)};
  }

  void wait_for_news() {
    std::array<zmq::pollitem_t, 2> items{
        {{hub_.socket().handle(), 0, ZMQ_POLLIN, 0}, {nullptr, signals_.descriptor(), ZMQ_POLLIN, 0}}};
    zmq::poll(items.data(), items.size(), tick);
    hub_.take_messages();
  }

  bool all_ended() {
    return std::all_of(children_.begin(), children_.end(), [](auto& child) { return child->ended(); }) &&
           (given_up_ || std::all_of(options_.processes.begin(), options_.processes.end(),
                                     [&](const auto& p) { return !is_awaited(p) || hub_.has_left(p.name); }));
  }

  /// Whether all that have ended, and well, have been heard to their end: a BYE may still be on its way.
  bool all_heard() {
    return std::all_of(children_.begin(), children_.end(), [&](auto& child) {
      return child->killed() || !child->succeeded() || hub_.has_left(child->name()) ||
             (given_up_ && hub_.has_dismissed_sources());
    });
  }

  /// A process may end only after its BYE, or after its dismissal, and then well, unless we have ended it as
  /// a straggler.
  void watch_children() {
    for (auto& child : children_) {
      const bool may_end = hub_.has_left(child->name()) || hub_.has_dismissed_sources();
      if (!child->ended() || child->killed() || (may_end && child->succeeded()))
        continue;
      // Its last words, BYE or the reason, may still be on their way through the sockets.
      const double patience = child->succeeded() ? options_.deadlines.shutdown : last_words_s;
      if (child->seconds_since_end() > patience)
        stop_failed({child->name(), ""});
    }
  }

  /// When the domain is done the results are written: whoever stays longer than the shutdown deadline is
  /// ended, and a BYE that has not come by then is not waited for.
  void end_stragglers() {
    if (!hub_.has_left(domain_process().name()))
      return;
    if (!domain_left_)
      domain_left_ = Clock::now();
    if (seconds_since(*domain_left_) < options_.deadlines.shutdown)
      return;
    for (auto& child : children_)
      if (!child->ended()) {
        options_.note(fmt::format("killed '{}', which was still there {} s after the domain had finished",
                                  child->name(), options_.deadlines.shutdown));
        child->kill();
      } else if (child->succeeded() && !hub_.has_left(child->name()) && hub_.has_dismissed_sources()) {
        options_.note(fmt::format("no BYE of '{}', which ended well, came within {} s after the domain had "
                                  "finished: its times are not known",
                                  child->name(), options_.deadlines.shutdown));
      }
    for (const auto& process : options_.processes)
      if (is_awaited(process) && !hub_.has_left(process.name))
        options_.note(fmt::format("'{}' on another machine was silent {} s after the domain had finished",
                                  process.name, options_.deadlines.shutdown));
    given_up_ = true;
  }

  [[noreturn]] void stop_failed(const Failure& failure) {
    const auto found = std::find_if(children_.begin(), children_.end(),
                                    [&](const auto& child) { return child->name() == failure.participant; });
    if (found == children_.end()) {
      stop_all(failure.text);
      throw RunFailed(failure.text, 1, circumstances(failure));
    }
    const auto& culprit = *found;
    const bool died = failure.text.empty();
    std::string text =
        died ? fmt::format("'{}' {} before the run was over", culprit->name(), culprit->ending())
             : failure.text;
    stop_all(text);
    if (!died)
      text += fmt::format(" ('{}' {})", culprit->name(), culprit->ending());
    auto lines = culprit->last_lines(shown_lines);
    // The log holds what the participant has reported to the hub, too.
    std::erase_if(lines, [&](const auto& line) { return !died && line.ends_with(failure.text); });
    if (!died && lines.empty())
      throw RunFailed(text, 1, circumstances(failure));
    text += lines.empty() ? fmt::format("; '{}' wrote nothing", culprit->name())
                          : fmt::format("; the last lines of '{}':", culprit->name());
    for (const auto& line : lines)
      text += "\n    " + line;
    throw RunFailed(text, 1, circumstances(failure));
  }

  /// After stop_all().
  FailureCircumstances circumstances(const Failure& failure) {
    return {failure.refuses_checkpoint, domain_process().crashed()};
  }

  [[noreturn]] void stop_interrupted(int signal) {
    const std::string text =
        fmt::format("interrupted by {}", signal == SIGINT ? "Ctrl-C (SIGINT)" : "SIGTERM");
    options_.note(text + ": waiting for files to be closed; Ctrl-C again to kill");
    hub_.abort(text);
    await([&] { return domain_process().ended(); }, interrupt_grace_s);
    stop_all(text);
    throw RunFailed(fmt::format("{}; what was computed until then is in {}", text, options_.out.string()),
                    128 + signal);
  }

  /// Informs all, gives them a moment to close their files, and kills who is still there.
  void stop_all(const std::string& reason) {
    hub_.abort(reason);
    given_up_ = true;
    await([&] { return all_ended(); }, abort_grace_s);
    for (auto& child : children_)
      child->kill();
  }

  /// Until it is done, the grace is over, or a signal calls for haste.
  template <typename Done>
  void await(const Done& done, double grace_s) {
    const auto start = Clock::now();
    while (!done() && seconds_since(start) < grace_s && !signals_.termination())
      wait_for_news();
  }

  ChildProcess& domain_process() {
    const auto spec = std::find_if(options_.processes.begin(), options_.processes.end(),
                                   [](const auto& p) { return p.role == Role::domain; });
    return **std::find_if(children_.begin(), children_.end(),
                          [&](const auto& child) { return child->name() == spec->name; });
  }

  std::vector<ProcessSummary> summaries() const {
    std::vector<ProcessSummary> list;
    for (const auto& process : options_.processes) {
      const auto child = std::find_if(children_.begin(), children_.end(),
                                      [&](const auto& c) { return c->name() == process.name; });
      const auto report = hub_.reports().find(process.name);
      list.push_back({process.name,
                      child == children_.end() ? seconds_since(start_) : (*child)->wall_seconds(),
                      process.elsewhere ? std::numeric_limits<double>::quiet_NaN() : (*child)->cpu_seconds(),
                      report == hub_.reports().end() ? ParticipantReport{} : report->second});
    }
    return list;
  }

  const LaunchOptions& options_;
  SignalWatch signals_; // before the context, whose threads inherit the blocked signals
  RunEndpoint endpoint_;
  HubOptions hub_options_;
  zmq::context_t context_;
  Hub hub_;
  std::vector<std::unique_ptr<ChildProcess>> children_;
  std::optional<Clock::time_point> domain_left_;
  bool given_up_ = false; ///< waiting for those that the user starts, and for a BYE
  Clock::time_point start_ = Clock::now();
};

} // namespace

std::vector<ProcessSummary> launch(const LaunchOptions& options) {
  return Run(options).to_its_end();
}

} // namespace tremolo::coupler
