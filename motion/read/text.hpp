#pragma once

// Text of unknown origin, read with bounded memory; shared by the readers of PEER and table files.

#include <cstddef>
#include <filesystem>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::motion {

/// @throws RecordError "file:line: text"
[[noreturn]] void refuse(const std::filesystem::path& file, std::size_t line, const std::string& text);

/// The lines of a text file: no longer than longest_line, without binary data.
class Lines {
public:
  Lines(std::istream& stream, std::filesystem::path file) : stream_(stream), file_(std::move(file)) {}

  /// @throws RecordError for a line that is too long or binary
  bool next();

  const std::string& text() const { return text_; }
  std::size_t number() const { return number_; } ///< from 1
  const std::filesystem::path& file() const { return file_; }

  [[noreturn]] void refuse(const std::string& text) const;

private:
  std::istream& stream_;
  std::filesystem::path file_;
  std::string text_;
  std::size_t number_ = 0;
};

/// What stands between blanks, commas, semicolons and equals signs.
std::vector<std::string_view> words(std::string_view line);

/// A finite number as Fortran may write it: ".5", "+1.", "1.0D-3".
std::optional<double> number(std::string_view word);

/// The beginning of a text, fit for a message.
std::string shown(std::string_view text);

std::string upper(std::string_view text);

} // namespace tremolo::motion
