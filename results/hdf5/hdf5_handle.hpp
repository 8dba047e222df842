#pragma once

// Ownership and errors of HDF5's C interface: a Handle closes what it owns, and a failing call becomes an
// exception that says which file, what was attempted, and the reason from the bottom of HDF5's error stack.

#include <hdf5.h>

#include <filesystem>
#include <string_view>
#include <utility>

namespace tremolo::results {

/// Owns one HDF5 identifier.
class Handle {
public:
  using Close = herr_t (*)(hid_t);

  Handle() = default;
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (id_ >= 0) {
      close_(id_);
    }
  }

  hid_t get() const { return id_; }

  /// Gives the identifier up without closing it.
  hid_t release() { return std::exchange(id_, -1); }

private:
  hid_t id_ = -1;
  Close close_ = nullptr;
};

/// Call it before HDF5 is used: the library then prints no errors of its own, and does nothing at exit.
void prepare_hdf5();

/// @throws std::runtime_error "FILE: cannot ACTION: REASON", with the reason taken from HDF5's error stack
[[noreturn]] void throw_hdf5_error(const std::filesystem::path& file, std::string_view action);

/// Passes a non-negative result of an HDF5 call through.
/// @throws std::runtime_error as throw_hdf5_error
template <class Result>
Result checked(Result result, const std::filesystem::path& file, std::string_view action) {
  if (result < 0) {
    throw_hdf5_error(file, action);
  }
  return result;
}

} // namespace tremolo::results
