#pragma once

// The steps of a field as a source sends them, kept in a file without a name: a long motion at many levels
// has more bytes than a process should hold, and a source needs only the steps that are asked for next. The
// Fourier synthesis gives all times of a level, a frame wants all levels of a time; the file turns the one
// into the other.
//
// The file lies in $TMPDIR, or /var/tmp, and is gone with the process, however that ends.

#include "wavefield/signal/history.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace tremolo::wavefield {

class ServedSteps {
public:
  /// vx, vy, sxx, syy, sxy and their time derivatives.
  static constexpr std::size_t values_per_level = 10;

  /// @param levels of every step
  /// @param pieces how many steps each of the pieces has in which they come, one after the other
  /// @throws std::runtime_error with the folder and the system's reason, as all of these
  ServedSteps(std::size_t levels, const std::vector<std::size_t>& pieces);
  ~ServedSteps();
  ServedSteps(ServedSteps&& other) noexcept;
  ServedSteps& operator=(ServedSteps&&) = delete;

  /// Levels of a piece, from the lowest up, with velocity, stress and their rates; together with the same
  /// ones in every piece.
  void put(std::size_t piece, std::size_t first_level, std::span<const History> levels);

  /// One step of all levels, all of which have been put.
  /// @param values out: values_per_level of each level, from the lowest up
  void read(std::uint64_t step, std::span<double> values) const;

private:
  /// Steps from the first one to that of the next piece. In the file a piece holds its lots, levels that were
  /// put together, as [steps][levels][values_per_level], the lowest first.
  struct Piece {
    std::uint64_t first = 0;
    std::size_t steps = 0;
  };

  /// Position of a step's values for the levels of a piece, the first of which is the lowest of a lot.
  std::size_t place(const Piece& piece, std::uint64_t step, std::size_t first_level,
                    std::size_t levels) const;

  std::size_t levels_;
  std::vector<Piece> pieces_;
  std::map<std::size_t, std::size_t> lots_; ///< first level -> number of levels
  int file_;
};

} // namespace tremolo::wavefield
