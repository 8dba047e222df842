#include "mpm_domain/process/run_output.hpp"

#include "mpm_domain/transfer/gather.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

results::RunDescription description(const scene::Case& scene, const std::string& plan) {
  return {.title = scene.title,
          .case_text = scene.text,
          .plan = plan,
          .build_version = TREMOLO_VERSION,
          .compiler = __VERSION__,
          .build_flags = TREMOLO_BUILD_FLAGS};
}

bool wants(const scene::Case& scene, scene::OutputField field) {
  return std::find(scene.output.fields.begin(), scene.output.fields.end(), field) !=
         scene.output.fields.end();
}

/// Fields of one's own are written whenever there are any.
bool wants_carried(const scene::Case& scene, std::string_view name) {
  if (name == "velocity")
    return wants(scene, scene::OutputField::velocity);
  if (name == "stress" || name == "volume")
    return wants(scene, scene::OutputField::stress);
  return true;
}

/// Fields of a frame, before those of the laws.
constexpr std::array<std::string_view, 7> field_order{"position",     "soil",   "displacement", "velocity",
                                                      "acceleration", "stress", "volume"};

/// A field of a frame that particles carry.
struct CarriedField {
  std::string name;
  std::string unit;
  std::vector<std::string> components; ///< names of particle fields
  std::vector<double> values;
};

/// Fields of a frame that follow from the pore water; 0 where there is none.
struct WaterFrame {
  std::vector<double> pressure, excess, ratio, flux;
};

/// A line of what is written of it.
struct WaterField {
  scene::OutputField field;
  std::string_view unit;
  std::size_t components;
  std::span<const double> values;
};

/// What a monitor records besides motion where the case has water: the effective stress path, and pressure.
constexpr std::array<std::pair<std::string_view, std::string_view>, 6> monitored_stress{
    {{"sxx", "Pa"},
     {"syy", "Pa"},
     {"szz", "Pa"},
     {"sxy", "Pa"},
     {"pore_pressure", "Pa"},
     {"pore_pressure_ratio", "1"}}};

void add_water(WaterFrame& frame, const Particles& set, std::size_t k) {
  double pressure = 0.0;
  double excess = 0.0;
  double ratio = 0.0;
  Vector flux;
  if (set.traits.wet) {
    pressure = set.water->pressure(set.pore_pressure[k]);
    excess = set.water->excess(set.pore_pressure[k], set.y[k]);
    ratio = set.vertical_at_rest[k] < 0.0 ? excess / -set.vertical_at_rest[k] : 0.0;
  }
  if (set.traits.flowing) {
    const double porosity = set.water->porosity(set.mass[k], set.volume[k]);
    flux = {porosity * (set.wx[k] - set.vx[k]), porosity * (set.wy[k] - set.vy[k])};
  }
  frame.pressure.push_back(pressure);
  frame.excess.push_back(excess);
  frame.ratio.push_back(ratio);
  frame.flux.insert(frame.flux.end(), {flux.x, flux.y});
}

/// Arrays of a frame: all soils one after the other, each in the order of particle ids.
struct Frame {
  std::vector<double> position, displacement, acceleration, size;
  std::vector<std::int32_t> soil;
  std::vector<CarriedField> carried; ///< by the table of fields
  WaterFrame water;
  std::vector<materials::StateVariable> variables; ///< of all soils, each name once
  std::vector<std::vector<double>> states; ///< one array a variable; 0 where a soil has no such variable
};

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

/// Where a particle was at the time of its velocity, half a step before the present, m.
Vector place(const Particles& set, std::size_t k, double dt) {
  return {set.x[k] - 0.5 * dt * set.vx[k], set.y[k] - 0.5 * dt * set.vy[k]};
}

/// The fields of frames that the table of particle fields names, in its order, and fields of one's own.
std::vector<CarriedField> carried_fields(const Domain& domain) {
  std::vector<CarriedField> fields;
  domain.sets.front().for_fields([&](const ParticleFieldDescription& line, const std::vector<double>&) {
    const std::string& name = line.field == nullptr ? line.name : line.frame;
    if (!name.empty()) {
      auto known = std::ranges::find(fields, name, &CarriedField::name);
      if (known == fields.end())
        known = fields.insert(known, {name, line.unit, {}, {}});
      known->components.push_back(line.name);
    }
  });
  return fields;
}

