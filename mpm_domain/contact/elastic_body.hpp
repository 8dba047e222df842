#pragma once

// Properties of an elastic body, for contact and output, besides its particles: its surface, which moves with
// them, and its motion as a whole. With X_p, x_p positions at the start and now, measured from the centroids
// X_c, x_c,
//
//     x_c = sum m x / M,    V = sum m v / M,    omega = sum m (x_p cross (v_p - V)) / sum m |x_p|^2,
//     tan theta = sum m X_p cross x_p / sum m X_p . x_p,
//
// theta being the rotation that fits all particles best (least squares). A point of the surface keeps its
// place beside the particle that was next to it at the start, turned by theta: what is missed is the strain
// and bending over less than a particle's size. So do points of the hole, which only pictures know.

#include "mpm_domain/contact/body_surface.hpp"
#include "mpm_domain/contact/rigid_body.hpp"
#include "mpm_domain/spec/structure.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

struct Particles;

class ElasticBody {
public:
  /// @param structure  that the particles fill
  /// @param number     of the body among the elastic ones: its index in Ground::bodies
  /// @param sets       of the body's particles, at their positions of the start
  /// @param spacing    largest distance of points of the surface, m
  ElasticBody(const Structure& structure, std::size_t number, std::span<const Particles> sets,
              double spacing);

  std::size_t number() const { return number_; }
  double mass() const { return mass_; } ///< of the particles, kg/m
  const BodySurface& surface() const { return surface_; }
  /// Points along the hole, m; none: it has no hole.
  const std::vector<Vector>& hole() const { return hole_; }

  /// Brings the surface, and position and motion of the body as a whole, to where particles are now.
  /// @param sets   as before
  /// @param whole  the body as it was at the start, if it were rigid; takes its motion
  void follow(std::span<const Particles> sets, RigidBody& whole);

private:
  /// A point of the surface, and the particle that it goes with.
  struct Follower {
    std::size_t set;
    std::uint32_t id;
    Vector offset; ///< from the particle at the start, m
  };

  /// The particles next to points at the start.
  static std::vector<Follower> followers(std::span<const Vector> points, std::span<const Particles> sets);
  /// Their positions after a rotation by an angle (rad).
  static std::vector<Vector> positions(std::span<const Follower> followers, std::span<const Particles> sets,
                                       double angle);

  std::size_t number_;
  double mass_ = 0.0;
  Vector start_; ///< X_c, m
  std::vector<Follower> of_surface_, of_hole_;
  BodySurface surface_;
  std::vector<Vector> hole_;
};

} // namespace tremolo::mpm_domain
