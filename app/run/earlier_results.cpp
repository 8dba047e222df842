#include "app/run/earlier_results.hpp"

#include "app/run/run_lock.hpp"
#include "base/own_process.hpp"
#include "coupler/wire/handshake/messages.hpp"
#include "results/checkpoint_file.hpp"
#include "results/run_checksums.hpp"
#include "results/run_file.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace tremolo::app {

namespace fs = std::filesystem;

namespace {

constexpr const char* complete = "complete";

/// The file that the domain takes over: the one that a resumption which died has set aside, if there is one.
fs::path file_to_take_over(const fs::path& folder) {
  const fs::path before = folder / "run.h5.before";
  return fs::exists(before) ? before : folder / "run.h5";
}

std::vector<results::Checksum> checksums_of(const coupler::CheckpointSet& set) {
  const results::CheckpointReader checkpoint(set.folder / "domain.h5",
                                             {"domain", coupler::text_crc(set.run.case_text), set.step});
  return results::checksums_from(checkpoint.text(std::string(results::checksums_name)));
}

/// A damaged file may say that it holds any amount of numbers.
ProcessLimits limits_for(const fs::path& file) {
  constexpr std::uint64_t memory_beside = std::uint64_t{1} << 30;
  constexpr std::uint64_t bytes_a_second = 4'000'000; // far below what any machine reads
  constexpr unsigned least_seconds = 30;
  const std::uint64_t size = fs::file_size(file);
  return {memory_beside + 8 * size, least_seconds + static_cast<unsigned>(size / bytes_a_second)};
}

} // namespace

bool earlier_results_are_complete(const fs::path& folder, const std::optional<coupler::CheckpointSet>& set) {
  const RunLock lock(folder); // a file that is being written is not damaged
  const fs::path file = file_to_take_over(folder);
  if (!set && !fs::exists(file))
    return false;
  try {
    if (!fs::exists(file))
      throw std::runtime_error("it is missing");
    const auto checksums = set ? checksums_of(*set) : std::vector<results::Checksum>{};
    const auto read = [&]() -> std::string {
      if (file.extension() == ".h5" && results::RunReader(file).status() == complete)
        return complete;
      results::require_undamaged(file, checksums);
      return "";
    };
    return in_own_process(read, limits_for(file)) == complete;
  } catch (const std::exception& error) {
    throw std::runtime_error(
        fmt::format("cannot go on: reading {}, which a resumed run takes over, failed: {}\n"
                    "  The file is damaged, or was changed after the checkpoint{}. Nothing was started or "
                    "changed. Put back an "
                    "intact copy\n  of the file, or begin again: tremolo run {}",
                    file.string(), error.what(), set ? fmt::format(" of step {}", set->step) : "",
                    (folder / "case.toml").string()));
  }
}

} // namespace tremolo::app
