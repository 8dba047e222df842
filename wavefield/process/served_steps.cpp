#include "wavefield/process/served_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace tremolo::wavefield {

namespace {

constexpr std::size_t level_bytes = ServedSteps::values_per_level * sizeof(double);
/// What is turned round at a time.
constexpr std::size_t block_bytes = std::size_t{1} << 20;

std::string folder() {
  const char* chosen = std::getenv("TMPDIR");
  return chosen == nullptr || *chosen == '\0' ? "/var/tmp" : chosen;
}

[[noreturn]] void refuse(int reason) {
  throw std::runtime_error(
      fmt::format("cannot keep the free field in {} (TMPDIR): {}", folder(),
                  reason == 0 ? "the file is shorter than it was" : std::generic_category().message(reason)));
}

/// A file without a name in the folder.
int unnamed_file() {
  std::string name = folder() + "/tremolo-wave-XXXXXX";
  const int file = ::mkostemp(name.data(), O_CLOEXEC);
  if (file < 0)
    refuse(errno);
  ::unlink(name.c_str());
  return file;
}

/// pread or pwrite of all bytes.
template <typename Transfer, typename Byte>
void transfer_all(const Transfer& transfer, int file, Byte* bytes, std::size_t count, std::size_t place) {
  while (count > 0) {
    const auto done = transfer(file, bytes, count, static_cast<off_t>(place));
    if (done <= 0 && !(done < 0 && errno == EINTR))
      refuse(done < 0 ? errno : 0);
    const auto whole = static_cast<std::size_t>(std::max<ssize_t>(done, 0));
    bytes += whole;
    count -= whole;
    place += whole;
  }
}

std::array<const std::vector<double>*, ServedSteps::values_per_level> series(const History& h) {
  return {&h.vx,      &h.vy,      &h.sxx,      &h.syy,      &h.sxy,
          &h.vx_rate, &h.vy_rate, &h.sxx_rate, &h.syy_rate, &h.sxy_rate};
}

} // namespace

ServedSteps::ServedSteps(std::size_t steps) : steps_(steps), file_(unnamed_file()) {}

ServedSteps::ServedSteps(ServedSteps&& other) noexcept
    : steps_(other.steps_), levels_(other.levels_), bytes_(other.bytes_), lots_(std::move(other.lots_)),
      file_(std::exchange(other.file_, -1)) {}

ServedSteps::~ServedSteps() {
  if (file_ >= 0)
    ::close(file_);
}

void ServedSteps::append(std::span<const History> levels) {
  const Lot lot{levels.size(), bytes_};
  const std::size_t row_bytes = lot.levels * level_bytes;
  const std::size_t block_steps = std::max<std::size_t>(1, block_bytes / row_bytes);
  std::vector<double> block;
  for (std::size_t first = 0; first < steps_; first += block_steps) {
    const std::size_t last = std::min(steps_, first + block_steps);
    block.clear();
    for (std::size_t step = first; step < last; ++step)
      for (const History& level : levels)
        for (const auto* values : series(level))
          block.push_back(values->at(step));
    const auto bytes = std::as_bytes(std::span<const double>(block));
    transfer_all(::pwrite, file_, bytes.data(), bytes.size(), lot.place + first * row_bytes);
  }
  bytes_ += steps_ * row_bytes;
  levels_ += lot.levels;
  lots_.push_back(lot);
}

void ServedSteps::read(std::uint64_t step, std::span<double> values) const {
  auto* to = std::as_writable_bytes(values).data();
  for (const Lot& lot : lots_) {
    const std::size_t row_bytes = lot.levels * level_bytes;
    transfer_all(::pread, file_, to, row_bytes, lot.place + step * row_bytes);
    to += row_bytes;
  }
}

} // namespace tremolo::wavefield
