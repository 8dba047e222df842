#include "mpm_domain/process/output/frames/soil_frame.hpp"

#include "mpm_domain/process/output/followed_point.hpp"
#include "mpm_domain/transfer/gather.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <span>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

bool wants(const scene::Case& scene, scene::OutputField field) {
  return std::ranges::find(scene.output.fields, field) != scene.output.fields.end();
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

/// One of the soil's sets at the time of a frame.
struct FrameSet {
  const Domain& domain;
  const Stepper& stepper;
  std::size_t number;

  const Particles& particles() const { return domain.sets[number]; }
  double speed_of_time() const { return stepper.speed_of_time(); }
};

using Values = NumbersOfParticle;
using ValuesOfSet = std::function<Values(const FrameSet& set)>;

void append(std::vector<double>& to, const Vector& v) {
  to.insert(to.end(), {v.x, v.y});
}

Values position(const FrameSet& set) {
  return [set](std::size_t k, auto& to) {
    append(to, mpm_domain::position_of(set.particles(), k, set.stepper.dt()));
  };
}

Values displacement(const FrameSet& set) {
  return [set](std::size_t k, auto& to) {
    append(to, mpm_domain::displacement(set.particles(), k, set.stepper.dt()));
  };
}

Values velocity(const FrameSet& set) {
  return [set](std::size_t k, auto& to) {
    append(to, particle_velocity(set.domain, set.particles(), k) / set.speed_of_time());
  };
}

Values acceleration(const FrameSet& set) {
  return [set, n = set.speed_of_time()](std::size_t k, auto& to) {
    append(to, particle_acceleration(set.domain, set.particles(), k) / (n * n));
  };
}

template <double WaterState::*member>
Values of_water(const FrameSet& set) {
  return [set](std::size_t k, auto& to) { to.push_back(water_state(set.particles(), k).*member); };
}

Values darcy_velocity(const FrameSet& set) {
  return [set](std::size_t k, auto& to) {
    append(to, water_state(set.particles(), k).flux / set.speed_of_time());
  };
}

/// The size of particles at the start.
Values size(const FrameSet& set) {
  return [set](std::size_t, auto& to) { to.push_back(2.0 * set.particles().half_size); };
}

/// Fields that particles carry under these names.
ValuesOfSet carried(std::vector<std::string> names) {
  return [names = std::move(names)](const FrameSet& set) -> Values {
    std::vector<const std::vector<double>*> columns;
    for (const std::string& name : names)
      set.particles().for_fields(
          [&](const ParticleFieldDescription& line, const std::vector<double>& values) {
            if (line.name == name)
              columns.push_back(&values);
          });
    return [columns = std::move(columns)](std::size_t k, auto& to) {
      for (const std::vector<double>* column : columns)
        to.push_back((*column)[k]);
    };
  };
}

/// A state variable; 0 where the law of the soil has none of this name.
ValuesOfSet state(const std::string& name) {
  return [name](const FrameSet& set) -> Values {
    const Particles& particles = set.particles();
    const auto variables = materials::state_variables(particles.law);
    const auto found = std::ranges::find(variables, name, &materials::StateVariable::name);
    if (found == variables.end())
      return [](std::size_t, auto& to) { to.push_back(0.0); };
    return [&particles, s = static_cast<std::size_t>(found - variables.begin())](std::size_t k, auto& to) {
      to.push_back(particles.state[k * particles.state_size + s]);
    };
  };
}

/// What an output field of a case is made from. Stress is carried by particles under its own name, and state
/// is an array a state variable.
struct Source {
  scene::OutputField field;
  Values (*values)(const FrameSet& set);
};

constexpr std::array sources{
    Source{scene::OutputField::displacement, displacement},
    Source{scene::OutputField::velocity, velocity},
    Source{scene::OutputField::acceleration, acceleration},
    Source{scene::OutputField::stress, nullptr},
    Source{scene::OutputField::state, nullptr},
    Source{scene::OutputField::pore_pressure, of_water<&WaterState::pressure>},
    Source{scene::OutputField::excess_pore_pressure, of_water<&WaterState::excess>},
    Source{scene::OutputField::pore_pressure_ratio, of_water<&WaterState::ratio>},
    Source{scene::OutputField::darcy_velocity, darcy_velocity},
};
static_assert(std::ranges::equal(sources, scene::output_fields, {}, &Source::field,
                                 &scene::OutputFieldRow::field),
              "every output field of a case has its source here, in the order of scene::output_fields");

/// An array of a frame, and where its values come from.
struct Column {
  std::string name;
  std::string unit;
  std::size_t components;
  ValuesOfSet values;
};

/// Finds the arrays that the table of particle fields gives to frames. The velocity is not among them, since
/// frames show that of particle_velocity().
std::vector<Column> carried_columns(const Domain& domain, const scene::Case& scene) {
  struct Named {
    std::string name, unit;
    std::vector<std::string> components;
  };
  std::vector<Named> fields;
  domain.sets.front().for_fields([&](const ParticleFieldDescription& line, const std::vector<double>&) {
    const std::string& name = line.in_frames();
    if (name.empty() || name == scene::name(scene::OutputField::velocity) || !is_wanted(scene, name))
      return;
    auto known = std::ranges::find(fields, name, &Named::name);
    if (known == fields.end())
      known = fields.insert(known, {name, line.unit, {}});
    known->components.push_back(line.name);
  });
  std::vector<Column> columns;
  columns.reserve(fields.size());
  for (const Named& field : fields)
    columns.push_back({field.name, field.unit, field.components.size(), carried(field.components)});
  return columns;
}

std::vector<Column> columns_of(const Domain& domain, const scene::Case& scene) {
  std::vector<Column> columns{{"position", "m", 2, position}};
  if (domain.mesh)
    columns.push_back({"size", "m", 1, size});
  for (const auto& [field, values] : sources) {
    const scene::OutputFieldRow& row = scene::row(field);
    if (values != nullptr && wants(scene, field) && (!row.of_water || scene.water))
      columns.push_back({std::string(row.name), std::string(row.unit), row.components, values});
  }
  if (wants(scene, scene::OutputField::state))
    for (const materials::StateVariable& variable : all_state_variables(domain))
      columns.push_back(
          {std::string(variable.name), std::string(variable.unit), 1, state(std::string(variable.name))});
  for (Column& column : carried_columns(domain, scene))
    columns.push_back(std::move(column));
  return columns;
}

} // namespace

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

