#pragma once

// Writing of attributes, tables and strings. Strings have a fixed length (UTF-8, padded with NUL): they live
// where they are declared and can be overwritten in place, which is what keeps a file readable when its
// writer dies.

#include "results/hdf5/hdf5_handle.hpp"
#include "results/run_data.hpp"

#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace tremolo::results {

/// A place in a file: the object under which something is written.
struct Place {
  hid_t object;
  const std::filesystem::path& file; ///< for messages
};

/// A fixed-length string type of `size` bytes (at least 1).
Handle string_type(std::size_t size);

void write_attribute(Place place, std::string_view name, const AttributeValue& value);

/// A scalar string dataset.
void write_text(Place place, std::string_view name, std::string_view text);

/// Links of these groups stay in the group's own header, with room reserved for `expected_links`: a later
/// link is then one write of one block.
Handle group_properties(std::size_t expected_links);

/// Creates a group under `place`.
Handle create_group(Place place, std::string_view name, std::size_t expected_links);

/// A group some of whose attributes may take more than the 64 KiB that HDF5 has for one by default.
Handle create_group_of_long_attributes(Place place, std::string_view name, std::size_t expected_links);

/// Writes a table as a new group that belongs to no other group yet, so that linking it makes all of it
/// visible at once.
Handle write_unlinked_table(Place place, const Table& table);

/// Opens an existing file for writing with the properties that keep it readable at any moment.
Handle open_for_writing(const std::filesystem::path& file);

/// Opens an existing file likewise, but for objects that HDF5 has only had since 1.10: virtual datasets.
Handle open_for_virtual_datasets(const std::filesystem::path& file);

/// Creates a file with these properties.
Handle create_file(const std::filesystem::path& file);

/// Brings a file opened by one of the two up to date on disk, in an order that never shows a half-finished
/// state: first the end of the file, then the metadata, which may refer to anything before it.
void flush_file(const Handle& open_file, const std::filesystem::path& file);

/// Creates the file as FILE.new until publish_draft() renames it: a file under its own name can always be
/// opened.
Handle create_draft(const std::filesystem::path& file);

/// Flushes a draft and gives it its own name.
void publish_draft(const Handle& open_file, const std::filesystem::path& file);

/// Runs actions that write. When one fails, the file is left as the last flush made it: its descriptor is
/// replaced by one that refuses writes, so that closing cannot add half of what failed. Whatever is tried
/// afterwards fails with the same reason, not with what has become of the descriptor.
class WriteGuard {
public:
  template <class Action>
  void operator()(const Handle& open_file, Action action) {
    if (failure_) {
      throw std::runtime_error(*failure_);
    }
    try {
      action();
    } catch (const std::runtime_error& error) {
      failure_ = error.what();
      refuse_further_writes(open_file);
      throw;
    }
  }

private:
  static void refuse_further_writes(const Handle& open_file);

  std::optional<std::string> failure_;
};

} // namespace tremolo::results
