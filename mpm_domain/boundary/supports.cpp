#include "mpm_domain/boundary/supports.hpp"

#include "mpm_domain/boundary/base/rigid_base.hpp"
#include "mpm_domain/boundary/closing/closing_elements.hpp"
#include "mpm_domain/boundary/layer/matched_layers.hpp"
#include "mpm_domain/boundary/springs/ground_springs.hpp"
#include "mpm_domain/boundary/tied/periodic_springs.hpp"
#include "mpm_domain/ground.hpp"

#include <array>

namespace tremolo::mpm_domain {

namespace {

/// A kind of support.
struct Kind {
  bool (*is_wanted)(const Ground&);
  std::unique_ptr<Support> (*make)(const Ground&, std::span<BoundaryFace>);
};

template <class Made>
constexpr Kind kind() {
  return {Made::is_wanted, [](const Ground& ground, std::span<BoundaryFace> faces) {
            return std::unique_ptr<Support>(std::make_unique<Made>(ground, faces));
          }};
}

/// In the order in which they claim faces: springs stand beside dashpots, which closing elements replace.
constexpr std::array kinds{kind<RigidBase>(), kind<MatchedLayers>(), kind<PeriodicSprings>(),
                           kind<GroundSprings>(), kind<ClosingElements>()};

} // namespace

FaceSupports::FaceSupports(const Ground& ground, std::span<BoundaryFace> faces) : loads_(faces.size()) {
  for (const auto& [is_wanted, make] : kinds)
    if (is_wanted(ground))
      all_.push_back(make(ground, faces));
}

void FaceSupports::follow_sort(const Ground& ground) {
  for (const auto& support : all_)
    support->follow_sort(ground);
}

double FaceSupports::work() const {
  double sum = 0.0;
  for (const auto& support : all_)
    sum += support->work();
  return sum;
}

} // namespace tremolo::mpm_domain
