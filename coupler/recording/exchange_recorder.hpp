#pragma once

// Records the exchange of a run (results/exchange_file.hpp). The hub's thread only copies a frame into a
// queue; a thread of its own compresses and writes. A recording that cannot continue, because the disk is
// full or too slow, is reported: the run ends, or continues with a note, as the case chose; never is anything
// left out in silence.

#include "coupler/hub/checkpoint_set.hpp"
#include "coupler/hub/exchange_observer.hpp"
#include "results/exchange_file.hpp"

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace tremolo::coupler {

/// Its file in a set of checkpoint files.
inline constexpr const char* recording_checkpoint = "recording.h5";

/// What happens to the run when the recording cannot continue.
enum class OnFullDisk { stop, go_on };

struct RecorderOptions {
  std::filesystem::path file;
  OnFullDisk on_full_disk = OnFullDisk::stop;
  std::string case_text;
  std::vector<results::RecordedValue> case_values;
  std::map<std::string, std::vector<std::string>> serves; ///< the sides of each source
  std::function<void(const std::string&)> note;           ///< called, from the hub's thread, when it goes on
  std::optional<CheckpointSet> resume{}; ///< goes on in a new file from what was recorded until then
};

class ExchangeRecorder : public ExchangeObserver {
public:
  explicit ExchangeRecorder(RecorderOptions options) : options_(std::move(options)) {}
  ~ExchangeRecorder() override;
  ExchangeRecorder(const ExchangeRecorder&) = delete;
  ExchangeRecorder& operator=(const ExchangeRecorder&) = delete;

  /// @throws Error if the recording has failed and the run is to stop, and where a run that is resumed cannot
  /// go on with what was recorded
  void begin(const ExchangeStart& start) override;
  void frame(std::span<const std::byte> bytes) override;
  /// Waits until all is written; a recording that has failed saves nothing.
  void save(const std::filesystem::path& folder, std::uint64_t step) override;

  /// Writes what is left and marks the recording as complete, or as aborted with the reason why the run was.
  /// @returns why the recording is not complete; nothing if it is, or if the run never came to an exchange
  std::optional<std::string> finish(const std::optional<std::string>& reason);

private:
  enum class Kind { source, velocities, tractions };
  struct Job {
    Kind kind = Kind::source;
    std::size_t source = 0;
    std::size_t field = 0;
    results::RecordedFrame frame;
    std::vector<double> values;
  };

  std::unique_ptr<results::ExchangeWriter> new_writer(const results::ExchangeDescription& description) const;
  void take_over(const std::filesystem::path& before, results::ExchangeWriter& writer) const;
  void write();
  void write_until_closed(results::ExchangeWriter& writer);
  void save_if_asked(results::ExchangeWriter& writer);
  void write_job(results::ExchangeWriter& writer, const Job& job);
  std::vector<Job> next_jobs();
  void fail(const std::string& reason);
  void report_failure(const std::string& failure);
  [[nodiscard]] std::optional<std::string> lacking() const;

  RecorderOptions options_;
  ExchangeStart start_;
  std::vector<std::vector<std::uint64_t>> seen_; ///< steps of each field of each source
  std::uint64_t domain_steps_ = 0;
  bool noted_ = false;
  std::unique_ptr<results::ExchangeWriter> writer_; ///< the thread's, once it has started

  std::thread thread_;
  std::mutex mutex_;
  std::condition_variable work_;
  std::condition_variable room_;
  std::deque<Job> queue_;
  std::size_t queued_values_ = 0;
  std::optional<std::pair<std::filesystem::path, results::CheckpointIdentity>> save_; ///< asked for
  std::string status_;                 ///< to close with; empty until finish()
  std::optional<std::string> failure_; ///< of writing
};

} // namespace tremolo::coupler
