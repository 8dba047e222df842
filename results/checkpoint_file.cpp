#include "results/checkpoint_file.hpp"

#include "results/hdf5/hdf5_read.hpp"
#include "results/hdf5/hdf5_write.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace tremolo::results {
namespace {

constexpr std::string_view checkpoint_content = "checkpoint";
constexpr hsize_t chunk_values = 65536;

void write_checked(Place place, const std::string& name, hid_t type, hsize_t size, const void* values) {
  const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
  const Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  if (size > 0) {
    const hsize_t chunk = std::min(size, chunk_values);
    H5Pset_chunk(properties.get(), 1, &chunk);
    H5Pset_fletcher32(properties.get());
  }
  const std::string action = "write " + name;
  const Handle dataset(checked(H5Dcreate2(place.object, name.c_str(), type, space.get(), H5P_DEFAULT,
                                          properties.get(), H5P_DEFAULT),
                               place.file, action),
                       H5Dclose);
  if (size > 0) {
    checked(H5Dwrite(dataset.get(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values), place.file, action);
  }
}

} // namespace

void sync_to_disk(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool synced = descriptor >= 0 && ::fsync(descriptor) == 0;
  const int reason = errno;
  if (descriptor >= 0) {
    ::close(descriptor);
  }
  if (!synced) {
    throw std::runtime_error(fmt::format("{}: cannot bring it to the disk: {}", path.string(),
                                         std::generic_category().message(reason)));
  }
}

std::filesystem::path set_aside(const std::filesystem::path& file) {
  std::filesystem::path before = file;
  before += ".before";
  if (!std::filesystem::exists(before) && std::rename(file.c_str(), before.c_str()) != 0) {
    throw std::runtime_error(
        fmt::format("cannot take over {}: {}", file.string(), std::generic_category().message(errno)));
  }
  return before;
}

class CheckpointWriter::Implementation {
public:
  explicit Implementation(const std::filesystem::path& path) : path_(path), file_(create_file(path_)) {}

  template <class Action>
  void guarded(Action action) {
    guard_(file_, [&] { action(Place{file_.get(), path_}); });
  }

  void close() {
    guarded([&](Place) { flush_file(file_, path_); });
    file_ = Handle();
    sync_to_disk(path_);
  }

private:
  std::filesystem::path path_;
  Handle file_;
  WriteGuard guard_;
};

CheckpointWriter::CheckpointWriter(const std::filesystem::path& file, const CheckpointIdentity& identity)
    : implementation_(std::make_unique<Implementation>(file)) {
  implementation_->guarded([&](Place root) {
    write_attribute(root, "content", std::string(checkpoint_content));
    write_attribute(root, "schema_version", std::string(checkpoint_schema_version));
    write_attribute(root, "participant", identity.participant);
    write_attribute(root, "case", identity.case_crc);
    write_attribute(root, "step", std::to_string(identity.step));
  });
}

CheckpointWriter::~CheckpointWriter() = default;

void CheckpointWriter::write(const std::string& name, std::span<const double> values) {
  implementation_->guarded(
      [&](Place root) { write_checked(root, name, H5T_NATIVE_DOUBLE, values.size(), values.data()); });
}

void CheckpointWriter::write(const std::string& name, std::span<const std::uint64_t> values) {
  implementation_->guarded(
      [&](Place root) { write_checked(root, name, H5T_NATIVE_UINT64, values.size(), values.data()); });
}

void CheckpointWriter::write_text(const std::string& name, std::string_view text) {
  implementation_->guarded(
      [&](Place root) { write_checked(root, name, H5T_NATIVE_CHAR, text.size(), text.data()); });
}

void CheckpointWriter::close() {
  implementation_->close();
}

class CheckpointReader::Implementation {
public:
  Implementation(const std::filesystem::path& file, const CheckpointIdentity& expected)
      : source(file, "checkpoint") {
    for (const auto& [name, wanted] : {std::pair<std::string, std::string>{"content", checkpoint_content},
                                       {"schema_version", std::string(checkpoint_schema_version)},
                                       {"participant", expected.participant},
                                       {"case", expected.case_crc},
                                       {"step", std::to_string(expected.step)}}) {
      const auto found = source.attribute_as<std::string>("/", name);
      if (found != wanted) {
        throw std::runtime_error(fmt::format("{}: the checkpoint has {} = {}, this run has {}", file.string(),
                                             name, found, wanted));
      }
    }
  }

  template <class Number>
  std::vector<Number> values(const std::string& name, hid_t type) const {
    const Handle data = source.dataset(name);
    return source.numbers<Number>(data.get(), type, name);
  }

  FileReader source;
};

CheckpointReader::CheckpointReader(const std::filesystem::path& file, const CheckpointIdentity& expected)
    : implementation_(std::make_unique<Implementation>(file, expected)) {}

CheckpointReader::~CheckpointReader() = default;

std::vector<double> CheckpointReader::numbers(const std::string& name) const {
  return implementation_->values<double>(name, H5T_NATIVE_DOUBLE);
}

std::vector<std::uint64_t> CheckpointReader::integers(const std::string& name) const {
  return implementation_->values<std::uint64_t>(name, H5T_NATIVE_UINT64);
}

std::string CheckpointReader::text(const std::string& name) const {
  const auto characters = implementation_->values<char>(name, H5T_NATIVE_CHAR);
  return {characters.begin(), characters.end()};
}

} // namespace tremolo::results
