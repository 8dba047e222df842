#pragma once

#include <string_view>

namespace tremolo::materials {

/// Kind of a law's response to loading, which determines the state of a point and the cost of a step.
enum class Response {
  elastic,        ///< linear, no memory
  plastic,        ///< elastic inside a yield surface
  hysteretic,     ///< loops from the smallest strain on
  cyclic_mobility ///< loops that build up pore pressure
};

/// Properties of a law that the rest of the program needs without knowing which law it is.
struct Traits {
  std::string_view name; ///< in messages, e.g. "linear_elastic"
  Response response = Response::elastic;
  bool three_dimensional = true; ///< takes strain out of plane (Points::dezz)
  /// Rate at which strength falls with plastic strain, 1; 0: it does not. It goes with the cell size.
  double softening = 0.0;
  bool follows_pressure = false;         ///< stiffness goes with effective stress and is nothing without it
  bool remembers_initial_stress = false; ///< memory begins with the stress that initialise() finds
  bool reconsolidates = false;           ///< after_shaking() is another law
  bool total_stress = false;             ///< strength follows no effective stress; pore pressure has no say
  bool unlimited_tension = false;        ///< carries any tension
  bool in_plane = false;                 ///< its p and q are those of the plane, not of the three axes
  double least_pressure = 0.0; ///< Pa, at which the law holds a mean effective stress that is smaller
};

} // namespace tremolo::materials
