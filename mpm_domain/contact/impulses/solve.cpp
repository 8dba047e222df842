// Solution for the impulses at all nodes of all bodies (contact.hpp): body by body, each with the impulses of
// the others, in Gauss-Seidel sweeps.

#include "mpm_domain/contact/contact.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace tremolo::mpm_domain {

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
  uses_.clear();
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (std::size_t n = 0; n < nodes(b).size(); ++n) {
      const ContactNode& c = nodes(b)[n];
      uses_.push_back({c.node, b, n, false});
      if (c.body_mass > 0.0)
        uses_.push_back({c.body_node, b, n, true});
    }
  if (bodies_.size() == 1)
    return; // which has one contact at a node
  const auto rest = [](const NodeUse& use) { return std::tuple(use.body, use.at, use.own); };
  std::ranges::sort(uses_, [rest](const NodeUse& a, const NodeUse& b) {
    return a.node != b.node ? a.node < b.node : rest(a) < rest(b);
  });
  for (std::vector<SharedNode>& of_body : shared_)
    of_body.clear();
  for (std::size_t first = 0, end = 0; first < uses_.size(); first = end) {
    while (end < uses_.size() && uses_[end].node == uses_[first].node)
      ++end;
    for (std::size_t one = first; one < end; ++one)
      for (std::size_t other = first; other < end; ++other)
        if (one != other)
          shared_[uses_[one].body].push_back({uses_[one].at, uses_[one].own, uses_[other]});
  }
  for (std::vector<SharedNode>& of_body : shared_)
    std::ranges::stable_sort(of_body, {}, &SharedNode::at);
}

ChangeByOthers Contact::by_others(std::span<const SharedNode>& next) const {
  ChangeByOthers sum;
  for (const std::size_t at = next.front().at; !next.empty() && next.front().at == at;
       next = next.subspan(1)) {
    const ContactNode& there = node_of(next.front().other);
    const Vector& change = next.front().other.own ? there.body_change : there.solid_change;
    if (next.front().own) {
      sum.body += change;
      continue;
    }
    sum.solid += change;
    sum.water += there.water_change;
  }
  return sum;
}

/// One body with the impulses of all other contacts; returns by how much its motion has changed, m/s.
double Contact::solve_rigid(std::size_t body, const RigidMotion& trial, bool bonded) {
  const RigidBody& b = bodies_[body];
  std::vector<ContactNode>& nodes = nodes_[body].nodes();
  for (std::span<const SharedNode> next = shared_[body]; !next.empty();) {
    ContactNode& shared = nodes[next.front().at];
    shared.set_trial(by_others(next));
  }
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

/// Solves an elastic body node by node: two contacts may act at one node of the body itself.
double Contact::solve_elastic(std::size_t body, bool bonded) {
  double most = 0.0;
  std::vector<ContactNode>& nodes = nodes_[body].nodes();
  std::span<const SharedNode> next = shared_[body];
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    ContactNode& c = nodes[n];
    if (!next.empty() && next.front().at == n)
      c.set_trial(by_others(next));
    const Vector last = c.body_change;
    c.solve_alone(bonded);
    most = std::max(most, std::hypot(c.body_change.x - last.x, c.body_change.y - last.y));
  }
  return most;
}

double Contact::node_speed(std::size_t body) const {
  double mass = 0.0;
  double twice_energy = 0.0;
  for (const ContactNode& c : nodes(body)) {
    mass += c.body_mass;
    twice_energy += c.body_mass * square(c.body_velocity);
  }
  return mass > 0.0 ? std::sqrt(twice_energy / mass) : 0.0;
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
        pushed[body].velocity = pushed[body].velocity + sense / b.mass() * j;
        pushed[body].spin += sense * cross(arm, j) / b.inertia();
      };
      push(c.a, c.arm_a, -1.0);
      push(c.b, c.arm_b, 1.0);
    }
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      change = std::max(change, elastic_[b] ? solve_elastic(b, bonded) : solve_rigid(b, pushed[b], bonded));
      speed = std::max(speed, elastic_[b] ? node_speed(b)
                                          : std::hypot(motions_[b].velocity.x, motions_[b].velocity.y));
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