Frame collect(const Domain& domain, double dt) {
  Frame frame;
  frame.carried = carried_fields(domain);
  frame.variables = all_state_variables(domain);
  frame.states.resize(frame.variables.size());
  for (const Particles& set : domain.sets_of_soil()) {
    std::map<std::string_view, const std::vector<double>*> columns;
    set.for_fields([&](const ParticleFieldDescription& line, const std::vector<double>& values) {
      columns[line.name] = &values;
    });
    for (const std::uint32_t k : set.index_of) {
      if (k == Particles::nowhere)
        continue;
      const Vector acceleration = particle_acceleration(domain, set, k);
      const auto [x, y] = place(set, k, dt);
      frame.position.insert(frame.position.end(), {x, y});
      frame.displacement.insert(frame.displacement.end(), {x - set.x_initial[k], y - set.y_initial[k]});
      frame.acceleration.insert(frame.acceleration.end(), {acceleration.x, acceleration.y});
      for (CarriedField& field : frame.carried)
        for (const std::string& component : field.components)
          field.values.push_back((*columns.at(component))[k]);
      add_water(frame.water, set, k);
      frame.soil.push_back(static_cast<std::int32_t>(set.soil_index));
      frame.size.push_back(2.0 * set.half_size);
      for (std::size_t v = 0; v < frame.variables.size(); ++v)
        frame.states[v].push_back(state_value(set, k, frame.variables[v].name));
    }
  }
  return frame;
}

/// Fields as they are read, to be written again.
class StoredFields {
public:
  /// @param read  a field by its name
  template <typename Read>
  StoredFields(const std::vector<std::string>& names, const Read& read) : names_(names) {
    data_.reserve(names.size());
    integers_.resize(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
      data_.push_back(read(names[i]));
      if (data_[i].integers)
        for (const double value : data_[i].values)
          integers_[i].push_back(static_cast<std::int32_t>(value));
    }
  }

  std::vector<results::Field> fields() const {
    std::vector<results::Field> fields;
    for (std::size_t i = 0; i < names_.size(); ++i) {
      fields.push_back(
          {names_[i], data_[i].unit, data_[i].components, std::span<const double>(data_[i].values)});
      if (data_[i].integers)
        fields.back().values = std::span<const std::int32_t>(integers_[i]);
    }
    return fields;
  }

private:
  std::vector<std::string> names_;
  std::vector<results::FieldData> data_;
  std::vector<std::vector<std::int32_t>> integers_;
};

results::BoundaryFaces boundary_faces(const Domain& domain, std::span<const std::string> sources) {
  results::BoundaryFaces faces;
  for (std::size_t f = 0; f < domain.boundary.faces().size(); ++f) {
    const BoundaryFace& face = domain.boundary.faces()[f];
    faces.position.insert(faces.position.end(), {face.position.x, face.position.y});
    faces.normal.insert(faces.normal.end(), {face.ground.normal.x, face.ground.normal.y});
    faces.length.push_back(face.length);
    faces.source.push_back(sources[f]);
  }
  return faces;
}

} // namespace

RunOutput::RunOutput(const std::filesystem::path& directory, const scene::Case& scene,
                     const std::string& plan, Domain& domain, std::span<const std::string> face_sources)
    : scene_(scene), domain_(domain), writer_(directory / "run.h5", description(scene, plan)),
      bodies_(scene, domain, writer_) {
  const scene::Box& box = scene.mesh.box;
  writer_.attribute("mesh_size", scene.mesh.size);
  writer_.attribute("particle_size", 2.0 * domain.half_size());
  writer_.attribute("box", std::vector<double>{box.x_min, box.y_min, box.x_max, box.y_max});
  writer_.attribute("surface_levels",
                    std::vector<double>{scene.boundary.left.surface, scene.boundary.right.surface});
  writer_.attribute("wave", std::string(scene::name(scene.motion.wave)));
  writer_.attribute("angle_deg", scene.motion.angle_deg);
  std::vector<std::string> soils;
  for (const scene::Soil& soil : scene.soils)
    soils.push_back(soil.name);
  writer_.attribute("soil_names", soils);

  std::vector<std::string> columns{"time"};
  std::vector<std::string> units{"s"};
  for (const std::string_view column : EnergyLedger::columns) {
    columns.emplace_back(column);
    units.emplace_back("J/m");
  }
  energy_ = &writer_.add_series("/energy", columns, units);
  add_monitors();
  writer_.set_boundary(boundary_faces(domain, face_sources));
}

