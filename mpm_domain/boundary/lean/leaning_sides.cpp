#include "mpm_domain/boundary/lean/leaning_sides.hpp"

#include "mpm_domain/ground.hpp"

namespace tremolo::mpm_domain {

namespace {

double mean(double a, double b) {
  return 0.5 * (a + b);
}

LeaningEdge loads(double normal, const FaceSoil& below, const FaceSoil& above, const eq6::Stress& field_below,
                  const eq6::Stress& field_above) {
  const double turned = -normal * (above.moved - below.moved);
  return {{turned * mean(field_below.xy, field_above.xy), turned * mean(below.syy, above.syy)},
          -turned * mean(below.excess, above.excess)};
}

} // namespace

void LeaningSides::find(const Ground& ground, std::span<const BoundaryFace> faces, const NearFaces& near,
                        std::span<const FaceSoil> soil, std::span<const eq6::FreeField> field) {
  edges_.clear();
  weights_.clear();
  counts_.clear();
  FaceWeights at_line;
  for (std::size_t n = 0; n + 1 < near.all().size(); ++n) {
    const std::size_t f = near.all()[n];
    const std::size_t next = near.all()[n + 1];
    const Side side = faces[f].side;
    if (next != f + 1 || side == Side::base || faces[next].side != side || faces[f].behind.is_tied)
      continue;
    counts_.push_back(ground.sets[faces[f].set].index_of[faces[f].id] != Particles::nowhere);
    edges_.push_back(
        loads(faces[f].ground.normal.x, soil[f], soil[next], field[f].stress, field[next].stress));
    const FacePosition& below = soil[f].position;
    const FacePosition& above = soil[next].position;
    const double y = mean(below.centre.y + below.half.y, above.centre.y - above.half.y);
    FaceWeights& weights = weights_.emplace_back();
    for (const std::size_t face : {f, next}) {
      const FacePosition& position = soil[face].position;
      face_weights(ground, faces[face], {{position.centre.x, y}, {position.half.x, 0.0}}, at_line);
      for (const auto& [node, w] : at_line)
        weights.push_back({node, 0.5 * w});
    }
  }
}

ExactSum LeaningSides::work(const Grid& grid, double kick) const {
  ExactSum work;
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    if (!counts_[e])
      continue;
    double power = 0.0;
    for (const auto& [node, w] : weights_[e])
      power += w * (edges_[e].on_soil.x * mean(grid.vx_before[node], grid.vx_after[node]) +
                    edges_[e].on_soil.y * mean(grid.vy_before[node], grid.vy_after[node]));
    work.add(kick * power);
  }
  return work;
}

} // namespace tremolo::mpm_domain
