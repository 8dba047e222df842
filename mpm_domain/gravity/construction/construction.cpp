#include "mpm_domain/gravity/construction/construction.hpp"

#include "mpm_domain/gravity/construction/same_squares.hpp"
#include "mpm_domain/particles/fill/rest_stress.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

namespace tremolo::mpm_domain {

namespace {

/// Fields of the undisturbed water, which are those of the model itself.
constexpr std::array of_water{&ParticleFields::pressure_at_rest, &ParticleFields::head,
                              &ParticleFields::head_slope_x, &ParticleFields::head_slope_y};

bool is_kept(const Particles& set, const Particles& from, const ParticleFieldDescription& line) {
  return set.traits.have(line.trait) && from.traits.have(line.trait) && line.on_cut == OnCut::copied &&
         std::ranges::find(of_water, line.field) == of_water.end();
}

void take_state(Particles& set, std::size_t k, const Particles& from, std::size_t j) {
  for (const ParticleFieldDescription& line : particle_field_table())
    if (is_kept(set, from, line))
      (set.*line.field)[k] = (from.*line.field)[j];
  for (std::size_t n = 0; n < set.more.size(); ++n)
    if (set.more_fields[n].on_cut == OnCut::copied)
      set.more[n][k] = from.more[n][j];
  for (std::size_t v = 0; v < set.state_size; ++v)
    set.state[k * set.state_size + v] = from.state[j * set.state_size + v];
  set.x_initial[k] = set.x[k] - (from.x[j] - from.x_initial[j]);
  set.y_initial[k] = set.y[k] - (from.y[j] - from.y_initial[j]);
}

/// Whether a set of the model before is of the same soil and level, above the water or below it, or of the
/// same body.
bool is_former(const Particles& other, const Particles& set) {
  return other.body.has_value() == set.body.has_value() && other.soil == set.soil &&
         other.soil_index == set.soil_index && other.level == set.level;
}

/// @returns which particles are new
std::vector<bool> take_states(Particles& set, const Domain& before) {
  std::vector<bool> is_new(set.size(), true);
  for (const Particles& other : before.sets)
    if (is_former(other, set))
      meet_in_squares(set, other, before.spec.box, before.ranks(),
                      [&](std::size_t k, const Particles& from, std::size_t j) {
                        if (is_new[k])
                          take_state(set, k, from, j);
                        is_new[k] = false;
                      });
  return is_new;
}

/// The structure of this name in a model; none where it does not stand.
std::optional<std::size_t> structure_of(const Domain& model, const std::string& name) {
  const auto bodies = model.contact.bodies();
  const auto found = std::ranges::find(bodies, name, &RigidBody::name);
  return found == bodies.end() ? std::nullopt
                               : std::optional(static_cast<std::size_t>(found - bodies.begin()));
}

/// The lattice of an elastic structure; null: it is rigid.
const Lattice* lattice_of(const Domain& model, std::size_t structure) {
  const ElasticBody* const elastic = model.contact.elastic(structure);
  return elastic == nullptr ? nullptr : &model.bodies[elastic->number()].lattice;
}

} // namespace

void carry_over(const Domain& before, Domain& after) {
  std::vector<std::vector<bool>> is_new;
  for (Particles& set : after.sets)
    is_new.push_back(take_states(set, before));
  set_rest_stress(
      after.sets_of_soil(), after.spec, [&](std::size_t s, std::size_t k) { return is_new[s][k]; },
      after.ranks());
  after.linings.carry_over(before.linings, before);
}

std::vector<std::size_t> removed_structures(const Domain& before, const std::vector<Structure>& after) {
  std::vector<std::size_t> removed;
  for (std::size_t b = 0; b < before.contact.bodies().size(); ++b)
    if (std::ranges::find(after, before.contact.bodies()[b].name(), &Structure::name) == after.end())
      removed.push_back(b);
  return removed;
}

std::vector<Vector> lacking_forces(const Domain& before, const Domain& after, const std::vector<Vector>& f0,
                                   const std::vector<Vector>& f1) {
  std::vector<Vector> lacking(f1.size());
  const std::size_t soil_nodes = after.bodies.empty() ? f1.size() : after.bodies.front().lattice.first;
  for (std::size_t n = 0; n < soil_nodes; ++n)
    lacking[n] = f0[n] - f1[n];
  for (std::size_t b = 0; b < after.contact.bodies().size(); ++b) {
    const Lattice* const own = lattice_of(after, b);
    if (own == nullptr)
      continue;
    const auto former = structure_of(before, after.contact.bodies()[b].name());
    const Lattice* const there = former ? lattice_of(before, *former) : nullptr;
    for (std::size_t n = 0; n < own->count(); ++n) {
      const Vector had = there == nullptr ? Vector{} : f0[there->first + n];
      const Vector has = f1[own->first + n];
      lacking[own->first + n] = had - has;
    }
  }
  return lacking;
}

std::vector<RigidLoad> weights_before(const Domain& before, const Domain& after,
                                      std::span<const RigidLoad> of_going) {
  std::vector<RigidLoad> gone(of_going.begin(), of_going.end());
  if (before.has_structures_here())
    before.props.add_loads_of_removed(before, before.contact, after.props, gone);
  const auto with_gone = [&](std::size_t body) { return before.contact.weight(body) + gone[body]; };
  std::vector<RigidLoad> weights;
  for (const RigidBody& body : after.contact.bodies()) {
    const auto former = structure_of(before, body.name());
    weights.push_back(former ? with_gone(*former) : RigidLoad{});
  }
  return weights;
}

} // namespace tremolo::mpm_domain