void RunOutput::add_monitors() {
  std::vector<std::string> columns{"time", "x", "y", "ux", "uy", "vx", "vy", "ax", "ay"};
  std::vector<std::string> units{"s", "m", "m", "m", "m", "m/s", "m/s", "m/s2", "m/s2"};
  if (scene_.water)
    for (const auto& [name, unit] : monitored_stress) {
      columns.emplace_back(name);
      units.emplace_back(unit);
    }
  for (const scene::Monitor& monitor : scene_.monitors) {
    if (monitor.structure && !domain_.contact.is_elastic(*monitor.structure))
      continue;
    Follower follower;
    std::vector<results::Attribute> attributes;
    if (monitor.structure)
      attributes.push_back({"structure", scene_.structures[*monitor.structure].name});
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s < domain_.sets.size(); ++s) {
      const Particles& set = domain_.sets[s];
      const auto structure = set.body ? std::optional(domain_.contact.structure_of(*set.body)) : std::nullopt;
      if (structure != monitor.structure)
        continue;
      for (std::size_t k = 0; k < set.size(); ++k) {
        const double distance = std::hypot(set.x[k] - monitor.point.x, set.y[k] - monitor.point.y);
        if (distance < nearest) {
          nearest = distance;
          follower.set = s;
          follower.id = set.id[k];
        }
      }
    }
    keep_whole(domain_, follower.set, follower.id);
    follower.path = "/monitors/" + monitor.name;
    follower.series = &writer_.add_series(follower.path, columns, units, attributes);
    followers_.push_back(follower);
  }
}

void RunOutput::after_step(const Stepper& stepper) {
  const double time = stepper.velocity_time();
  bodies_.after_step(stepper);
  if (time >= next_history_) {
    write_history(stepper);
    next_history_ += scene_.output.history_every *
                     std::max(1.0, std::ceil((time - next_history_) / scene_.output.history_every));
  }
  if (time >= next_frame_) {
    write_frame(stepper);
    next_frame_ += scene_.output.every * std::max(1.0, std::ceil((time - next_frame_) / scene_.output.every));
  }
}

void RunOutput::write_history(const Stepper& stepper) {
  const double dt = stepper.dt();
  ++history_rows_;
  last_history_ = stepper.velocity_time();
  std::vector<double> row{last_history_};
  for (const double value : domain_.energy.row())
    row.push_back(value);
  energy_->append(row);
  for (const Follower& follower : followers_) {
    const Particles& set = domain_.sets[follower.set];
    const std::size_t k = set.index_of[follower.id];
    const Vector a = particle_acceleration(domain_, set, k);
    const auto [x, y] = place(set, k, dt);
    std::vector<double> values{stepper.velocity_time(),
                               x,
                               y,
                               x - set.x_initial[k],
                               y - set.y_initial[k],
                               set.vx[k],
                               set.vy[k],
                               a.x,
                               a.y};
    if (scene_.water) {
      WaterFrame water;
      add_water(water, set, k);
      values.insert(values.end(), {set.sxx[k], set.syy[k], set.szz[k], set.sxy[k], water.pressure.front(),
                                   water.ratio.front()});
    }
    follower.series->append(values);
  }
  bodies_.write_history(stepper);
  write_boundary(stepper);
  writer_.flush_if_large();
}

void RunOutput::write_frame(const Stepper& stepper) {
  const Frame frame = collect(domain_, stepper.dt());
  std::vector<results::Field> fields{{"position", "m", 2, frame.position}, {"soil", "1", 1, frame.soil}};
  if (domain_.mesh)
    fields.push_back({"size", "m", 1, frame.size});
  if (wants(scene_, scene::OutputField::displacement))
    fields.push_back({"displacement", "m", 2, frame.displacement});
  if (wants(scene_, scene::OutputField::acceleration))
    fields.push_back({"acceleration", "m/s2", 2, frame.acceleration});
  for (const CarriedField& field : frame.carried)
    if (wants_carried(scene_, field.name))
      fields.push_back({field.name, field.unit, field.components.size(), field.values});
  if (wants(scene_, scene::OutputField::state))
    for (std::size_t v = 0; v < frame.variables.size(); ++v)
      fields.push_back({frame.variables[v].name, frame.variables[v].unit, 1, frame.states[v]});
  for (const auto& [field, unit, components, values] :
       {WaterField{scene::OutputField::pore_pressure, "Pa", 1, frame.water.pressure},
        WaterField{scene::OutputField::excess_pore_pressure, "Pa", 1, frame.water.excess},
        WaterField{scene::OutputField::pore_pressure_ratio, "1", 1, frame.water.ratio},
        WaterField{scene::OutputField::darcy_velocity, "m/s", 2, frame.water.flux}})
    if (wants(scene_, field))
      fields.push_back({scene::name(field), unit, components, values});
  last_frame_ = stepper.velocity_time();
  const ContactFrame contact = bodies_.contact(stepper);
  writer_.write_frame(last_frame_, fields, bodies_.any() ? contact.fields() : std::vector<results::Field>{});
}

