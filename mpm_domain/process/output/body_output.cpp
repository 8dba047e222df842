#include "mpm_domain/process/output/body_output.hpp"

#include "mpm_domain/process/output/add_history.hpp"
#include "mpm_domain/process/output/frames/named_arrays.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <span>
#include <string_view>

namespace tremolo::mpm_domain {

namespace {

/// x and y of one corner after the other.
std::vector<double> flat(const std::vector<Vector>& corners) {
  std::vector<double> values;
  for (const Vector& corner : corners)
    values.insert(values.end(), {corner.x, corner.y});
  return values;
}

/// Position of a body at the time of its velocity, half a step before the present.
struct BodyPosition {
  Vector centre;
  double tilt;

  BodyPosition(const RigidBody& body, double dt)
      : centre(body.centre() - 0.5 * dt * body.motion().velocity),
        tilt(body.tilt() - 0.5 * dt * body.motion().spin) {}

  Vector turned(const Vector& arm) const {
    const double c = std::cos(tilt);
    const double s = std::sin(tilt);
    return {c * arm.x - s * arm.y, s * arm.x + c * arm.y};
  }
};

} // namespace

std::vector<results::Field> ContactFrame::fields() const {
  return named_arrays(contact_arrays,
                      {position, normal, body, area, normal_force, friction_force, water_force});
}

BodyOutput::BodyOutput(const scene::Case& scene, const Domain& domain, results::RunWriter& writer)
    : domain_(domain) {
  const std::span<const RigidBody> bodies = domain.contact.bodies();
  std::vector<std::string> names;
  for (const RigidBody& body : bodies) {
    std::vector<results::Attribute> attributes{
        {"outline", flat(body.outline())}, {"mass", body.mass()}, {"inertia", body.inertia()}};
    if (const std::vector<Vector> hole = body.hole(); !hole.empty())
      attributes.push_back({"hole", flat(hole)});
    const std::string path = "/bodies/" + body.name();
    bodies_.push_back(&add_history(writer, path, body_columns, attributes));
    series_.emplace_back(path, bodies_.back());
    names.push_back(body.name());
    if (domain.contact.is_elastic(names.size() - 1))
      add_outline(names.size() - 1, writer);
  }
  if (!names.empty())
    writer.attribute("structure_names", names);
  for (const scene::Monitor& monitor : scene.monitors) {
    if (!monitor.structure || domain.contact.is_elastic(*monitor.structure))
      continue;
    const std::string path = "/monitors/" + monitor.name;
    results::TimeSeries& series =
        add_history(writer, path, body_monitor_columns,
                    std::array{results::Attribute{"structure", names[*monitor.structure]}});
    const Vector& start = bodies[*monitor.structure].start();
    followers_.push_back({*monitor.structure, monitor.point - start, {}, {}, &series});
    series_.emplace_back(path, &series);
  }
}

void BodyOutput::add_outline(std::size_t body, results::RunWriter& writer) {
  const ElasticBody& elastic = *domain_.contact.elastic(body);
  std::vector<std::string> columns{"time"};
  std::vector<std::string> units{"s"};
  const auto add_points = [&](std::string_view of, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k)
      for (const char axis : {'x', 'y'}) {
        columns.push_back(fmt::format("{}{}{}", of, axis, k));
        units.emplace_back("m");
      }
  };
  add_points("", elastic.surface().points().size());
  add_points("hole_", elastic.hole().size());
  const std::string path = "/outlines/" + domain_.contact.bodies()[body].name();
  outlines_.emplace_back(path, &writer.add_series(path, columns, units));
}

void BodyOutput::write_outlines(const Stepper& stepper) {
  auto series = outlines_.begin();
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const ElasticBody* const elastic = domain_.contact.elastic(b);
    if (elastic == nullptr)
      continue;
    std::vector<double> row{stepper.time_of_soil()};
    // Points of the surface are where its particles are, half a step after their velocities.
    const RigidMotion& u = domain_.contact.bodies()[b].motion();
    const double back = 0.5 * stepper.dt();
    for (const std::vector<Vector>* points : {&elastic->surface().points(), &elastic->hole()})
      for (const Vector& p : *points) {
        const Vector at = p - back * u.at(domain_.contact.bodies()[b].arm(p));
        row.insert(row.end(), {at.x, at.y});
      }
    (series++)->second->append(row);
  }
}

void BodyOutput::write_history(const Stepper& stepper) {
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    write_body(b, stepper);
  for (const Follower& follower : followers_)
    write_follower(follower, stepper);
}

void BodyOutput::write_body(std::size_t b, const Stepper& stepper) {
  const RigidBody& body = domain_.contact.bodies()[b];
  const RigidMotion& u = body.motion();
  const BodyPosition position(body, stepper.dt());
  const BodyForces forces = domain_.contact.forces(b);
  const double n = stepper.speed_of_time();
  std::vector<double> row{stepper.time_of_soil(), position.centre.x, position.centre.y, position.tilt,
                          u.velocity.x / n,       u.velocity.y / n,  u.spin / n};
  for (const RigidLoad& load : {forces.normal, forces.friction, forces.water, forces.weight})
    row.insert(row.end(), {load.force.x, load.force.y, load.moment});
  bodies_[b]->append(row);
}

void BodyOutput::write_follower(const Follower& follower, const Stepper& stepper) {
  const RigidBody& body = domain_.contact.bodies()[follower.body];
  const BodyPosition position(body, stepper.dt());
  const Vector arm = position.turned(follower.arm);
  // The centre's displacement and the arm's, so that rounding of large coordinates stays out of it.
  const Vector u = position.centre - body.start() + (arm - follower.arm);
  const double n = stepper.speed_of_time();
  follower.series->append(std::array{stepper.time_of_soil(), position.centre.x + arm.x,
                                     position.centre.y + arm.y, u.x, u.y, follower.velocity.x / n,
                                     follower.velocity.y / n, follower.acceleration.x / (n * n),
                                     follower.acceleration.y / (n * n)});
}

void BodyOutput::after_step(const Stepper& stepper) {
  for (Follower& follower : followers_) {
    const RigidBody& body = domain_.contact.bodies()[follower.body];
    const Vector v = body.motion().at(BodyPosition(body, stepper.dt()).turned(follower.arm));
    follower.acceleration = (v - follower.velocity) / stepper.kick();
    follower.velocity = v;
  }
}

ContactFrame BodyOutput::contact(const Stepper& stepper) const {
  const double dt = stepper.kick();
  ContactFrame frame;
  const auto add = [&](const ContactNode& node, std::size_t body, const Vector& normal) {
    frame.position.insert(frame.position.end(), {node.position.x, node.position.y});
    frame.normal.insert(frame.normal.end(), {normal.x, normal.y});
    frame.body.push_back(static_cast<std::int32_t>(body));
    frame.area.push_back(node.area);
    frame.normal_force.push_back(node.effective_impulse / dt);
    frame.friction_force.push_back(node.tangential_impulse / dt);
    frame.water_force.push_back((node.normal_impulse - node.effective_impulse) / dt);
  };
  for (std::size_t b = 0; b < bodies_.size(); ++b)
    for (const ContactNode& node : domain_.contact.nodes(b)) {
      add(node, b, node.normal);
      if (node.key.against) // the other structure gets the opposite
        add(node, *node.key.against, -node.normal);
    }
  return frame;
}

void BodyOutput::add_state(SavedNumbers& state) {
  for (Follower& follower : followers_)
    state.add(follower.velocity);
}

} // namespace tremolo::mpm_domain
