#include "wavefield/require.hpp"

#include <sstream>

namespace tremolo::wavefield {

std::string shortest(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

void require(bool condition, std::string_view what, double value, const std::string& allowed) {
  if (!condition) {
    throw std::invalid_argument(std::string(what) + " is " + shortest(value) + ", must be " + allowed);
  }
}

} // namespace tremolo::wavefield
