#include "base/require.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

namespace tremolo {

std::string shortest(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

void require(bool condition, std::string_view what, double value, std::string_view allowed) {
  if (!condition)
    throw std::invalid_argument(std::string(what) + " is " + shortest(value) + ", must be " +
                                std::string(allowed));
}

void require_positive(std::string_view what, double value, std::string_view unit) {
  require(value > 0.0 && std::isfinite(value), what, value, "positive and finite, in " + std::string(unit));
}

} // namespace tremolo
