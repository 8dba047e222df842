#include "coupler/recording/exchange_recorder.hpp"

#include "coupler/mapping/timing.hpp"
#include "coupler/wire/error.hpp"
#include "coupler/wire/frame.hpp"
#include "coupler/wire/handshake/messages.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fmt/format.h>

namespace tremolo::coupler {

namespace {

/// Numbers that wait to be written, 64 MiB: the hub waits when the disk is slower than the exchange.
constexpr std::size_t most_queued_values = std::size_t{8} << 20;
/// A disk that takes nothing for so long is as good as full.
constexpr std::chrono::seconds longest_wait{20};
/// Largest loss by a full disk or a kill of the writing process, besides rows that do not yet fill a chunk,
/// s.
constexpr double flush_interval_s = 0.1;

std::string aborted(std::uint64_t step, const std::string& reason) {
  return fmt::format("aborted at step {}: {}", step, reason);
}

std::string first_line(const std::string& text) {
  return text.substr(0, text.find('\n'));
}

results::ExchangeSource recorded(const SourceDescription& source, const RecorderOptions& options) {
  results::ExchangeSource record{.name = source.name, .number = source.number, .serves = {}, .fields = {}};
  if (const auto sides = options.serves.find(source.name); sides != options.serves.end())
    record.serves = sides->second;
  for (const auto& field : source.fields)
    record.fields.push_back({.name = field.name,
                             .levels = field.y,
                             .x_reference = field.x_reference,
                             .slowness_x = field.slowness_x,
                             .start_time = field.start_time,
                             .time_step = field.time_step,
                             .step_count = field.step_count});
  return record;
}

results::ExchangeDescription recorded(const ExchangeStart& start, const RecorderOptions& options) {
  results::ExchangeDescription description{.session = session_text(start.session),
                                           .mode = std::string(name(start.mode)),
                                           .case_text = options.case_text,
                                           .case_values = options.case_values,
                                           .sources = {},
                                           .domain = start.domain,
                                           .domain_number = start.domain_number,
                                           .faces = {},
                                           .start_time = start.start_time,
                                           .end_time = start.end_time};
  for (const auto& source : start.sources)
    description.sources.push_back(recorded(source, options));
  auto& faces = description.faces;
  for (const auto& face : start.faces) {
    const auto& [normal, impedance_p, impedance_s] = face.dashpot;
    faces.position.insert(faces.position.end(), {face.position.x, face.position.y});
    faces.normal.insert(faces.normal.end(), {normal.x, normal.y});
    faces.impedance.insert(faces.impedance.end(), {impedance_p, impedance_s});
    faces.static_traction.insert(faces.static_traction.end(),
                                 {face.static_traction.x, face.static_traction.y});
    faces.source.push_back(face.source);
    faces.field.push_back(face.field);
  }
  return description;
}

/// A thread that no signal is delivered to: those of the user are the launcher's, and a file that grows
/// beyond its limit (SIGXFSZ) is then an error like any other.
template <typename Action>
std::thread quiet_thread(Action action) {
  sigset_t all;
  sigset_t previous;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &previous);
  std::thread thread(std::move(action));
  pthread_sigmask(SIG_SETMASK, &previous, nullptr);
  return thread;
}

} // namespace

ExchangeRecorder::~ExchangeRecorder() {
  finish("the recording was given up");
}

void ExchangeRecorder::begin(const ExchangeStart& start) {
  start_ = start;
  for (const auto& source : start.sources)
    seen_.emplace_back(source.fields.size(), 0);
  domain_steps_ = options_.resume ? options_.resume->step : 0;
  try {
    writer_ = new_writer(recorded(start, options_));
  } catch (const std::exception& error) {
    if (options_.resume)
      throw Error(fmt::format("the recording of the exchange cannot go on: {}", error.what()));
    fail(error.what());
    report_failure(error.what());
    return;
  }
  thread_ = quiet_thread([this] { write(); });
}

std::unique_ptr<results::ExchangeWriter>
ExchangeRecorder::new_writer(const results::ExchangeDescription& description) const {
  if (!options_.resume)
    return std::make_unique<results::ExchangeWriter>(options_.file, description);
  const auto before = results::set_aside(options_.file);
  try {
    auto writer = std::make_unique<results::ExchangeWriter>(options_.file, description);
    take_over(before, *writer);
    std::filesystem::remove(before);
    return writer;
  } catch (const std::exception&) {
    // The recording is the same as before the attempt.
    std::filesystem::rename(before, options_.file);
    throw;
  }
}

void ExchangeRecorder::take_over(const std::filesystem::path& before, results::ExchangeWriter& writer) const {
  writer.take_over(before, {options_.resume->folder / recording_checkpoint,
                            {"recording", text_crc(options_.case_text), options_.resume->step}});
}

