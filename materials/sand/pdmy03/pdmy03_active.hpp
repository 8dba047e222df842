#pragma once

// The active surfaces of four points, each with the next larger one. Points change surfaces one by one: a
// crossing or a reversal of one of them reads and writes the centres of that point alone.

#include "materials/sand/pdmy03/pdmy03_cone.hpp"
#include "materials/sand/pdmy03/pdmy03_state.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace tremolo::materials {

/// The centres of surfaces at rest of four points.
using RestingCentresOfFour = std::array<RestingCentres, 4>;

class ActiveSurfaces {
public:
  /// @param index  of the active surface of each point, 0 inside all of them; counts for the points of which
  /// @param centre  of that surface
  ActiveSurfaces(const Pdmy03& law, const RestingCentresOfFour& resting, const Lanes& index,
                 const Deviator3Of<Lanes>& centre, const LaneMask& which)
      : law_(law), resting_(resting), index_(choose(which, index, Lanes{})) {
    cone_.centre = centre;
    for (std::size_t lane = 0; lane < 4; ++lane)
      place_[lane] = static_cast<std::size_t>(index_[lane]);
    cone_.ratio = gathered(law.ratio);
    look_ahead();
  }

  const Lanes& index() const { return index_; }
  const YieldCones& cone() const { return cone_; }
  LaneMask inside_all() const { return index_ == 0.0; }
  LaneMask on_failure() const { return index_ == static_cast<double>(law_.surfaces); }

  /// H' and the elastoplastic modulus at the reference pressure, Pa.
  const Lanes& plastic_modulus() const { return plastic_modulus_; }
  Lanes tangent_modulus() const { return gathered(law_.tangent_modulus); }
  /// Half of H', on the failure surface of that of the surface before, Pa.
  const Lanes& least_modulus() const { return least_modulus_; }

  /// The surface that comes after the active one; of no meaning on the failure surface.
  const YieldCones& next() const { return next_; }

  /// The smallest surface.
  YieldCones core() const { return {all(law_.ratio[1]), centres({1, 1, 1, 1})}; }

  void move(const LaneMask& which, const Deviator3Of<Lanes>& centre) {
    cone_.centre = choose(which, centre, cone_.centre);
  }

  /// Activates the next surface.
  void advance(const LaneMask& which) {
    index_ = choose(which, index_ + 1.0, index_);
    for (std::size_t lane = 0; lane < 4; ++lane)
      place_[lane] += which[lane] != 0 ? 1 : 0;
    cone_.ratio = gathered(law_.ratio);
    cone_.centre = choose(which, next_.centre, cone_.centre);
    look_ahead();
  }

  /// Leaves the active surfaces: all smaller ones come to touch them where a stress is.
  void leave(const LaneMask& which, const Deviator3Of<Lanes>& s, const Lanes& height) {
    for (std::size_t lane = 0; lane < 4; ++lane) {
      if (which[lane] == 0)
        continue;
      const YieldCone cone = {cone_.ratio[lane], at(cone_.centre, lane)};
      for (std::size_t j = 1; j < place_[lane]; ++j)
        resting_[lane].set(j, cone.centre_inside(at(s, lane), height[lane], law_.ratio[j]));
      if (place_[lane] < law_.surfaces)
        resting_[lane].set(place_[lane], cone.centre);
      place_[lane] = 0;
    }
    index_ = choose(which, Lanes{}, index_);
    look_ahead();
  }

private:
  using Places = std::array<std::size_t, 4>;

  static Deviator3 at(const Deviator3Of<Lanes>& d, std::size_t lane) {
    return {d.a[lane], d.b[lane], d.c[lane]};
  }

  /// Centres of resting surfaces, one of each point.
  Deviator3Of<Lanes> centres(const Places& surface) const {
    const Deviator3 c0 = resting_[0][surface[0]];
    const Deviator3 c1 = resting_[1][surface[1]];
    const Deviator3 c2 = resting_[2][surface[2]];
    const Deviator3 c3 = resting_[3][surface[3]];
    return {Lanes{c0.a, c1.a, c2.a, c3.a}, Lanes{c0.b, c1.b, c2.b, c3.b}, Lanes{c0.c, c1.c, c2.c, c3.c}};
  }

  template <typename Table>
  Lanes gathered(const Table& table, const Places& places) const {
    return Lanes{table[places[0]], table[places[1]], table[places[2]], table[places[3]]};
  }
  template <typename Table>
  Lanes gathered(const Table& table) const {
    return gathered(table, place_);
  }

  /// Computes the values derived from the active surfaces.
  void look_ahead() {
    Places ahead, least;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      ahead[lane] = std::min(place_[lane] + 1, law_.surfaces);
      least[lane] = std::min(place_[lane], law_.surfaces - 1);
    }
    next_ = {gathered(law_.ratio, ahead), centres(ahead)};
    plastic_modulus_ = gathered(law_.plastic_modulus);
    least_modulus_ = 0.5 * gathered(law_.plastic_modulus, least);
  }

  const Pdmy03& law_;
  RestingCentresOfFour resting_;
  Lanes index_;  ///< of the active surfaces
  Places place_; ///< the same as whole numbers
  YieldCones cone_;
  YieldCones next_;
  Lanes plastic_modulus_{};
  Lanes least_modulus_{};
};

} // namespace tremolo::materials
