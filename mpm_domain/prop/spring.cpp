#include "mpm_domain/prop/spring.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

void require_positive(const Prop& prop, const char* what, double value, const char* unit) {
  if (!(value > 0.0) || !std::isfinite(value))
    throw std::invalid_argument(fmt::format("prop '{}' has a {} of {:.6g} {}; allowed: positive and finite",
                                            prop.name, what, value, unit));
}

} // namespace

Spring::Spring(const Prop& prop) : stiffness_(prop.stiffness), yield_(prop.yield), bears_(prop.bears) {
  require_positive(prop, "stiffness", stiffness_, "N/m2");
  if (yield_)
    require_positive(prop, "yield force", *yield_, "N/m");
  const double prestress = prop.prestress.value_or(0.0);
  if (!(std::abs(prestress) <= yield_.value_or(std::abs(prestress))) || borne(prestress) != prestress)
    throw std::invalid_argument(
        fmt::format("prop '{}' has a prestress of {:.6g} N/m, which it does not bear", prop.name, prestress));
  stretch_ = prestress / stiffness_;
}

double Spring::borne(double force) const {
  if (bears_ == Bears::tension)
    return std::max(force, 0.0);
  return bears_ == Bears::compression ? std::min(force, 0.0) : force;
}

double Spring::force() const {
  return jack_.value_or(borne(stiffness_ * stretch_));
}

double Spring::stored() const {
  const double force = borne(stiffness_ * stretch_);
  return 0.5 * force * force / stiffness_;
}

SpringWork Spring::part(double way) {
  if (jack_)
    return {};
  const double before = stored();
  stretch_ += way;
  double plastic = 0.0;
  if (yield_) {
    const double bound = *yield_ / stiffness_;
    const double least = bears_ == Bears::tension ? std::min(stretch_, 0.0) : -bound;
    const double largest = bears_ == Bears::compression ? std::max(stretch_, 0.0) : bound;
    const double elastic = std::clamp(stretch_, least, largest);
    plastic = std::abs(stretch_ - elastic);
    stretch_ = elastic;
  }
  return {stored() - before, plastic * yield_.value_or(0.0)};
}

void Spring::lock() {
  if (jack_)
    stretch_ = *jack_ / stiffness_;
  jack_.reset();
}

} // namespace tremolo::mpm_domain
