#include "wavefield/process/served_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <iterator>
#include <stdexcept>
#include <string>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace tremolo::wavefield {

namespace {

constexpr std::size_t level_bytes = ServedSteps::values_per_level * sizeof(double);
/// Size of a block that is transposed at a time.
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

ServedSteps::ServedSteps(std::size_t levels, const std::vector<std::size_t>& pieces)
    : levels_(levels), file_(unnamed_file()) {
  std::uint64_t first = 0;
  for (const std::size_t steps : pieces) {
    pieces_.push_back({first, steps});
    first += steps;
  }
}

ServedSteps::ServedSteps(ServedSteps&& other) noexcept
    : levels_(other.levels_), pieces_(std::move(other.pieces_)), lots_(std::move(other.lots_)),
      file_(std::exchange(other.file_, -1)) {}

ServedSteps::~ServedSteps() {
  if (file_ >= 0)
    ::close(file_);
}

std::size_t ServedSteps::place(const Piece& piece, std::uint64_t step, std::size_t first_level,
                               std::size_t levels) const {
  return level_bytes * (piece.first * levels_ + first_level * piece.steps + (step - piece.first) * levels);
}

void ServedSteps::put(std::size_t piece, std::size_t first_level, std::span<const History> levels) {
  const Piece& at = pieces_.at(piece);
  lots_[first_level] = levels.size();
  const std::size_t block_steps = std::max<std::size_t>(1, block_bytes / (levels.size() * level_bytes));
  std::vector<double> block;
  for (std::size_t first = 0; first < at.steps; first += block_steps) {
    const std::size_t last = std::min(at.steps, first + block_steps);
    block.clear();
    for (std::size_t step = first; step < last; ++step)
      for (const History& level : levels)
        for (const auto* values : series(level))
          block.push_back(values->at(step));
    const auto bytes = std::as_bytes(std::span<const double>(block));
    transfer_all(::pwrite, file_, bytes.data(), bytes.size(),
                 place(at, at.first + first, first_level, levels.size()));
  }
}

void ServedSteps::read(std::uint64_t step, std::span<double> values) const {
  const Piece& piece = *std::prev(std::ranges::upper_bound(pieces_, step, {}, &Piece::first));
  auto* to = std::as_writable_bytes(values).data();
  for (const auto& [first_level, levels] : lots_) {
    transfer_all(::pread, file_, to, levels * level_bytes, place(piece, step, first_level, levels));
    to += levels * level_bytes;
  }
}

} // namespace tremolo::wavefield
