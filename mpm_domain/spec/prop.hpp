#pragma once

#include "base/vector.hpp"
#include "base/words.hpp"

#include <optional>
#include <string>

namespace tremolo::mpm_domain {

/// The forces that a prop can bear.
enum class Bears { both, tension, compression };
constexpr auto words(Bears) {
  return word_table<Bears>(
      {{Bears::both, "both"}, {Bears::tension, "tension"}, {Bears::compression, "compression"}});
}

/// Fastening of an end of a prop.
struct PropFastening {
  std::string structure; ///< its name; empty: the ground
  Vector position;       ///< at the start, m
};

/// A spring between two points of structures and ground (prop/spring.hpp). Forces are per metre out of plane,
/// tension positive.
struct Prop {
  std::string name;
  PropFastening from;
  PropFastening to;
  double stiffness = 0.0;               ///< k, N/m2
  std::optional<double> prestress = {}; ///< N at the end of the stage in which it comes, N/m; none: it comes
                                        ///< without a force, and bears what that stage brings
  std::optional<double> yield = {};     ///< largest |N|, N/m; none: elastic
  Bears bears = Bears::both;
};

} // namespace tremolo::mpm_domain
