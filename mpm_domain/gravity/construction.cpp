#include "mpm_domain/gravity/construction.hpp"

#include "mpm_domain/particles/fill.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace tremolo::mpm_domain {

namespace {

/// Number of the square of the model's lattice that a particle stands in.
std::int64_t square_of(const Particles& set, std::size_t k, const Box& box) {
  const double size = 2.0 * set.half_size;
  const auto along = [size](double place, double origin) {
    return static_cast<std::int64_t>(std::floor((place - origin) / size));
  };
  constexpr std::int64_t rows = std::int64_t{1} << 31;
  return along(set.x[k], box.x_min) * rows + along(set.y[k], box.y_min);
}

/// The set of the model before that particles of a set come from; null: there was none.
const Particles* set_before(const Domain& before, const Domain& after, std::size_t s) {
  const Particles& set = after.sets[s];
  if (!set.body)
    return &before.sets[s]; // both models have the same soils and levels
  const auto found = std::ranges::find_if(before.body_sets(), [&](const Particles& other) {
    return other.soil == set.soil && other.water.has_value() == set.water.has_value();
  });
  return found == before.body_sets().end() ? nullptr : &*found;
}

void take_state(Particles& set, std::size_t k, const Particles& from, std::size_t j) {
  for (const ParticleFieldDescription& line : particle_field_table())
    if (set.traits.have(line.trait) && line.on_cut == OnCut::copied)
      (set.*line.field)[k] = (from.*line.field)[j];
  for (std::size_t n = 0; n < set.more.size(); ++n)
    if (set.more_fields[n].on_cut == OnCut::copied)
      set.more[n][k] = from.more[n][j];
  for (std::size_t v = 0; v < set.state_size; ++v)
    set.state[k * set.state_size + v] = from.state[j * set.state_size + v];
  set.x_initial[k] = set.x[k] - (from.x[j] - from.x_initial[j]);
  set.y_initial[k] = set.y[k] - (from.y[j] - from.y_initial[j]);
}

/// @returns which particles are new
std::vector<bool> take_states(Particles& set, const Particles* from, const Box& box) {
  std::vector<bool> is_new(set.size(), true);
  if (from == nullptr)
    return is_new;
  std::unordered_map<std::int64_t, std::size_t> squares;
  for (std::size_t j = 0; j < from->size(); ++j)
    squares.emplace(square_of(*from, j, box), j);
  for (std::size_t k = 0; k < set.size(); ++k)
    if (const auto found = squares.find(square_of(set, k, box)); found != squares.end()) {
      take_state(set, k, *from, found->second);
      is_new[k] = false;
    }
  return is_new;
}

/// The bodies of one model that another one lacks.
std::vector<std::size_t> bodies_without(const Domain& model, const Domain& other) {
  std::vector<std::size_t> found;
  const auto others = other.contact.bodies();
  for (std::size_t b = 0; b < model.contact.bodies().size(); ++b)
    if (std::ranges::find(others, model.contact.bodies()[b].name(), &RigidBody::name) == others.end())
      found.push_back(b);
  return found;
}

} // namespace

Placed carry_over(const Domain& before, Domain& after) {
  Placed placed;
  for (std::size_t s = 0; s < after.sets.size(); ++s)
    placed.particles.push_back(take_states(after.sets[s], set_before(before, after, s), after.spec.box));
  set_rest_stress(after.sets_of_soil(), after.spec,
                  [&](std::size_t s, std::size_t k) { return placed.particles[s][k]; });
  placed.structures = bodies_without(after, before);
  return placed;
}

std::vector<std::size_t> removed_structures(const Domain& before, const Domain& after) {
  return bodies_without(before, after);
}

std::vector<Vector> lacking_forces(const Domain& after, const Placed& placed, const std::vector<Vector>& f0,
                                   const std::vector<Vector>& f1) {
  std::vector<Vector> lacking(f1.size());
  const std::size_t soil_nodes = after.bodies.empty() ? f1.size() : after.bodies.front().lattice.first;
  for (std::size_t n = 0; n < soil_nodes; ++n)
    lacking[n] = {f0[n].x - f1[n].x, f0[n].y - f1[n].y};
  for (const std::size_t b : placed.structures)
    if (const ElasticBody* elastic = after.contact.elastic(b)) {
      const Lattice& own = after.bodies[elastic->number()].lattice;
      for (std::size_t n = own.first; n < own.first + own.count(); ++n)
        lacking[n] = {-f1[n].x, -f1[n].y};
    }
  return lacking;
}

} // namespace tremolo::mpm_domain
