#include "mpm_domain/boundary/face_motion.hpp"

#include "mpm_domain/boundary/for_faces.hpp"
#include "mpm_domain/ground.hpp"

#include <array>

namespace tremolo::mpm_domain {

namespace {

/// A node with less of a face is not touched by it: rounding of weights.
constexpr double negligible = 1e-12;

/// v_f = sum_i W_if v_i, m/s.
template <typename OfNode>
Vector sum_over(const FaceWeights& weights, const OfNode& of_node) {
  Vector sum;
  for (const auto& [node, w] : weights) {
    const Vector v = of_node(node);
    sum.x += w * v.x;
    sum.y += w * v.y;
  }
  return sum;
}

/// Where water flows, dashpots act on the velocity of grains and water together, as does their implicit half
/// (water/mixture_kick.hpp): a dashpot on the grains alone could add energy.
Vector velocity_at(const Grid& grid, const FaceWeights& weights) {
  return sum_over(weights, [&](std::size_t node) { return grid.mixture_before(node); });
}

Vector velocity_after_at(const Grid& grid, const FaceWeights& weights) {
  return sum_over(weights, [&](std::size_t node) { return grid.mixture_after(node); });
}

} // namespace

FaceMotion::FaceMotion(std::size_t faces)
    : weights_(faces), clock_(faces), seen_(faces), seen_mean_(faces), mean_(faces), velocity_(faces),
      step_sums_(3 * faces) {}

/// The face's weights at the position of its soil, and at the first tick its clock.
void FaceMotion::weigh(Step& step, const BoundaryFace& face, std::size_t f, std::span<const FaceSoil> soil) {
  const Ground& ground = step.ground;
  FaceWeights& weights = weights_[f];
  if (soil.empty())
    face_weights(ground, face, weights);
  else
    face_weights(ground, face, soil[f].position, weights);
  if (step.ticks.clocks() == 1)
    return;
  std::erase_if(weights,
                [&](const FaceWeight& w) { return w.w < negligible || step.nodes.clock_of(w.node) < 0; });
  if (!step.ticks.is_first())
    return;
  clock_[f] = step.ticks.clocks() - 1;
  for (const FaceWeight& w : weights)
    clock_[f] = std::min(clock_[f], step.nodes.clock_of(w.node));
}

void FaceMotion::forget_weights() {
  for (FaceWeights& weights : weights_)
    weights.clear();
}

void FaceMotion::begin_step(Step& step, std::span<const BoundaryFace> faces, NearFaces& near,
                            std::span<const FaceSoil> soil) {
  for_faces(step.ground.workers, near.all().size(), [&](std::size_t n) {
    const std::size_t f = near.all()[n];
    weigh(step, faces[f], f, soil);
    const Vector v = velocity_at(step.ground.grid, weights_[f]);
    if (step.ticks.clocks() > 1)
      add_to_mean(f, v);
    seen_[f] = kicked_.empty() ? v : without_residual(v, {kicked_[2 * f], kicked_[2 * f + 1]});
    mean_[f] = step.ticks.clocks() > 1 ? take_mean(f) : v;
    seen_mean_[f] = step.ticks.clocks() > 1 ? mean_[f] : seen_[f]; // water knows one clock
  });
  // Dry faces see what they move with.
  const std::array<std::span<Vector>, 2> shared{seen_, mean_};
  if (near.share(step.ground, std::span(shared).first(kicked_.empty() ? 1 : 2))) {
    seen_mean_ = seen_;
    if (kicked_.empty())
      mean_ = seen_;
  }
  velocity_ = seen_;
}

void FaceMotion::go_on(Step& step, std::span<const BoundaryFace> faces, std::span<const FaceSoil> soil) {
  for_faces(step.ground.workers, faces.size(), [&](std::size_t f) {
    if (!is_due(step.ticks, f))
      return;
    weigh(step, faces[f], f, soil);
    velocity_[f] = velocity_at(step.ground.grid, weights_[f]);
    add_to_mean(f, velocity_[f]);
  });
}

void FaceMotion::see_kick(const Grid& grid, const NearFaces& near) {
  kicked_.resize(2 * weights_.size());
  for (const std::size_t f : near.all()) {
    const Vector v = velocity_after_at(grid, weights_[f]);
    kicked_[2 * f] = v.x;
    kicked_[2 * f + 1] = v.y;
  }
}

/// Adds a velocity (m/s) of the face at a tick to the mean over a step of clock 0.
void FaceMotion::add_to_mean(std::size_t f, Vector v) {
  const double weight = 1.0 / static_cast<double>(1 << clock_[f]);
  step_sums_[3 * f] += weight * v.x;
  step_sums_[3 * f + 1] += weight * v.y;
  step_sums_[3 * f + 2] += weight;
}

/// The mean, m/s; the next one begins.
Vector FaceMotion::take_mean(std::size_t f) {
  double* const sums = &step_sums_[3 * f];
  const Vector mean{sums[0] / sums[2], sums[1] / sums[2]};
  std::fill_n(sums, 3, 0.0);
  return mean;
}

} // namespace tremolo::mpm_domain
