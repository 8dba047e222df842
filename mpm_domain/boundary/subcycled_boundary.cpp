#include "mpm_domain/boundary/subcycled_boundary.hpp"

#include <algorithm>

namespace tremolo::mpm_domain {

namespace {

/// A node with less of a face is not touched by it: rounding of weights.
constexpr double negligible = 1e-12;

} // namespace

SubcycledBoundary::SubcycledBoundary(Domain& domain, const Subcycling& subcycling)
    : domain_(domain), subcycling_(subcycling), weights_(domain.faces.size()), scaled_(domain.faces.size()),
      steady_(domain.faces.size()), clock_(domain.faces.size()), v_exchange_(domain.faces.size()),
      v_(domain.faces.size()), v_mid_(domain.faces.size()), exchanged_(domain.faces.size()),
      traction_(domain.faces.size()), moving_(domain.faces.size()) {}

void SubcycledBoundary::hold(std::span<const Vector> velocities, std::span<const Vector> tractions) {
  v_exchange_.assign(velocities.begin(), velocities.end());
  exchanged_.assign(tractions.begin(), tractions.end());
}

/// The face's weights at its present place, and its clock at the first tick.
void SubcycledBoundary::weigh(std::size_t f) {
  const ClockNodes& nodes = subcycling_.nodes();
  face_weights(domain_, domain_.faces[f], weights_[f]);
  std::erase_if(weights_[f],
                [&](const FaceWeight& w) { return w.w < negligible || nodes.clock_of(w.node) < 0; });
  if (subcycling_.tick() == 0) {
    clock_[f] = domain_.clocks.count() - 1;
    for (const FaceWeight& w : weights_[f])
      clock_[f] = std::min(clock_[f], nodes.clock_of(w.node));
  }
  scaled_[f] = steady_[f] = weights_[f];
  // A node of a slower clock that the face has come to touch since the first tick waits for the next one.
  std::erase_if(scaled_[f], [&](const FaceWeight& w) { return nodes.clock_of(w.node) < clock_[f]; });
  for (FaceWeight& w : scaled_[f])
    w.w *= static_cast<double>(1 << (nodes.clock_of(w.node) - clock_[f]));
}

void SubcycledBoundary::spread() {
  for (std::size_t f = 0; f < weights_.size(); ++f) {
    weights_[f].clear();
    scaled_[f].clear();
    if (subcycling_.tick() == 0 || clock_[f] >= subcycling_.first_due())
      weigh(f);
  }
  face_velocities(domain_, weights_, v_);
  for (std::size_t f = 0; f < weights_.size(); ++f) {
    const Vector more = {v_[f].x - v_exchange_[f].x, v_[f].y - v_exchange_[f].y};
    const Vector viscous = eq6::viscous_traction(domain_.faces[f].face, more);
    traction_[f] = {exchanged_[f].x + viscous.x, exchanged_[f].y + viscous.y};
    const Vector held = domain_.static_tractions[f];
    moving_[f] = {traction_[f].x - held.x, traction_[f].y - held.y};
  }
  spread_tractions(domain_, scaled_, moving_);
  spread_static();
}

/// Static tractions act at every tick of a node, like the steady forces of the soil that they hold.
void SubcycledBoundary::spread_static() {
  Grid& grid = domain_.grid;
  for (std::size_t f = 0; f < steady_.size(); ++f) {
    const Vector held = domain_.static_tractions[f];
    const double share = subcycling_.steady_share(clock_[f]) * domain_.faces[f].length;
    for (const auto& [node, w] : steady_[f]) {
      if (subcycling_.nodes().clock_of(node) < subcycling_.first_due())
        continue;
      grid.force_x[node] += share * w * held.x;
      grid.force_y[node] += share * w * held.y;
    }
  }
}

void SubcycledBoundary::book() {
  face_mid_velocities(domain_, weights_, v_mid_);
  for (std::size_t f = 0; f < weights_.size(); ++f)
    if (!weights_[f].empty())
      book_face_work(domain_, f, subcycling_.kick_of(clock_[f]),
                     eq6::viscous_traction(domain_.faces[f].face, v_[f]), traction_[f], v_mid_[f]);
}

} // namespace tremolo::mpm_domain
