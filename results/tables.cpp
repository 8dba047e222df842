// Writing to files of tables and to runs whose process has ended.

#include "results/hdf5/hdf5_read.hpp"
#include "results/hdf5/hdf5_write.hpp"
#include "results/run_file.hpp"
#include "results/run_status.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace tremolo::results {
namespace {

/// Complete and flushed before it is linked; groups on the way to it are created.
void add_table(const Handle& open_file, const std::filesystem::path& file, std::string_view path,
               const Table& table) {
  const Handle group = write_unlinked_table({open_file.get(), file}, table);
  flush_file(open_file, file);
  const Handle linking(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(linking.get(), 1);
  checked(H5Olink(group.get(), open_file.get(), std::string(path).c_str(), linking.get(), H5P_DEFAULT), file,
          fmt::format("add {}", path));
  flush_file(open_file, file);
}

} // namespace

void append_table(const std::filesystem::path& file, std::string_view path, const Table& table) {
  add_table(open_for_writing(file), file, path, table);
}

void mark_aborted(const std::filesystem::path& file, std::string_view reason) {
  const Handle run = open_for_writing(file);
  set_status({run.get(), file}, aborted_status(reason));
  flush_file(run, file);
}

void write_tables(const std::filesystem::path& file, std::string_view content,
                  std::span<const NamedTable> tables) {
  const Handle created = create_file(file);
  write_attribute({created.get(), file}, "content", std::string(content));
  for (const NamedTable& named : tables) {
    add_table(created, file, named.path, named.table);
  }
}

std::string content_of(const std::filesystem::path& file) {
  try {
    return FileReader(file, "file").attribute_as<std::string>("/", "content");
  } catch (const std::runtime_error&) {
    return "";
  }
}

} // namespace tremolo::results
