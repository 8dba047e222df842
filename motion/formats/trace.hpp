#pragma once

// Traces that readers find in files, with the statements about each. The choice of a trace and of its unit is
// made in one place for all formats.

#include "motion/read/read.hpp"
#include "motion/read/stated.hpp"
#include "motion/read/text.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tremolo::motion {

/// The largest value that a file states.
struct StatedPeak {
  Printed printed;
  ScaledUnit unit;
};

/// One quantity of one component.
struct Trace {
  std::string component = {}; ///< as the file calls it; empty where it names none
  Stated stated = {};
  double dt = 0.0;                  ///< s
  std::vector<double> samples = {}; ///< in the unit stated
  std::string baseline = {};        ///< what was done to it before or while reading
  std::optional<StatedPeak> peak = std::nullopt;
  std::string doubt = {}; ///< worth a warning
  std::size_t line = 1;   ///< where its header ends
};

/// A stated quantity and unit.
Stated stated(ScaledUnit unit);

/// The number from 0 of the name that `asked` means: its number from `first` on, the name, or a part that no
/// other name has, in either case.
std::optional<std::size_t> place_of(const std::string& asked, const std::vector<std::string>& names,
                                    std::size_t first = 1);

/// "1 'N-S', 2 'E-W'".
std::string listed(const std::vector<std::string>& names, std::size_t first = 1);

/// The trace that `as` asks for, or the only one; acceleration where a component has several quantities.
/// @throws RecordError where the choice is open, with the names of the components
Record chosen(std::vector<Trace> traces, const std::string& format, const std::filesystem::path& file,
              const ReadAs& as, bool fallback_to_peer = false);

} // namespace tremolo::motion
