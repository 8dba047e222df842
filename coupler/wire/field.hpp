#pragma once

// Data exchanged between participants, in terms of the physics: the free-field motion that a source serves
// along a vertical profile, and the boundary faces of the domain that take it.
//
// A source serves the motion on ONE vertical line. Along x the motion is the same, later by the horizontal
// slowness p = sin(angle) / c:
//
//     v(x, y, t) = v(x_reference, y, t - p (x - x_reference))      and the same for the stress.

#include "coupler/eq6/boundary_traction.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::coupler {

/// Values per point and step: vx, vy (m/s), sxx, syy, sxy (Pa, dynamic part, tension positive), then the time
/// derivatives of these five (m/s2, Pa/s).
inline constexpr std::size_t values_per_point = 10;

/// One free field that a source serves.
struct FieldDescription {
  /// "total" (free field with its free surface) or "incident" (the upgoing wave alone). A plane wave of
  /// another slowness is a field of its own, "total+vertical": it adds to "total".
  std::string name;
  /// Elevations of the points served, ascending, m. Where materials meet, a level may stand twice: the first
  /// point holds the limit from below, the second the one from above.
  std::vector<double> y;
  double x_reference = 0.0;     ///< x of the profile, m
  double slowness_x = 0.0;      ///< horizontal slowness p, s/m; 0 for a column
  double start_time = 0.0;      ///< time of step 0, s
  double time_step = 0.0;       ///< s
  std::uint64_t step_count = 0; ///< steps 0 ... step_count - 1 are served
  /// Steps that the source sends in one frame, as the hub says in WELCOME.
  std::uint32_t steps_per_frame = 1;

  [[nodiscard]] std::size_t values_per_step() const { return y.size() * values_per_point; }
  [[nodiscard]] double time(std::uint64_t step) const {
    return start_time + static_cast<double>(step) * time_step;
  }
  [[nodiscard]] double end_time() const { return time(step_count - 1); }
};

/// Whether a field is part of the sum that a face requests as `asked`: "total" and "total+vertical" for
/// "total".
bool adds_to(const FieldDescription& field, std::string_view asked);

/// Refuses a description that cannot be served: no points, elevations that descend or stand more than
/// twice, fewer than two steps,
/// anything not finite.
/// @throws std::invalid_argument naming the field, the key and its value
void validate(const FieldDescription& field);

inline constexpr std::uint32_t default_window_steps = 64;

/// Steps of a field in one frame: window_steps, but not more than 1 MiB. What is larger leaves the caches
/// before it is mapped.
std::uint32_t steps_per_frame(const FieldDescription& field, std::uint32_t window_steps);

/// A source and what it serves, as the domain and the hub know it after the handshake.
struct SourceDescription {
  std::string name;
  std::uint32_t number = 0; ///< the participant's number in this run, the sender in its frames
  std::vector<FieldDescription> fields;
};

/// A boundary face of the domain. It keeps its material position: the free field does not move with the soil.
struct ExchangedFace {
  eq6::Vector position;        ///< centre, m
  eq6::Face dashpot;           ///< outward normal and impedances
  eq6::Vector static_traction; ///< what held the model at rest, Pa
  std::string source;          ///< name of the source it takes its free field from
  std::string field;           ///< which of that source's fields

  /// Eq. (6) there, Pa.
  eq6::Vector traction(eq6::Vector v_domain, const eq6::FreeField& free_field) const {
    return eq6::boundary_traction(dashpot, v_domain, free_field, static_traction).total();
  }
};

} // namespace tremolo::coupler
