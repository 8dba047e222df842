#include "mpm_domain/process/output/frames/soil_frame.hpp"

#include "mpm_domain/process/output/followed_point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

namespace tremolo::mpm_domain {

namespace {

bool wants(const scene::Case& scene, scene::OutputField field) {
  return std::ranges::find(scene.output.fields, field) != scene.output.fields.end();
}

void add_water(SoilFrame::Water& frame, const Particles& set, std::size_t k, double speed_of_time) {
  const WaterState state = water_state(set, k);
  frame.pressure.push_back(state.pressure);
  frame.excess.push_back(state.excess);
  frame.ratio.push_back(state.ratio);
  frame.flux.insert(frame.flux.end(), {state.flux.x / speed_of_time, state.flux.y / speed_of_time});
}

std::vector<materials::StateVariable> all_state_variables(const Domain& domain) {
  std::vector<materials::StateVariable> all;
  for (const Particles& set : domain.sets_of_soil())
    for (const materials::StateVariable& variable : materials::state_variables(set.law))
      if (!variable.internal && std::none_of(all.begin(), all.end(),
                                             [&](const auto& known) { return known.name == variable.name; }))
        all.push_back(variable);
  return all;
}

double state_value(const Particles& set, std::size_t k, std::string_view name) {
  const auto variables = materials::state_variables(set.law);
  for (std::size_t s = 0; s < variables.size(); ++s)
    if (variables[s].name == name)
      return set.state[k * set.state_size + s];
  return 0.0;
}

/// The fields of frames that the table of particle fields names, in its order, and fields of one's own.
std::vector<SoilFrame::Carried> carried_fields(const Domain& domain) {
  std::vector<SoilFrame::Carried> fields;
  domain.sets.front().for_fields([&](const ParticleFieldDescription& line, const std::vector<double>&) {
    const std::string& name = line.in_frames();
    if (!name.empty()) {
      auto known = std::ranges::find(fields, name, &SoilFrame::Carried::name);
      if (known == fields.end())
        known = fields.insert(known, {name, line.unit, {}, {}});
      known->components.push_back(line.name);
    }
  });
  return fields;
}

/// Adds the arrays of an output field to those of a frame.
using Add = void (*)(const SoilFrame&, const scene::OutputFieldRow&, std::vector<results::Field>&);

/// The frame's own array.
template <auto array>
void add_own(const SoilFrame& frame, const scene::OutputFieldRow& row, std::vector<results::Field>& fields) {
  fields.push_back({row.name, row.unit, row.components, frame.*array});
}

/// The frame's own array about water.
template <auto array>
void add_of_water(const SoilFrame& frame, const scene::OutputFieldRow& row,
                  std::vector<results::Field>& fields) {
  fields.push_back({row.name, row.unit, row.components, frame.water.*array});
}

results::Field as_field(const SoilFrame::Carried& field) {
  return {field.name, field.unit, field.components.size(), field.values};
}

/// The array of what particles carry under the field's name.
void add_carried(const SoilFrame& frame, const scene::OutputFieldRow& row,
                 std::vector<results::Field>& fields) {
  const auto field = std::ranges::find(frame.carried, row.name, &SoilFrame::Carried::name);
  if (field == frame.carried.end())
    throw std::logic_error(fmt::format("particles carry no field '{}' for frames", row.name));
  fields.push_back(as_field(*field));
}

/// An array for each state variable.
void add_states(const SoilFrame& frame, const scene::OutputFieldRow&, std::vector<results::Field>& fields) {
  for (std::size_t v = 0; v < frame.variables.size(); ++v)
    fields.push_back({frame.variables[v].name, frame.variables[v].unit, 1, frame.states[v]});
}

/// Where the arrays of an output field come from.
struct Source {
  scene::OutputField field;
  Add add;
};

constexpr std::array sources{
    Source{scene::OutputField::displacement, add_own<&SoilFrame::displacement>},
    Source{scene::OutputField::velocity, add_carried},
    Source{scene::OutputField::acceleration, add_own<&SoilFrame::acceleration>},
    Source{scene::OutputField::stress, add_carried},
    Source{scene::OutputField::state, add_states},
    Source{scene::OutputField::pore_pressure, add_of_water<&SoilFrame::Water::pressure>},
    Source{scene::OutputField::excess_pore_pressure, add_of_water<&SoilFrame::Water::excess>},
    Source{scene::OutputField::pore_pressure_ratio, add_of_water<&SoilFrame::Water::ratio>},
    Source{scene::OutputField::darcy_velocity, add_of_water<&SoilFrame::Water::flux>},
};
static_assert(std::ranges::equal(sources, scene::output_fields, {}, &Source::field,
                                 &scene::OutputFieldRow::field),
              "every output field of a case has its source here, in the order of scene::output_fields");

bool is_output_field(std::string_view name) {
  return value_named<scene::OutputField>(name).has_value();
}

/// Makes room for so many particles, so that no array grows to twice what it needs.
void reserve(SoilFrame& frame, std::size_t particles) {
  for (std::vector<double>* vectors : {&frame.position, &frame.displacement, &frame.acceleration})
    vectors->reserve(2 * particles);
  frame.soil.reserve(particles);
  for (SoilFrame::Carried& field : frame.carried)
    field.values.reserve(field.components.size() * particles);
  for (std::vector<double>& state : frame.states)
    state.reserve(particles);
}

} // namespace

/// The names of the soils. Slices of one soil are consecutive and share its name.
std::vector<std::string> soil_names(const Spec& spec) {
  std::vector<std::string> names;
  for (const Soil& soil : spec.soils)
    if (names.empty() || names.back() != soil.name)
      names.push_back(soil.name);
  return names;
}

bool is_wanted(const scene::Case& scene, std::string_view name) {
  if (name == "volume") // which stress needs
    return wants(scene, scene::OutputField::stress);
  const auto field = value_named<scene::OutputField>(name);
  return !field || wants(scene, *field);
}

SoilFrame::SoilFrame(const Domain& domain, const Snapshot& snapshot, const Stepper& stepper, bool has_water) {
  const double n = stepper.speed_of_time();
  const std::vector<std::string> names = soil_names(domain.spec);
  carried = carried_fields(domain);
  variables = all_state_variables(domain);
  states.resize(variables.size());
  std::size_t particles = 0;
  for (const Particles& set : snapshot.sets_of_soil())
    particles += set.size();
  reserve(*this, particles);
  for (std::size_t s = 0; s < domain.soil_sets; ++s) {
    const Particles& set = snapshot.sets()[s];
    const auto name = static_cast<std::int32_t>(std::ranges::find(names, set.soil) - names.begin());
    std::map<std::string_view, const std::vector<double>*> columns;
    set.for_fields([&](const ParticleFieldDescription& line, const std::vector<double>& values) {
      columns[line.name] = &values;
    });
    std::vector<double> vx(set.size());
    std::vector<double> vy(set.size());
    for (std::size_t k = 0; k < set.size(); ++k) {
      const Vector v = snapshot.velocity(s, k);
      vx[k] = v.x / n;
      vy[k] = v.y / n;
    }
    columns["vx"] = &vx;
    columns["vy"] = &vy;
    std::vector<std::vector<const std::vector<double>*>> columns_of; // by field and component
    for (const Carried& field : carried) {
      std::vector<const std::vector<double>*>& components = columns_of.emplace_back();
      for (const std::string& component : field.components)
        components.push_back(columns.at(component));
    }
    for (const std::uint32_t k : set.index_of) {
      if (k == Particles::nowhere)
        continue;
      const Vector a = snapshot.acceleration(s, k);
      const auto [x, y] = position_of(set, k, stepper.dt());
      position.insert(position.end(), {x, y});
      const Vector moved = mpm_domain::displacement(set, k, stepper.dt());
      displacement.insert(displacement.end(), {moved.x, moved.y});
      acceleration.insert(acceleration.end(), {a.x / (n * n), a.y / (n * n)});
      for (std::size_t f = 0; f < columns_of.size(); ++f)
        for (const std::vector<double>* component : columns_of[f])
          carried[f].values.push_back((*component)[k]);
      if (has_water)
        add_water(water, set, k, n);
      soil.push_back(name);
      if (domain.mesh)
        size.push_back(2.0 * set.half_size);
      for (std::size_t v = 0; v < variables.size(); ++v)
        states[v].push_back(state_value(set, k, variables[v].name));
    }
  }
}

std::vector<results::Field> SoilFrame::fields(const scene::Case& scene) const {
  std::vector<results::Field> wanted{{"position", "m", 2, position}, {"soil", "1", 1, soil}};
  if (!size.empty())
    wanted.push_back({"size", "m", 1, size});
  for (const auto& [field, add] : sources)
    if (wants(scene, field))
      add(*this, scene::row(field), wanted);
  for (const Carried& field : carried)
    if (!is_output_field(field.name) && is_wanted(scene, field.name))
      wanted.push_back(as_field(field));
  return wanted;
}

} // namespace tremolo::mpm_domain
