#include "results/hdf5/hdf5_handle.hpp"

#include "results/run_file.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace tremolo::results {
namespace {

herr_t keep_description(unsigned /*n*/, const H5E_error2_t* error, void* reason) {
  if (error->desc != nullptr) {
    *static_cast<std::string*>(reason) = error->desc;
  }
  return 1; // the first one walked is the innermost: stop there
}

/// The system's own words where the failure came from it, e.g. "No space left on device".
std::string system_message(const std::string& description) {
  constexpr std::string_view key = "error message = '";
  const auto start = description.find(key);
  if (start == std::string::npos) {
    return description;
  }
  const auto end = description.find('\'', start + key.size());
  return description.substr(start + key.size(), end - start - key.size());
}

} // namespace

void prepare_hdf5() {
  // Everything is closed by its handle. What could not be closed, because the disk is full or the file
  // damaged, would make the library's own clean-up at exit crash. The first call of all must be this one.
  H5dont_atexit();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

void throw_hdf5_error(const std::filesystem::path& file, std::string_view action) {
  std::string reason = "unknown HDF5 error";
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_description, &reason);
  throw std::runtime_error(fmt::format("{}: cannot {}: {}", file.string(), action, system_message(reason)));
}

} // namespace tremolo::results