void RunOutput::write_boundary(const Stepper& stepper) {
  std::vector<double> v_free, v_domain, traction;
  for (std::size_t f = 0; f < domain_.boundary.faces().size(); ++f) {
    const Boundary& boundary = domain_.boundary;
    v_free.insert(v_free.end(), {boundary.free_field()[f].velocity.x, boundary.free_field()[f].velocity.y});
    v_domain.insert(v_domain.end(), {boundary.velocities()[f].x, boundary.velocities()[f].y});
    const Vector t = boundary.traction(f);
    traction.insert(traction.end(), {t.x, t.y});
  }
  writer_.append_boundary(stepper.time() - stepper.dt(), {v_free, v_domain, traction});
}

void RunOutput::save(results::CheckpointWriter& checkpoint) {
  writer_.sync();
  checkpoint.write("output.rows", std::array<std::uint64_t, 2>{history_rows_, writer_.frame_count()});
  checkpoint.write("output.times", std::array{next_history_, next_frame_, last_history_, last_frame_});
  bodies_.save(checkpoint);
}

void RunOutput::take_over(const std::filesystem::path& before, const results::CheckpointReader& checkpoint) {
  const results::RunReader old(before);
  const auto rows = checkpoint.integers("output.rows");
  take_over_histories(old, rows.at(0));
  for (std::size_t frame = 0; frame < rows.at(1); ++frame)
    take_over_frame(old, frame);
  writer_.sync();
  const auto times = checkpoint.numbers("output.times");
  next_history_ = times.at(0);
  next_frame_ = times.at(1);
  last_history_ = times.at(2);
  last_frame_ = times.at(3);
  bodies_.restore(checkpoint);
}

void RunOutput::take_over_histories(const results::RunReader& before, std::size_t rows) {
  const auto append = [&](const std::string& path, results::TimeSeries& series) {
    const results::SeriesData data = before.series(path);
    const std::size_t width = data.columns.size();
    for (std::size_t row = 0; row < rows; ++row)
      series.append(std::span(data.values).subspan(row * width, width));
  };
  append("/energy", *energy_);
  for (const Follower& follower : followers_)
    append(follower.path, *follower.series);
  for (const auto& [path, series] : bodies_.series())
    append(path, *series);
  const results::BoundaryHistory boundary = before.boundary();
  const std::size_t width = 2 * domain_.boundary.faces().size();
  const auto row_of = [&](const std::vector<double>& values, std::size_t row) {
    return std::span(values).subspan(row * width, width);
  };
  for (std::size_t row = 0; row < rows; ++row)
    writer_.append_boundary(boundary.time.at(row),
                            {row_of(boundary.free_field_velocity, row), row_of(boundary.domain_velocity, row),
                             row_of(boundary.traction, row)});
  history_rows_ = rows;
}

void RunOutput::take_over_frame(const results::RunReader& before, std::size_t frame) {
  std::vector<std::string> names = before.frame_fields(frame);
  std::ranges::stable_sort(names, {}, [](const std::string& name) {
    return std::ranges::find(field_order, name) - field_order.begin();
  });
  const StoredFields particles(names,
                               [&](const std::string& name) { return before.frame_field(frame, name); });
  const StoredFields contact(before.contact_fields(frame),
                             [&](const std::string& name) { return before.contact_field(frame, name); });
  writer_.write_frame(before.frame_times().at(frame), particles.fields(), contact.fields());
}

void RunOutput::finish(const Stepper& stepper, double gravity_seconds, double waiting_seconds) {
  if (stepper.velocity_time() > last_history_)
    write_history(stepper);
  if (stepper.velocity_time() > last_frame_)
    write_frame(stepper);
  std::vector<std::string> names{"gravity stage", "waiting for the exchange"};
  std::vector<double> seconds{gravity_seconds, waiting_seconds};
  for (const Pass& pass : stepper.passes()) {
    names.push_back(pass.name);
    seconds.push_back(pass.seconds);
  }
  writer_.table("/timings", {{{"pass", "1", names}, {"seconds", "s", seconds}}});
  writer_.finish();
}

} // namespace tremolo::mpm_domain
