#include "results/hdf5/hdf5_write.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <system_error>

namespace tremolo::results {
namespace {

/// Strings of equal length, one after the other.
std::string packed(std::span<const std::string> strings, std::size_t length) {
  std::string bytes(strings.size() * length, '\0');
  for (std::size_t i = 0; i < strings.size(); ++i) {
    std::copy(strings[i].begin(), strings[i].end(), bytes.begin() + static_cast<std::ptrdiff_t>(i * length));
  }
  return bytes;
}

std::size_t longest(std::span<const std::string> strings) {
  std::size_t length = 1;
  for (const auto& s : strings) {
    length = std::max(length, s.size());
  }
  return length;
}

void write_raw_attribute(Place place, std::string_view name, hid_t type, hid_t space, const void* data) {
  const std::string key(name);
  const std::string action = fmt::format("write attribute {}", name);
  const Handle attribute(checked(H5Acreate2(place.object, key.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                                 place.file, action),
                         H5Aclose);
  checked(H5Awrite(attribute.get(), type, data), place.file, action);
}

struct AttributeWriter {
  Place place;
  std::string_view name;

  void operator()(const std::string& value) const {
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const std::size_t length = std::max<std::size_t>(value.size(), 1);
    write_raw_attribute(place, name, string_type(length).get(), space.get(),
                        packed({&value, 1}, length).data());
  }
  void operator()(double value) const {
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    write_raw_attribute(place, name, H5T_NATIVE_DOUBLE, space.get(), &value);
  }
  void operator()(std::int64_t value) const {
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    write_raw_attribute(place, name, H5T_NATIVE_INT64, space.get(), &value);
  }
  void operator()(const std::vector<double>& values) const {
    const hsize_t size = values.size();
    const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
    write_raw_attribute(place, name, H5T_NATIVE_DOUBLE, space.get(), values.data());
  }
  void operator()(const std::vector<std::string>& values) const {
    const hsize_t size = values.size();
    const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
    const std::size_t length = longest(values);
    write_raw_attribute(place, name, string_type(length).get(), space.get(), packed(values, length).data());
  }
};

void write_dataset(Place place, std::string_view name, hid_t type, hid_t space, hid_t properties,
                   const void* data, std::string_view unit) {
  const std::string key(name);
  const std::string action = fmt::format("write {}", name);
  Handle dataset(
      checked(H5Dcreate2(place.object, key.c_str(), type, space, H5P_DEFAULT, properties, H5P_DEFAULT),
              place.file, action),
      H5Dclose);
  checked(H5Dwrite(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data), place.file, action);
  if (!unit.empty()) {
    write_attribute({dataset.get(), place.file}, "unit", std::string(unit));
  }
  checked(H5Dclose(dataset.release()), place.file, action); // writes its metadata
}

struct ColumnWriter {
  Place place;
  const Table::Column& column;

  void operator()(const std::vector<double>& values) const {
    write(H5T_NATIVE_DOUBLE, values.size(), values.data());
  }
  void operator()(const std::vector<std::int64_t>& values) const {
    write(H5T_NATIVE_INT64, values.size(), values.data());
  }
  void operator()(const std::vector<std::string>& values) const {
    const std::size_t length = longest(values);
    write(string_type(length).get(), values.size(), packed(values, length).data());
  }
  void write(hid_t type, hsize_t size, const void* data) const {
    const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
    write_dataset(place, column.name, type, space.get(), H5P_DEFAULT, data, column.unit);
  }
};

/// Metadata of groups and of open datasets reaches the disk only when the file is flushed, since the cache
/// evicts none of it; array values reach it at once, so that nothing on disk ever refers to values that are
/// not there. An object that is closed takes its metadata with it to the disk and out of memory, which else
/// would grow with every frame: nothing refers to it before its group is flushed. Blocks are allocated one by
/// one: the file never has to shrink.
Handle access_properties() {
  Handle properties(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5AC_cache_config_t cache{};
  cache.version = H5AC__CURR_CACHE_CONFIG_VERSION;
  H5Pget_mdc_config(properties.get(), &cache);
  cache.evictions_enabled = false;
  cache.incr_mode = H5C_incr__off;
  cache.flash_incr_mode = H5C_flash_incr__off;
  cache.decr_mode = H5C_decr__off;
  H5Pset_mdc_config(properties.get(), &cache);
  H5Pset_evict_on_close(properties.get(), true);
  H5Pset_cache(properties.get(), 0, 0, 0, 0.0);
  H5Pset_sieve_buf_size(properties.get(), 0);
  H5Pset_meta_block_size(properties.get(), 0);
  H5Pset_small_data_block_size(properties.get(), 0);
  H5Pset_libver_bounds(properties.get(), H5F_LIBVER_EARLIEST, H5F_LIBVER_V18);
  H5Pset_file_locking(properties.get(), false, true); // the run can be looked at while it goes on
  return properties;
}

void reserve_links(hid_t group_properties, std::size_t expected_links) {
  constexpr unsigned typical_name_length = 12;
  constexpr unsigned most_links = 65535;
  H5Pset_link_creation_order(group_properties, H5P_CRT_ORDER_TRACKED);
  H5Pset_link_phase_change(group_properties, most_links, most_links);
  H5Pset_est_link_info(group_properties,
                       static_cast<unsigned>(std::min<std::size_t>(expected_links, most_links)),
                       typical_name_length);
}

std::filesystem::path draft_of(const std::filesystem::path& file) {
  std::filesystem::path draft = file;
  draft += ".new";
  return draft;
}

/// @param shown  in messages
Handle created(const std::filesystem::path& file, const std::filesystem::path& shown) {
  prepare_hdf5();
  constexpr std::size_t expected_root_links = 32;
  const Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  reserve_links(creation.get(), expected_root_links);
  return {checked(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, creation.get(), access_properties().get()), shown,
                  "create the file"),
          H5Fclose};
}

Handle group_with(Place place, std::string_view name, const Handle& properties) {
  const std::string key(name);
  return {checked(H5Gcreate2(place.object, key.c_str(), H5P_DEFAULT, properties.get(), H5P_DEFAULT),
                  place.file, fmt::format("create group {}", name)),
          H5Gclose};
}

} // namespace

Handle string_type(std::size_t size) {
  Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.get(), std::max<std::size_t>(size, 1));
  H5Tset_cset(type.get(), H5T_CSET_UTF8);
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  return type;
}

void write_attribute(Place place, std::string_view name, const AttributeValue& value) {
  std::visit(AttributeWriter{place, name}, value);
}

void write_text(Place place, std::string_view name, std::string_view text) {
  const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const std::string value(text.empty() ? std::string_view("\0", 1) : text);
  write_dataset(place, name, string_type(value.size()).get(), space.get(), H5P_DEFAULT, value.data(), {});
}

Handle group_properties(std::size_t expected_links) {
  Handle properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  reserve_links(properties.get(), expected_links);
  return properties;
}

Handle create_group(Place place, std::string_view name, std::size_t expected_links) {
  return group_with(place, name, group_properties(expected_links));
}

Handle create_group_of_long_attributes(Place place, std::string_view name, std::size_t expected_links) {
  const Handle properties = group_properties(expected_links);
  // Only a header of version 2 keeps long attributes beside itself, and to keep their order asks for that
  // one.
  H5Pset_attr_creation_order(properties.get(), H5P_CRT_ORDER_TRACKED);
  return group_with(place, name, properties);
}

Handle write_unlinked_table(Place place, const Table& table) {
  if (table.columns.empty()) {
    throw std::invalid_argument("a table needs at least one column");
  }
  const auto rows = [](const Table::Column& c) {
    return std::visit([](const auto& v) { return v.size(); }, c.values);
  };
  Handle group(
      checked(H5Gcreate_anon(place.object, group_properties(table.columns.size()).get(), H5P_DEFAULT),
              place.file, "create a table"),
      H5Gclose);
  std::vector<std::string> names;
  for (const auto& column : table.columns) {
    if (rows(column) != rows(table.columns.front())) {
      throw std::invalid_argument(fmt::format("column {} has {} rows where column {} has {}", column.name,
                                              rows(column), table.columns.front().name,
                                              rows(table.columns.front())));
    }
    std::visit(ColumnWriter{{group.get(), place.file}, column}, column.values);
    names.push_back(column.name);
  }
  write_attribute({group.get(), place.file}, "columns", names);
  return group;
}

Handle open_for_writing(const std::filesystem::path& file) {
  prepare_hdf5();
  return {checked(H5Fopen(file.c_str(), H5F_ACC_RDWR, access_properties().get()), file, "open the file"),
          H5Fclose};
}

Handle open_for_virtual_datasets(const std::filesystem::path& file) {
  prepare_hdf5();
  const Handle properties = access_properties();
  H5Pset_libver_bounds(properties.get(), H5F_LIBVER_EARLIEST, H5F_LIBVER_V110);
  return {checked(H5Fopen(file.c_str(), H5F_ACC_RDWR, properties.get()), file, "open the file"), H5Fclose};
}

Handle create_file(const std::filesystem::path& file) {
  return created(file, file);
}

Handle create_draft(const std::filesystem::path& file) {
  return created(draft_of(file), file);
}

void flush_file(const Handle& open_file, const std::filesystem::path& file) {
  constexpr off_t end_of_file_address = 40; // in a version 0 superblock, HDF5 File Format Specification III.A
  void* descriptor = nullptr;
  haddr_t end = 0;
  checked(H5Fget_eoa(open_file.get(), &end), file, "find its end");
  checked(H5Fget_vfd_handle(open_file.get(), H5P_DEFAULT, &descriptor), file, "find its descriptor");
  const int fd = *static_cast<int*>(descriptor);
  struct stat state {};
  const bool known = ::fstat(fd, &state) == 0;
  const bool extended =
      known && (static_cast<haddr_t>(state.st_size) >= end || ::ftruncate(fd, static_cast<off_t>(end)) == 0);
  if (!extended || ::pwrite(fd, &end, sizeof end, end_of_file_address) != static_cast<ssize_t>(sizeof end)) {
    throw std::runtime_error(
        fmt::format("{}: cannot extend the file: {}", file.string(), std::generic_category().message(errno)));
  }
  checked(H5Fflush(open_file.get(), H5F_SCOPE_GLOBAL), file, "flush");
}

void publish_draft(const Handle& open_file, const std::filesystem::path& file) {
  flush_file(open_file, file);
  if (std::rename(draft_of(file).c_str(), file.c_str()) != 0) {
    throw std::runtime_error(
        fmt::format("cannot write {}: {}", file.string(), std::generic_category().message(errno)));
  }
}

void WriteGuard::refuse_further_writes(const Handle& open_file) {
  void* descriptor = nullptr;
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (nothing >= 0 && H5Fget_vfd_handle(open_file.get(), H5P_DEFAULT, &descriptor) >= 0) {
    ::dup2(nothing, *static_cast<int*>(descriptor));
  }
  ::close(nothing);
}

} // namespace tremolo::results
