#pragma once

#include "mpm_domain/boundary/layer/layer_joint.hpp"
#include "mpm_domain/boundary/layer/matched_layer.hpp"
#include "mpm_domain/boundary/support.hpp"

namespace tremolo::mpm_domain {

/// The matched layers of a domain, joined where they meet at a corner.
class MatchedLayers final : public Support {
public:
  static bool is_wanted(const Ground& ground);
  /// @throws std::invalid_argument as MatchedLayer does
  MatchedLayers(const Ground& ground, std::span<BoundaryFace> faces);

  std::string name() const override { return "matched layers"; }
  bool is_timed() const override { return true; }
  void exchange(const Exchange& at, std::span<SupportLoad> loads) override;
  void add_state(SavedNumbers& state) override;

private:
  /// Two layers and the corner between them.
  struct Corner {
    std::size_t side; ///< which of the layers
    std::size_t base;
    LayerJoint joint;
  };

  std::vector<MatchedLayer> layers_;
  std::vector<Corner> corners_;
};

} // namespace tremolo::mpm_domain
