#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tremolo {

/// A file that is written from its beginning to its end, in place of one that is there. A pipe that nobody
/// reads is refused: opening it would wait for a reader.
class TextFile {
public:
  /// @throws std::runtime_error with the file and the system's reason, as the members do
  explicit TextFile(std::filesystem::path file);
  ~TextFile();
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;

  void add(std::string_view text);
  /// Brings what waits into the file. A file that is not closed may lack its end.
  void close();

private:
  void write_waiting();

  std::filesystem::path file_;
  std::string waiting_;
  int descriptor_;
};

/// Writes a text as a whole file.
/// @throws as TextFile
void write_text_file(const std::filesystem::path& file, std::string_view text);

/// The whole contents of a file.
/// @throws std::runtime_error if it cannot be read
std::string read_text_file(const std::filesystem::path& file);

} // namespace tremolo
