#pragma once

#include "motion/mend/spectral_match.hpp"

#include <filesystem>
#include <iosfwd>

namespace tremolo::motion {

/// A target spectrum from a table whose header names the columns `period` (s) and `acceleration` (m/s2) or
/// `acceleration_g`, in any order, among others; separators as in tables of motions. `tremolo motion
/// --response` writes such a table.
/// @throws RecordError if the file cannot be read or holds no such table
TargetSpectrum read_spectrum(const std::filesystem::path& file);

/// Reads a spectrum from a stream; `file` names it in messages.
TargetSpectrum parse_spectrum(std::istream& stream, const std::filesystem::path& file);

} // namespace tremolo::motion
