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

void LeaningSides::find(const Ground& ground, std::span<const BoundaryFace> faces,
                        std::span<const FaceSoil> soil, std::span<const eq6::FreeField> field) {
  edges_.clear();
  weights_.clear();
  FaceWeights at_line;
  for (std::size_t f = 0; f + 1 < faces.size(); ++f) {
    const std::size_t next = f + 1;
    const Side side = faces[f].side;
    if (side == Side::base || faces[next].side != side || faces[f].behind.is_tied)
      continue;
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

double LeaningSides::power(const Grid& grid) const {
  double sum = 0.0;
  for (std::size_t e = 0; e < edges_.size(); ++e)
    for (const auto& [node, w] : weights_[e])
      sum += w * (edges_[e].on_soil.x * mean(grid.vx_before[node], grid.vx_after[node]) +
                  edges_[e].on_soil.y * mean(grid.vy_before[node], grid.vy_after[node]));
  return sum;
}

} // namespace tremolo::mpm_domain
