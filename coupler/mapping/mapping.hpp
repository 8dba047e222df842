#pragma once

// Mapping of a source's free field to a face, in depth and time.
//
// In depth: cubic Hermite between the source's points y_j with three-point finite-difference slopes
// (one-sided at the ends). All of it is linear in the point values, so a face at y is a fixed sum over at
// most four points,
//
//     f(y, t) = sum_k w_k f(y_k, t),     exact for polynomials of degree 2 in y, third order otherwise.
//
// Where materials meet, s_xx and the gradients of the velocity jump. A source lists such a level twice, and
// the mapping never reaches across: points and slopes are those of the face's own layer. A face exactly on an
// interface takes the limit from above: the faces of a base that lies on one belong to the soil above it.
//
// In time: cubic Hermite from the values and time derivatives that sources send, on [t_i, t_i+1] with s = (t
// - t_i)/dt,
//
//     f(t) = (1 + 2 s)(1 - s)^2 f_i + s (1 - s)^2 dt f'_i + s^2 (3 - 2 s) f_i+1 + s^2 (s - 1) dt f'_i+1,
//
// fourth order. A face at x takes the field at its local time t - p (x - x_reference).

#include "coupler/wire/field.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tremolo::coupler {

/// Points at which a face reads a field, computed once since faces keep their material position.
struct FaceMap {
  std::size_t first_point = 0;
  std::size_t points = 0; ///< 1 to 4
  std::array<double, 4> weights{};
  double delay = 0.0; ///< s, p (x - x_reference)
};

/// Number of components served at a point: velocity x and y, stress xx, yy and xy.
inline constexpr std::size_t components = values_per_point / 2;

/// The sum over a face's points.
/// @param points components of each, the face's first point first
inline eq6::FreeField in_depth(const FaceMap& face, const double* points) {
  std::array<double, components> sum{};
  for (std::size_t k = 0; k < face.points; ++k)
    for (std::size_t c = 0; c < components; ++c)
      sum[c] += face.weights[k] * points[components * k + c];
  return {{sum[0], sum[1]}, {sum[2], sum[3], sum[4]}};
}

/// @throws std::invalid_argument if the face lies above or below the source's points by more than a
/// thousandth of their
///         range
FaceMap map_face(const FieldDescription& field, eq6::Vector position);

/// The steps of one field that are still needed, in a ring of fixed capacity.
class FreeFieldHistory {
public:
  /// @param delays of the earliest and the latest face, s
  /// @param look_ahead steps that may be held beyond what the faces need at one time
  FreeFieldHistory(FieldDescription field, double least_delay, double largest_delay,
                   std::uint64_t look_ahead);

  /// Appends whole steps, the first of which is next_step().
  /// @param values float64 as they lie in a frame, not aligned
  /// @throws std::length_error beyond the credit
  void append(std::span<const std::byte> values);

  /// Forgets the steps that no face needs from this time on.
  void release_before(double time);

  [[nodiscard]] const FieldDescription& field() const { return field_; }
  [[nodiscard]] std::uint64_t next_step() const { return next_step_; }

  /// Steps below this one have room.
  [[nodiscard]] std::uint64_t credit() const;

  /// The first step that is still missing to evaluate all faces at a time, if any.
  [[nodiscard]] std::optional<std::uint64_t> missing(double time) const;

  /// Steps that all faces need up to a time: those below this one.
  /// @throws std::out_of_range for a time outside the field
  [[nodiscard]] std::uint64_t needed_until(double time) const { return interval(time - least_delay_) + 2; }

  /// The field at some of its points in time.
  /// @param which numbers of the points
  /// @param points out: components of each
  /// @throws std::out_of_range for a local time outside the steps held
  void in_time(double local_time, std::span<const std::size_t> which, std::span<double> points) const;

  /// Free-field velocity and dynamic stress at a face.
  /// @throws as in_time
  [[nodiscard]] eq6::FreeField evaluate(const FaceMap& face, double time) const;

private:
  [[nodiscard]] std::uint64_t interval(double local_time) const;
  [[nodiscard]] const double* step(std::uint64_t number) const;

  FieldDescription field_;
  double least_delay_;
  double largest_delay_;
  std::uint64_t capacity_;
  std::uint64_t first_step_ = 0;
  std::uint64_t next_step_ = 0;
  std::vector<double> ring_;
};

} // namespace tremolo::coupler
