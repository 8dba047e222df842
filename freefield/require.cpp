#include "freefield/require.hpp"

#include <sstream>
#include <stdexcept>

namespace tremolo::freefield {

std::string shortest(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

void require(bool condition, std::string_view what, double value, std::string_view allowed) {
  if (!condition) {
    throw std::invalid_argument(std::string(what) + " is " + shortest(value) + ", must be " +
                                std::string(allowed));
  }
}

} // namespace tremolo::freefield
