#include "results/run_status.hpp"

#include <fmt/format.h>

namespace tremolo::results {
namespace {

constexpr std::size_t status_length = 512;

std::string padded(std::string_view status) {
  std::string text(status.substr(0, status_length - 1));
  text.resize(status_length, '\0');
  return text;
}

} // namespace

std::string aborted_status(std::string_view reason) {
  return fmt::format("aborted: {}", reason);
}

void create_status(Place root) {
  write_attribute(root, "status", padded(status_running));
}

void set_status(Place root, std::string_view status) {
  const Handle attribute(checked(H5Aopen(root.object, "status", H5P_DEFAULT), root.file, "open the status"),
                         H5Aclose);
  checked(H5Awrite(attribute.get(), string_type(status_length).get(), padded(status).data()), root.file,
          "write the status");
}

} // namespace tremolo::results
