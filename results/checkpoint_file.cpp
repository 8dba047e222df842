#include "results/checkpoint_file.hpp"

#include "results/hdf5/array_in_pieces.hpp"
#include "results/hdf5/hdf5_read.hpp"

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

/// @param give  passes all values to `take`, piece by piece
template <class Number>
void write_checked(Place place, const std::string& name, hid_t type, hsize_t size,
                   const GiveNumbers<Number>& give) {
  ArrayInPieces array(place, name, type, {&size, 1}, {.chunk_rows = size > 0 ? chunk_values : 0});
  give([&](std::span<const Number> piece) { array.add(piece.data(), piece.size()); });
  array.finish({});
}

/// Passes on all values at once.
template <class Number>
GiveNumbers<Number> all_of(std::span<const Number> values) {
  return [values](const auto& take) { take(values); };
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
  write_numbers(name, values.size(), all_of(values));
}

void CheckpointWriter::write(const std::string& name, std::span<const std::uint64_t> values) {
  write_integers(name, values.size(), all_of(values));
}

void CheckpointWriter::write_numbers(const std::string& name, std::size_t size,
                                     const GiveNumbers<double>& give) {
  implementation_->guarded([&](Place root) { write_checked(root, name, H5T_NATIVE_DOUBLE, size, give); });
}

void CheckpointWriter::write_integers(const std::string& name, std::size_t size,
                                      const GiveNumbers<std::uint64_t>& give) {
  implementation_->guarded([&](Place root) { write_checked(root, name, H5T_NATIVE_UINT64, size, give); });
}

void CheckpointWriter::write_text(const std::string& name, std::string_view text) {
  implementation_->guarded([&](Place root) {
    write_checked(root, name, H5T_NATIVE_CHAR, text.size(), all_of(std::span<const char>(text)));
  });
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

  template <class Number>
  std::vector<Number> part(const std::string& name, hid_t type, std::size_t first, std::size_t count) const {
    return source.rows<Number>(source.dataset(name), type, first, count, name);
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

std::vector<double> CheckpointReader::numbers(const std::string& name, std::size_t first,
                                              std::size_t count) const {
  return implementation_->part<double>(name, H5T_NATIVE_DOUBLE, first, count);
}

std::vector<std::uint64_t> CheckpointReader::integers(const std::string& name, std::size_t first,
                                                      std::size_t count) const {
  return implementation_->part<std::uint64_t>(name, H5T_NATIVE_UINT64, first, count);
}

std::size_t CheckpointReader::size(const std::string& name) const {
  const Handle data = implementation_->source.dataset(name);
  const Handle space(H5Dget_space(data.get()), H5Sclose);
  return static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get()));
}

std::string CheckpointReader::text(const std::string& name) const {
  const auto characters = implementation_->values<char>(name, H5T_NATIVE_CHAR);
  return {characters.begin(), characters.end()};
}

} // namespace tremolo::results
