#pragma once

// A participant in a thread of this process: its main with its output in a log file. A thread cannot be
// killed: one that does not react is left alone, and its process must end without destructors
// (std::_Exit), which would take away what it uses.

#include "coupler/client/participant_options.hpp"
#include "coupler/launch/child.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <thread>

namespace tremolo::coupler {

class ChildThread final : public Child {
public:
  /// @param context the hub's
  /// @throws Error if the log cannot be written; std::system_error if there can be no other thread
  ChildThread(std::string name, const ParticipantMain& main, const CommandLine& command,
              std::filesystem::path log_file, std::shared_ptr<zmq::context_t> context);

  ~ChildThread() override;

  bool ended() override;
  /// Leaves it alone.
  void kill() override;
  [[nodiscard]] bool succeeded() const override;
  [[nodiscard]] std::string ending() const override;

private:
  struct Outcome;

  std::shared_ptr<Outcome> outcome_; ///< the thread's too, which may outlive us
  std::thread thread_;
};

} // namespace tremolo::coupler
