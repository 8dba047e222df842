#pragma once

// The domain's faces as the coupler knows them: those of sides that are tied to each other it does not know;
// those of a base that is blended from two free fields it knows twice, once with each, and
//
//     v^ff = (1 - s) v_left + s v_right,      sigma^ff likewise,      s from 0 at the left side to 1 at the
//     right.
//
// A base that takes the incident wave alone and has springs is exchanged once more: its springs move against
// the total field of the sides.

#include "coupler/participant.hpp"
#include "mpm_domain/domain.hpp"
#include "scene/plan/plan.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

class CoupledFaces {
public:
  CoupledFaces(const Domain& domain, const scene::Case& scene, const scene::Plan& plan);

  /// The faces as announced to the coupler.
  const std::vector<coupler::ExchangedFace>& faces() const { return faces_; }
  /// Who drives each of the domain's faces, those of tied sides too.
  std::vector<std::string> sources() const;

  /// Exchanges for one step. Spans are over all faces of the domain, of fields also over those that springs
  /// have to themselves; fields of tied sides stay as they are.
  /// @returns seconds spent waiting so far
  double exchange(coupler::DomainClient& client, std::uint64_t step, double time, std::span<const Vector> v,
                  std::span<eq6::FreeField> field);

private:
  /// A field of the domain, and the exchanged ones that it is blended from.
  struct Blend {
    std::size_t field;
    std::size_t left; ///< or the only one
    std::optional<std::size_t> right = {};
    double share = 0.0; ///< s
  };

  std::size_t announce(const Domain& domain, std::size_t face, const std::string& source, const char* field);
  void join(const Domain& domain, Blend& blend, const std::string& source);

  std::size_t tied_; ///< of the domain's faces: no free field drives them
  std::vector<Blend> blends_;
  std::vector<coupler::ExchangedFace> faces_;
  std::vector<std::size_t> domain_faces_; ///< of faces_
  std::vector<Vector> v_;
};

} // namespace tremolo::mpm_domain