void ExchangeRecorder::frame(std::span<const std::byte> bytes) {
  const Frame frame = opened(bytes);
  const FrameHeader& header = frame.header;
  Job job{.kind = Kind::source,
          .source = 0,
          .field = header.field,
          .frame = {header.step, header.steps, frame.crc},
          .values = frame.values()};
  if (header.sender == 0) {
    job.kind = Kind::tractions;
  } else if (header.sender == start_.domain_number) {
    job.kind = Kind::velocities;
    domain_steps_ += header.steps;
  } else {
    const auto source = std::ranges::find(start_.sources, header.sender, &SourceDescription::number);
    job.source = static_cast<std::size_t>(source - start_.sources.begin());
    seen_.at(job.source).at(header.field) += header.steps;
  }

  std::unique_lock lock(mutex_);
  const bool room = room_.wait_for(lock, longest_wait, [&] {
    return failure_ || queued_values_ == 0 || queued_values_ + job.values.size() <= most_queued_values;
  });
  if (!room)
    failure_ =
        fmt::format("{}: the disk has taken nothing for {} s", options_.file.string(), longest_wait.count());
  if (failure_) {
    const std::string failure = *failure_;
    lock.unlock();
    report_failure(failure);
    return;
  }
  queued_values_ += job.values.size();
  queue_.push_back(std::move(job));
  work_.notify_one();
}

void ExchangeRecorder::save(const std::filesystem::path& folder, std::uint64_t step) {
  std::unique_lock lock(mutex_);
  if (failure_)
    return;
  save_ = {folder / recording_checkpoint, {"recording", text_crc(options_.case_text), step}};
  work_.notify_one();
  room_.wait(lock, [&] { return failure_ || !save_; });
}

void ExchangeRecorder::report_failure(const std::string& failure) {
  if (options_.on_full_disk == OnFullDisk::stop)
    throw Error(fmt::format("the exchange cannot be recorded any more: {} ([record] on_full_disk = \"stop\")",
                            failure));
  if (!noted_)
    options_.note(fmt::format("warning: the exchange is not recorded any more: {}; the run goes on "
                              "([record] on_full_disk = \"go_on\")",
                              failure));
  noted_ = true;
}

std::optional<std::string> ExchangeRecorder::finish(const std::optional<std::string>& reason) {
  if (!thread_.joinable())
    return failure_;
  const auto missing = reason ? reason : lacking();
  {
    const std::lock_guard lock(mutex_);
    status_ = missing ? aborted(domain_steps_, first_line(*missing)) : "complete";
    work_.notify_one();
  }
  thread_.join();
  return failure_ ? failure_ : missing;
}

std::optional<std::string> ExchangeRecorder::lacking() const {
  for (std::size_t s = 0; s < seen_.size(); ++s)
    for (std::size_t f = 0; f < seen_[s].size(); ++f)
      if (seen_[s][f] < start_.needed_steps[s][f])
        return fmt::format("source '{}' had sent {} of {} steps of field '{}' when the run ended",
                           start_.sources[s].name, seen_[s][f], start_.needed_steps[s][f],
                           start_.sources[s].fields[f].name);
  return std::nullopt;
}

void ExchangeRecorder::write() {
  std::optional<std::string> failure;
  try {
    write_until_closed(*writer_);
  } catch (const std::exception& error) {
    failure = error.what();
  }
  writer_.reset();
  if (failure)
    fail(*failure);
}

void ExchangeRecorder::write_until_closed(results::ExchangeWriter& writer) {
  auto last_flush = Clock::now();
  for (;;) {
    for (const auto& job : next_jobs())
      write_job(writer, job);
    if (seconds_since(last_flush) > flush_interval_s) {
      writer.flush();
      last_flush = Clock::now();
    }
    save_if_asked(writer);
    const std::lock_guard lock(mutex_);
    if (failure_)
      throw Error(*failure_);
    if (queue_.empty() && !status_.empty())
      break;
  }
  writer.close(status_);
}

/// Everything queued before the request has been written: the hub's thread, which fills the queue, waits.
void ExchangeRecorder::save_if_asked(results::ExchangeWriter& writer) {
  std::unique_lock lock(mutex_);
  if (!save_ || !queue_.empty())
    return;
  lock.unlock();
  results::CheckpointWriter file(save_->first, save_->second);
  writer.save(file);
  file.close();
  lock.lock();
  save_.reset();
  room_.notify_one();
}

/// Waits for work, but not longer than a flush may wait.
std::vector<ExchangeRecorder::Job> ExchangeRecorder::next_jobs() {
  std::unique_lock lock(mutex_);
  work_.wait_for(lock, std::chrono::duration<double>(flush_interval_s),
                 [&] { return !queue_.empty() || !status_.empty() || failure_ || save_; });
  std::vector<Job> jobs(std::make_move_iterator(queue_.begin()), std::make_move_iterator(queue_.end()));
  queue_.clear();
  return jobs;
}

void ExchangeRecorder::write_job(results::ExchangeWriter& writer, const Job& job) {
  switch (job.kind) {
  case Kind::source:
    writer.source_frame(job.source, job.field, job.frame, job.values);
    break;
  case Kind::velocities:
    writer.velocity_frame(job.frame, job.values);
    break;
  case Kind::tractions:
    writer.traction_frame(job.frame, job.values);
    break;
  }
  const std::lock_guard lock(mutex_);
  queued_values_ -= job.values.size();
  room_.notify_one();
}

void ExchangeRecorder::fail(const std::string& reason) {
  {
    const std::lock_guard lock(mutex_);
    failure_ = reason;
    queue_.clear();
    room_.notify_one();
  }
  try {
    const auto held = results::ExchangeReader(options_.file).domain_steps();
    results::mark_exchange(options_.file, aborted(held, reason));
  } catch (const std::exception&) {
    // Not even that: its status stays "running", which is not complete either.
  }
}

} // namespace tremolo::coupler
