#pragma once

// What stands behind faces, moved by a test instead of by the steps of a domain.

#include "mpm_domain/domain.hpp"

#include <span>
#include <vector>

namespace tremolo::test_support {

template <class Kind>
class SupportByHand {
public:
  /// Behind faces that have dashpots and nothing else, as if the domain were of this spec.
  explicit SupportByHand(const mpm_domain::Spec& spec)
      : domain_(bare(spec)), support_(as_if(spec), faces()), loads_(faces().size()) {}

  mpm_domain::Domain& domain() { return domain_; }
  std::span<mpm_domain::BoundaryFace> faces() { return domain_.boundary.faces(); }
  Kind* operator->() { return &support_; }
  /// Goes on to a time (s) in which the soil at the faces has moved with v (m/s), in a free field of then.
  std::span<const mpm_domain::SupportLoad> move(double time, std::span<const Vector> v,
                                                std::span<eq6::FreeField> field) {
    support_.exchange({domain_, domain_.workers, faces(), {}, time, 0.0, v, v, v, field}, loads_);
    return loads_;
  }

private:
  static mpm_domain::Spec bare(mpm_domain::Spec spec) {
    spec.springs.clear();
    spec.matched_sides.clear();
    spec.sides = mpm_domain::Sides::free_field;
    spec.scheme.dispersion = mpm_domain::Dispersion::plain;
    return spec;
  }
  const mpm_domain::Ground& as_if(const mpm_domain::Spec& spec) {
    domain_.spec = spec;
    return domain_;
  }

  mpm_domain::Domain domain_;
  Kind support_;
  std::vector<mpm_domain::SupportLoad> loads_;
};

} // namespace tremolo::test_support
