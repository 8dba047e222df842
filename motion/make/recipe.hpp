#pragma once

#include "motion/make/pulses.hpp"
#include "motion/make/synthesis.hpp"

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <variant>

namespace tremolo::motion {

struct PulseRecipe {
  Pulse pulse;
  Unit unit = Unit::m_s;
  double dt = 0.0; ///< s
  std::size_t count = 0;
};

/// A motion to be made: from a [pulse], or from [target], [filter] and [envelope].
struct Recipe {
  std::string title;
  std::optional<MotionKind> kind;
  std::variant<PulseRecipe, SynthesisRecipe> what;
};

/// @throws RecordError "file:line: text" for a file that cannot be read, an unknown or missing key, or a
///         value of another type
Recipe read_recipe(const std::filesystem::path& file);

/// Reads a recipe from a stream; `file` names it in messages.
Recipe parse_recipe(std::istream& stream, const std::filesystem::path& file);

} // namespace tremolo::motion
