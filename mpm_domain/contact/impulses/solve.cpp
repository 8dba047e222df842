// How contact finds the impulses at all nodes of all bodies (contact.hpp): body by body, each with the
// impulses of the others, in sweeps.

#include "mpm_domain/contact/contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

Vector added(const Vector& a, const Vector& b) {
  return {a.x + b.x, a.y + b.y};
}

} // namespace

std::vector<RigidMotion> Contact::trial_motions(double keep, double dt) const {
  std::vector<RigidMotion> trial;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const RigidBody& body = bodies_[b];
    const RigidMotion& u = body.motion();
    const RigidLoad on_body = load(b);
    trial.push_back({{keep * u.velocity.x + dt * on_body.force.x / body.mass(),
                      keep * u.velocity.y + dt * on_body.force.y / body.mass()},
                     keep * u.spin + dt * on_body.moment / body.inertia()});
  }
  return trial;
}

void Contact::find_shared() {
  for (std::vector<SharedNode>& of_body : shared_)
    of_body.clear();
  for (std::size_t a = 0; a < bodies_.size(); ++a)
    for (std::size_t b = a + 1; b < bodies_.size(); ++b) {
      const std::vector<ContactNode>& of_a = nodes(a);
      const std::vector<ContactNode>& of_b = nodes(b);
      for (std::size_t i = 0, j = 0; i < of_a.size() && j < of_b.size();) {
        if (of_a[i].node == of_b[j].node) {
          shared_[a].push_back({i, b, j});
          shared_[b].push_back({j, a, i});
        }
        of_a[i].node < of_b[j].node ? ++i : ++j;
      }
    }
}

/// One body with the impulses of the others; returns by how much its motion has changed, m/s.
double Contact::solve_body(std::size_t body, const RigidMotion& trial, bool bonded) {
  std::vector<ContactNode>& nodes = nodes_[body].nodes();
  std::vector<std::pair<Vector, Vector>> by_others(shared_[body].empty() ? 0 : nodes.size());
  for (const SharedNode& shared : shared_[body]) {
    const ContactNode& there = nodes_[shared.other].nodes()[shared.there];
    by_others[shared.at].first = added(by_others[shared.at].first, there.solid_change);
    by_others[shared.at].second = added(by_others[shared.at].second, there.water_change);
  }
  for (std::size_t n = 0; n < by_others.size(); ++n)
    nodes[n].set_trial(by_others[n].first, by_others[n].second);
  return elastic_[body] ? solve_elastic(body, bonded) : solve_rigid(body, trial, bonded);
}

double Contact::solve_rigid(std::size_t body, const RigidMotion& trial, bool bonded) {
  const RigidBody& b = bodies_[body];
  std::vector<ContactNode>& nodes = nodes_[body].nodes();
  std::vector<ContactPoint> points(nodes.begin(), nodes.end());
  const ContactSolution found = solve_contact(b.mass(), b.inertia(), trial, points, bonded);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    static_cast<ContactPoint&>(nodes[n]) = points[n];
    nodes[n].find_changes();
  }
  const RigidMotion last = motions_[body];
  motions_[body] = found.motion;
  responses_[body] = found.response;
  const double size = std::sqrt(b.inertia() / b.mass());
  return std::max({std::abs(found.motion.velocity.x - last.velocity.x),
                   std::abs(found.motion.velocity.y - last.velocity.y),
                   size * std::abs(found.motion.spin - last.spin)});
}

double Contact::solve_elastic(std::size_t body, bool bonded) {
  double most = 0.0;
  for (ContactNode& c : nodes_[body].nodes()) {
    const Vector last = c.body_change;
    c.solve_alone(bonded);
    most = std::max(most, std::hypot(c.body_change.x - last.x, c.body_change.y - last.y));
  }
  return most;
}

void Contact::refuse_elastic_corners() const {
  for (const CornerContact& c : corners_)
    if (elastic_[c.a] || elastic_[c.b])
      throw std::runtime_error(fmt::format(
          "structures '{}' and '{}' have come within half a cell of each other: elastic structures "
          "touch soil alone; two that may meet must be rigid",
          bodies_[std::min(c.a, c.b)].name(), bodies_[std::max(c.a, c.b)].name()));
}

// The sweeps begin with the changes that nodes have: none where they have just been found, those of the last
// step in the gravity stage. Two heavy bodies that light nodes tie to each other need thousands of sweeps,
// which the gravity stage so has.
void Contact::solve(std::span<const RigidMotion> trial, double dt, bool bonded) {
  constexpr int sweeps = 50;
  constexpr double tolerance = 1e-12; // of the largest speed
  const bool alone =
      corners_.empty() && std::ranges::all_of(shared_, [](const auto& of_body) { return of_body.empty(); });
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    double change = 0.0;
    double speed = 0.0;
    std::vector<RigidMotion> pushed(trial.begin(), trial.end());
    for (const CornerContact& c : corners_) {
      const auto push = [&](std::size_t body, const Vector& arm, double sense) {
        const RigidBody& b = bodies_[body];
        const Vector j = c.impulse();
        pushed[body].velocity =
            added(pushed[body].velocity, {sense * j.x / b.mass(), sense * j.y / b.mass()});
        pushed[body].spin += sense * cross(arm, j) / b.inertia();
      };
      push(c.a, c.arm_a, -1.0);
      push(c.b, c.arm_b, 1.0);
    }
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      change = std::max(change, solve_body(b, pushed[b], bonded));
      speed = std::max(speed, std::hypot(motions_[b].velocity.x, motions_[b].velocity.y));
    }
    if (alone)
      return;
    // Corners that must give way once more change the motions; the next sweep does so with all nodes.
    std::vector<RigidMotion> motions = motions_;
    const double impulse = resolve(corners_, motions, responses_, dt);
    double lightest = bodies_.front().mass();
    for (const RigidBody& b : bodies_)
      lightest = std::min(lightest, b.mass());
    if (sweep > 0 && std::max(change, impulse / lightest) <= tolerance * speed)
      return;
  }
}

} // namespace tremolo::mpm_domain
