#pragma once

#include <gsl/gsl_errno.h>

#include <memory>
#include <new>
#include <stdexcept>
#include <type_traits>

namespace tremolo::motion {

/// An object allocated by a function of GSL, with the function that frees it. From here on GSL returns a
/// status on failure, which check() tests; by default it ends the process.
/// @throws std::bad_alloc where there is not enough memory
template <class T, class... Sizes>
std::unique_ptr<T, void (*)(T*)> owned(T* (*allocate)(Sizes...), void (*release)(T*),
                                       std::type_identity_t<Sizes>... sizes) {
  [[maybe_unused]] static const auto before = gsl_set_error_handler_off();
  T* made = allocate(sizes...);
  if (made == nullptr)
    throw std::bad_alloc();
  return {made, release};
}

/// @throws std::bad_alloc where there is not enough memory, std::runtime_error where GSL fails otherwise
inline void check(int status) {
  if (status == GSL_ENOMEM)
    throw std::bad_alloc();
  if (status != GSL_SUCCESS)
    throw std::runtime_error(gsl_strerror(status));
}

} // namespace tremolo::motion