SoilFrame::SoilFrame(const Domain& domain, const Stepper& stepper, const scene::Case& scene)
    : domain_(domain) {
  const std::vector<std::string> names = soil_names(domain.spec);
  for (const Particles& set : domain.sets_of_soil())
    soil_of_set_.push_back(static_cast<std::int32_t>(std::ranges::find(names, set.soil) - names.begin()));
  for (Column& column : columns_of(domain, scene))
    arrays_.push_back({column.name,
                       column.unit,
                       {.number = arrays_.size(),
                        .width = column.components,
                        .of_set = [&domain, &stepper, values = std::move(column.values)](std::size_t set) {
                          return values({domain, stepper, set});
                        }}});
}

std::vector<ShownQuantity> SoilFrame::quantities() const {
  std::vector<ShownQuantity> quantities;
  for (const Array& array : arrays_)
    quantities.push_back(array.quantity);
  return quantities;
}

std::size_t SoilFrame::particle_count(const AllParticles& all) const {
  std::size_t count = 0;
  for (std::size_t s = 0; s < domain_.soil_sets; ++s)
    count += all.size(s);
  return count;
}

std::vector<results::StreamedField> SoilFrame::fields(const AllParticles& all) const {
  std::vector<results::StreamedField> fields;
  fields.push_back({"soil", "1", 1, true, [&](const auto& take) {
                      for (std::size_t s = 0; s < domain_.soil_sets; ++s)
                        for (std::size_t left = all.size(s); left > 0;) {
                          const std::vector<std::int32_t> piece(std::min(left, particles_at_once),
                                                                soil_of_set_[s]);
                          take(std::span(piece));
                          left -= piece.size();
                        }
                    }});
  for (const Array& array : arrays_)
    fields.push_back({array.name, array.unit, array.quantity.width, false, [&](const auto& take) {
                        for (std::size_t s = 0; s < domain_.soil_sets; ++s)
                          all.in_order_of_ids(s, array.quantity, take);
                      }});
  return fields;
}

} // namespace tremolo::mpm_domain
