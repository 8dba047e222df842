#include "mpm_domain/boundary/layer/matched_layers.hpp"

#include "mpm_domain/ground.hpp"

namespace tremolo::mpm_domain {

bool MatchedLayers::is_wanted(const Ground& ground) {
  return !ground.spec.matched_sides.empty();
}

MatchedLayers::MatchedLayers(const Ground& ground, std::span<BoundaryFace> faces) {
  for (const Side side : ground.spec.matched_sides)
    layers_.emplace_back(ground, faces, side);
  for (std::size_t s = 0; s < layers_.size(); ++s)
    for (std::size_t b = 0; b < layers_.size(); ++b)
      if (layers_[s].side() != Side::base && layers_[b].side() == Side::base)
        corners_.push_back({s, b, LayerJoint(layers_[s].side(), layers_[s].lattice(), layers_[b].lattice())});
  for (MatchedLayer& layer : layers_)
    layer.lump(faces);
}

void MatchedLayers::exchange(const Exchange& at, std::span<SupportLoad> loads) {
  for (MatchedLayer& layer : layers_)
    layer.follow(at.seen_mean, at.field);
  at.workers.run(corners_.size(), [&](std::size_t c) { // each leads an end of its own of the base's layer
    auto& [s, b, joint] = corners_[c];
    if (const std::optional<double> dt = layers_[b].step_to(at.time))
      joint.advance(*dt, layers_[s].end_velocity(0), layers_[b].end_velocity(joint.base_end()),
                    layers_[s].lattice(), layers_[b].lattice());
  });
  for (MatchedLayer& layer : layers_)
    layer.advance(at.time, at.workers);
  for (const auto& [s, b, joint] : corners_)
    joint.pull(layers_[s].lattice(), layers_[b].lattice());
  for (MatchedLayer& layer : layers_)
    layer.react(at.time, at.field, loads);
}

void MatchedLayers::add_state(SavedNumbers& state) {
  for (MatchedLayer& layer : layers_)
    layer.add_state(state);
  for (Corner& corner : corners_)
    corner.joint.add_state(state);
}

} // namespace tremolo::mpm_domain
