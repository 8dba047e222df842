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
#include <span>
#include <vector>

namespace tremolo::wavefield {

class ServedSteps {
public:
  /// vx, vy, sxx, syy, sxy and their time derivatives.
  static constexpr std::size_t values_per_level = 10;

  /// @param steps of every level
  /// @throws std::runtime_error with the folder and the system's reason, as all of these
  explicit ServedSteps(std::size_t steps);
  ~ServedSteps();
  ServedSteps(ServedSteps&& other) noexcept;
  ServedSteps& operator=(ServedSteps&&) = delete;

  /// Adds the next levels, from the lowest up, with velocity, stress and their rates.
  void append(std::span<const History> levels);

  [[nodiscard]] std::size_t levels() const { return levels_; }

  /// One step of all levels.
  /// @param values out: values_per_level of each level, from the lowest up
  void read(std::uint64_t step, std::span<double> values) const;

private:
  /// Levels that were added together: [steps][levels][values_per_level] from a place in the file on.
  struct Lot {
    std::size_t levels = 0;
    std::size_t place = 0; ///< bytes
  };

  std::size_t steps_;
  std::size_t levels_ = 0;
  std::size_t bytes_ = 0;
  std::vector<Lot> lots_;
  int file_;
};

} // namespace tremolo::wavefield
