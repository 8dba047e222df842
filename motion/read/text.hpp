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

/// Without the blanks at both ends.
std::string_view trimmed(std::string_view text);

/// The text with one blank between words and none at the ends.
std::string squeezed(std::string_view text);

/// Whether a line holds, or begins with, a text in capitals; the line may be in either case.
bool says(std::string_view line, std::string_view capitals);
bool begins(std::string_view line, std::string_view capitals);

/// The text after some words in capitals; empty if the line does not contain them.
std::optional<std::string_view> after(std::string_view line, std::string_view capitals);

/// A number as printed.
struct Printed {
  double value = 0.0;
  double rounding = 0.0; ///< half of its last digit
};

/// The first number behind a text in capitals, with only blanks and signs such as ':' or '=' between, or a
/// unit in brackets.
std::optional<Printed> number_after(std::string_view line, std::string_view capitals);

/// Numbers in fields of `width` characters, which may touch, from as many lines as `count` of them need.
/// @throws RecordError where a field is no number, or the text ends
std::vector<double> fixed_fields(Lines& lines, std::size_t width, std::size_t count);

/// The width of a field in a format as Fortran writes it: 10 of "(8F10.3)"; nothing if there is none.
std::optional<std::size_t> field_width(std::string_view format);

/// The words between blanks, commas, semicolons and equals signs.
std::vector<std::string_view> words(std::string_view line);

/// A finite number as Fortran may write it: ".5", "+1.", "1.0D-3".
std::optional<double> number(std::string_view word);

/// The beginning of a text, fit for a message.
std::string shown(std::string_view text);

std::string upper(std::string_view text);

} // namespace tremolo::motion
