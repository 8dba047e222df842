#include "mpm_domain/prop/props.hpp"

#include "mpm_domain/ground.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

using Placed = Props::Placed;

Vector way(const Placed& prop, const Ground& ground, const Contact& contact) {
  return prop.to.position(ground, contact) - prop.from.position(ground, contact);
}

/// d
Vector direction(const Placed& prop, const Ground& ground, const Contact& contact) {
  const Vector w = way(prop, ground, contact);
  return 1.0 / std::sqrt(square(w)) * w;
}

/// Adds the force of an end on its rigid body.
void add_load(const FastenedEnd& end, const Vector& force, const Ground& ground, const Contact& contact,
              std::vector<RigidLoad>& loads) {
  if (!end.body())
    return;
  RigidLoad& load = loads[*end.body()];
  load.force += force;
  load.moment += cross(contact.bodies()[*end.body()].arm(end.position(ground, contact)), force);
}

void add_loads(const Placed& prop, const Ground& ground, const Contact& contact,
               std::vector<RigidLoad>& loads) {
  const Vector force = prop.spring.force() * direction(prop, ground, contact);
  add_load(prop.from, force, ground, contact, loads);
  add_load(prop.to, -force, ground, contact, loads);
}

const Placed* find(const Props& props, const std::string& name) {
  const auto found = std::ranges::find(props.all(), name, &Placed::name);
  return found == props.all().end() ? nullptr : &*found;
}

} // namespace

Props::Props(Ground& ground, const Contact& contact) {
  for (const Prop& prop : ground.spec.props) {
    Placed& placed =
        all_.emplace_back(Placed{prop.name, FastenedEnd(prop.from, ground, contact),
                                 FastenedEnd(prop.to, ground, contact), Spring(prop), 0.0, prop.prestress});
    placed.length = std::sqrt(square(prop.to.position - prop.from.position));
    if (!(placed.length > 0.0))
      throw std::invalid_argument(fmt::format("prop '{}' has both ends at ({:.6g}, {:.6g}) m", prop.name,
                                              prop.from.position.x, prop.from.position.y));
  }
}

double Props::critical_step() const {
  double step = std::numeric_limits<double>::infinity();
  for (const Placed& prop : all_)
    step = std::min(step,
                    1.0 / std::sqrt(prop.spring.stiffness() * (prop.from.mobility() + prop.to.mobility())));
  return step;
}

void Props::act(Ground& ground, Contact& contact) {
  if (!any())
    return;
  std::vector<RigidLoad> loads(contact.bodies().size());
  for (Placed& prop : all_) {
    prop.from.follow(ground);
    prop.to.follow(ground);
    const Vector force = prop.spring.force() * direction(prop, ground, contact);
    prop.from.pull_nodes(ground, force);
    prop.to.pull_nodes(ground, -force);
    add_loads(prop, ground, contact, loads);
  }
  contact.take_props(std::move(loads));
}

void Props::take_off(Ground& ground, const Contact& contact) const {
  for (const Placed& prop : all_) {
    const Vector force = prop.spring.force() * direction(prop, ground, contact);
    prop.from.pull_nodes(ground, -force);
    prop.to.pull_nodes(ground, force);
  }
}

SpringWork Props::follow(const Ground& ground, const Contact& contact) {
  SpringWork work;
  for (Placed& prop : all_) {
    const double length = std::sqrt(square(way(prop, ground, contact)));
    const auto [stored, dissipated] = prop.spring.part(length - prop.length);
    prop.length = length;
    work = {work.stored + stored, work.dissipated + dissipated};
  }
  return work;
}

void Props::follow_velocity(const Ground& ground, const Contact& contact, double dt) {
  for (Placed& prop : all_) {
    const Vector apart = prop.to.velocity(ground, contact) - prop.from.velocity(ground, contact);
    prop.spring.part(dt * dot(direction(prop, ground, contact), apart));
  }
}

void Props::carry_over(const Props& before) {
  for (Placed& prop : all_)
    if (const Placed* const former = find(before, prop.name))
      prop.spring.set_stretch(former->spring.stretch());
}

void Props::place_jacks(const Props* before) {
  for (Placed& prop : all_) {
    if (before != nullptr && find(*before, prop.name) != nullptr)
      continue;
    prop.spring.set_stretch(0.0);
    if (prop.prestress)
      prop.spring.jack(0.0);
  }
}

void Props::grow(double share) {
  for (Placed& prop : all_)
    if (prop.spring.is_jacked())
      prop.spring.jack(share * *prop.prestress);
}

void Props::lock() {
  for (Placed& prop : all_)
    prop.spring.lock();
}

void Props::add_loads_of_removed(const Ground& ground, const Contact& contact, const Props& after,
                                 std::vector<RigidLoad>& loads) const {
  for (const Placed& prop : all_)
    if (find(after, prop.name) == nullptr)
      add_loads(prop, ground, contact, loads);
}

} // namespace tremolo::mpm_domain
