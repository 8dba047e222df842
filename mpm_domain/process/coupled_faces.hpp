#pragma once

// The domain's faces as the coupler knows them: those of sides that are tied to each other it does not know;
// those of a base that is blended from two free fields it knows twice, once with each. Eq. (6) is affine in
// the free field, so that with the same v^m
//
//     t = (1 - s) t_left + s t_right,      s from 0 at the left side to 1 at the right one,
//
// is the traction of the blended field.

#include "coupler/participant.hpp"
#include "mpm_domain/domain.hpp"
#include "scene/plan/plan.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

class CoupledFaces {
public:
  /// @param first of the domain's faces that a free field drives
  CoupledFaces(const Domain& domain, const scene::Case& scene, const scene::Plan& plan, std::size_t first);

  /// As they are announced.
  const std::vector<coupler::ExchangedFace>& faces() const { return faces_; }
  /// Who drives each of the domain's faces, those of tied sides too.
  std::vector<std::string> sources() const;

  /// Exchanges for one step. Spans are over all faces of the domain; those before the first stay as they are.
  /// @returns seconds spent waiting so far
  double exchange(coupler::DomainClient& client, std::uint64_t step, double time, std::span<const Vector> v,
                  std::span<Vector> traction, std::span<eq6::FreeField> field);

private:
  std::size_t first_;
  std::size_t single_ = 0;     ///< faces without the second ones of the base
  std::vector<double> shares_; ///< s of the base's faces, where it is blended
  std::vector<coupler::ExchangedFace> faces_;
  std::vector<Vector> v_, traction_;
};

} // namespace tremolo::mpm_domain
