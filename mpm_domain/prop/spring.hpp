#pragma once

// The force N of a prop, tension positive, and its elastic stretch e,
//
//     N = k e,      |N| <= N_y,
//
// where e grows as the ends part. Beyond N_y the prop yields: e stays, and what the ends go further is
// plastic. A prop that bears tension alone is slack while e < 0, N = 0, and takes hold again where e = 0; one
// that bears compression alone likewise.
//
// The work of N as e changes is stored, k e^2/2 where the prop is not slack, and dissipated, N_y |de_p|.

#include "mpm_domain/spec/prop.hpp"

#include <optional>

namespace tremolo::mpm_domain {

/// Work on a prop, J/m.
struct SpringWork {
  double stored = 0.0;
  double dissipated = 0.0; ///< >= 0
};

class Spring {
public:
  /// It has the prestress.
  /// @throws std::invalid_argument for a stiffness or a yield force that is not positive, or a prestress that
  /// the prop cannot bear
  explicit Spring(const Prop& prop);

  double stiffness() const { return stiffness_; } ///< k, N/m2
  double force() const;                           ///< N, N/m
  double stretch() const { return stretch_; }     ///< e, m
  void set_stretch(double stretch) { stretch_ = stretch; }
  double stored() const; ///< J/m

  /// The ends part by a way (m).
  SpringWork part(double way);

  /// A jack holds the force (N/m), wherever the ends go.
  void jack(double force) { jack_ = force; }
  bool is_jacked() const { return jack_.has_value(); }
  /// The prop itself bears that force now.
  void lock();

private:
  double borne(double force) const;

  double stiffness_;
  std::optional<double> yield_;
  Bears bears_;
  double stretch_ = 0.0;
  std::optional<double> jack_; ///< N, N/m
};

} // namespace tremolo::mpm_domain
