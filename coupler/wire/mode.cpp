#include "coupler/wire/mode.hpp"

#include <fmt/format.h>
#include <stdexcept>

namespace tremolo::coupler {

std::string_view name(Mode mode) {
  return mode == Mode::lockstep ? "lockstep" : "window";
}

Mode mode_from(std::string_view name) {
  if (name == "lockstep")
    return Mode::lockstep;
  if (name == "window")
    return Mode::window;
  throw std::invalid_argument(fmt::format("mode '{}' does not exist, expected lockstep or window", name));
}

} // namespace tremolo::coupler
