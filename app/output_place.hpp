#pragma once

// Protection of files: a command never overwrites a file that it reads, and replaces an existing file only if
// it recognises it as the kind of file that it writes.

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::app {

/// Whether a file that exists is of the kind that a command writes.
using IsOwn = std::function<bool(const std::filesystem::path&)>;

/// A text that begins with these words, such as the heading of a table.
IsOwn begins_with(std::string words);

/// A text that has these words in its first 4 KiB.
IsOwn has_words(std::string words);

/// An HDF5 file with this attribute `content`.
IsOwn has_content(std::string content);

/// A motion as `tremolo motion` and `tremolo deconvolve` write it.
bool is_written_motion(const std::filesystem::path& file);

/// A picture that the Python package drew.
bool is_picture_of_tremolo(const std::filesystem::path& file);

/// The first bytes of a file, enough for its heading; none where it cannot be read.
std::string head_of(const std::filesystem::path& file);

/// Refuses, before the work is done, a file that could not be written after it or must not be.
/// @param inputs  files that the command reads; those that are not there do not count
/// @param option  that names the file, for messages
/// @throws std::runtime_error naming the file and what is in its way
void require_writable(const std::filesystem::path& out, const std::vector<std::filesystem::path>& inputs,
                      const IsOwn& is_own, std::string_view option = "--out");

/// A file that a command writes into a folder.
struct OwnFile {
  std::string name;
  IsOwn is_own;
};

/// Checks those files of a folder that exist as require_writable() does.
void require_writable_in(const std::filesystem::path& folder, const std::vector<OwnFile>& files,
                         const std::vector<std::filesystem::path>& inputs);

/// Makes a folder with those above it, where they are not there yet.
/// @returns whether it was made
/// @throws std::runtime_error naming the folder and what is in its way
bool make_folder(const std::filesystem::path& folder);

} // namespace tremolo::app
