#pragma once

#include "wavefield/layers/layered_field.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace tremolo::wavefield {

/// A field at very many times, in pieces one after the other, each of which needs but a part of the motion:
/// the memory of sampling it hardly goes with the length of the motion. The pieces agree with the whole to
/// 1e-6 of its peak. Where there are not many times, there is one piece, the field as it is.
class LongField {
public:
  /// @param points  where it will be sampled
  LongField(const LayeredField& field, std::span<const Point> points, const TimeGrid& times, Part part);

  /// The times of each piece.
  const std::vector<TimeGrid>& pieces() const { return pieces_; }

  /// Velocity, stress and their rates at some of the points: calls `take` with the number of each piece, from
  /// the first on, and the histories of the points on its times.
  /// @throws as LayeredField::sample()
  void sample(std::span<const Point> points,
              const std::function<void(std::size_t, const std::vector<History>&)>& take) const;

private:
  /// Times by which a field extends before and after its motion, s.
  struct Reach {
    double before = 0.0, after = 0.0;
  };
  static std::optional<Reach> reach_of(const LayeredField& pulse, std::span<const Point> points, double dt,
                                       Part part);
  std::vector<History> slow_part(std::span<const Point> points) const;

  LayeredField field_;
  TimeGrid times_;
  Part part_;
  std::vector<TimeGrid> pieces_;
  Reach reach_;
  double scale_ = 0.0;               ///< largest velocity of the motion, m/s
  double corner_ = 0.0;              ///< of its slow part, Hz
  std::optional<LayeredField> slow_; ///< of the motion's lowest frequencies, where the field has long tails
  TimeGrid slow_times_;
};

} // namespace tremolo::wavefield
