#pragma once

// Small cases that differ in what a case can choose. A factor is one choice and its values; the first value
// of each makes the plain case, which is sound.

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::testing {

struct Factor {
  std::string_view name;
  std::vector<std::string_view> values;
};

const std::vector<Factor>& factors();

/// A value of each factor, by index.
using Draw = std::vector<std::size_t>;

/// What was drawn other than the plain case, in words.
std::string described(const Draw& draw);

/// The complete case.
std::string case_text(const Draw& draw);

/// The tables that `tremolo column` needs of it, without [mesh].
std::string column_text(const Draw& draw);

/// The value of a factor.
std::string_view drawn(const Draw& draw, std::string_view factor);

/// Writes the record that cases with a file name.
void write_record(const std::filesystem::path& folder);

} // namespace tremolo::testing
