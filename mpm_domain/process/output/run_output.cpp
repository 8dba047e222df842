#include "mpm_domain/process/output/run_output.hpp"

#include "mpm_domain/head/phreatic_line.hpp"
#include "mpm_domain/process/output/add_history.hpp"
#include "mpm_domain/process/output/drift_table.hpp"
#include "results/run_checksums.hpp"
#include "results/stored_fields.hpp"
#include "scene/plan/output/intervals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

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
  return std::ranges::find(scene.output.fields, field) != scene.output.fields.end();
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

constexpr const char* table_path = "/shaking_table";

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

void add_water(WaterFrame& frame, const Particles& set, std::size_t k, double speed_of_time) {
  const WaterState state = water_state(set, k);
  frame.pressure.push_back(state.pressure);
  frame.excess.push_back(state.excess);
  frame.ratio.push_back(state.ratio);
  frame.flux.insert(frame.flux.end(), {state.flux.x / speed_of_time, state.flux.y / speed_of_time});
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

/// The fields of frames that the table of particle fields names, in its order, and fields of one's own.
std::vector<CarriedField> carried_fields(const Domain& domain) {
  std::vector<CarriedField> fields;
  domain.sets.front().for_fields([&](const ParticleFieldDescription& line, const std::vector<double>&) {
    const std::string& name = line.in_frames();
    if (!name.empty()) {
      auto known = std::ranges::find(fields, name, &CarriedField::name);
      if (known == fields.end())
        known = fields.insert(known, {name, line.unit, {}, {}});
      known->components.push_back(line.name);
    }
  });
  return fields;
}

/// The names of the soils. Slices of one soil stand one behind the other and have its name.
std::vector<std::string> soil_names(const Spec& spec) {
  std::vector<std::string> names;
  for (const Soil& soil : spec.soils)
    if (names.empty() || names.back() != soil.name)
      names.push_back(soil.name);
  return names;
}

/// Makes room for so many particles, so that no array grows to twice what it needs.
void reserve(Frame& frame, std::size_t particles) {
  for (std::vector<double>* vectors : {&frame.position, &frame.displacement, &frame.acceleration})
    vectors->reserve(2 * particles);
  frame.soil.reserve(particles);
  for (CarriedField& field : frame.carried)
    field.values.reserve(field.components.size() * particles);
  for (std::vector<double>& state : frame.states)
    state.reserve(particles);
}

/// @param has_water  whether there is a water table, without which no field of the pore water is written
Frame collect(const Domain& domain, const Snapshot& snapshot, const Stepper& stepper, bool has_water) {
  const double n = stepper.speed_of_time();
  const std::vector<std::string> names = soil_names(domain.spec);
  Frame frame;
  frame.carried = carried_fields(domain);
  frame.variables = all_state_variables(domain);
  frame.states.resize(frame.variables.size());
  std::size_t particles = 0;
  for (const Particles& set : snapshot.sets_of_soil())
    particles += set.size();
  reserve(frame, particles);
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
    std::vector<std::vector<const std::vector<double>*>> carried; // by field and component
    for (const CarriedField& field : frame.carried) {
      std::vector<const std::vector<double>*>& components = carried.emplace_back();
      for (const std::string& component : field.components)
        components.push_back(columns.at(component));
    }
    for (const std::uint32_t k : set.index_of) {
      if (k == Particles::nowhere)
        continue;
      const Vector acceleration = snapshot.acceleration(s, k);
      const auto [x, y] = place(set, k, stepper.dt());
      frame.position.insert(frame.position.end(), {x, y});
      const Vector moved = displacement(set, k, stepper.dt());
      frame.displacement.insert(frame.displacement.end(), {moved.x, moved.y});
      frame.acceleration.insert(frame.acceleration.end(),
                                {acceleration.x / (n * n), acceleration.y / (n * n)});
      for (std::size_t f = 0; f < carried.size(); ++f)
        for (const std::vector<double>* component : carried[f])
          frame.carried[f].values.push_back((*component)[k]);
      if (has_water)
        add_water(frame.water, set, k, n);
      frame.soil.push_back(name);
      if (domain.mesh)
        frame.size.push_back(2.0 * set.half_size);
      for (std::size_t v = 0; v < frame.variables.size(); ++v)
        frame.states[v].push_back(state_value(set, k, frame.variables[v].name));
    }
  }
  return frame;
}

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
                     const std::string& plan, Domain& domain, const Snapshot& snapshot,
                     std::span<const std::string> face_sources)
    : scene_(scene), domain_(domain), snapshot_(snapshot),
      writer_(directory / "run.h5", description(scene, plan)), bodies_(scene, domain, writer_),
      linings_(domain, writer_), props_(domain, writer_), sections_(scene, domain, writer_),
      sliding_masses_(scene, writer_),
      lost_hold_(domain, domain.boundary, scene.boundary.base.form != scene::BaseForm::incident,
                 scene.mesh.size) {
  const scene::Box& box = scene.mesh.box;
  writer_.attribute("mesh_size", scene.mesh.size);
  writer_.attribute("particle_size", 2.0 * domain.half_size());
  writer_.attribute("box", std::vector<double>{box.x_min, box.y_min, box.x_max, box.y_max});
  writer_.attribute("surface_levels",
                    std::vector<double>{scene.boundary.left.surface, scene.boundary.right.surface});
  writer_.attribute("wave", std::string(scene::name(scene.motion.wave)));
  writer_.attribute("angle_deg", scene.motion.angle_deg);
  if (scene.vertical)
    writer_.attribute("vertical_angle_deg", scene.vertical->angle_deg);
  writer_.attribute("soil_names", soil_names(domain.spec));
  if (domain.head && domain.head->level() != nullptr)
    writer_.attribute("water_table", *domain.head->level());
  else if (domain.head)
    writer_.attribute("phreatic_line", phreatic_line(domain.spec, *domain.head));

  std::vector<std::string> columns{"time"};
  std::vector<std::string> units{"s"};
  columns.insert(columns.end(), energy_columns.begin(), energy_columns.end());
  units.resize(columns.size(), "J/m");
  energy_ = &writer_.add_series("/energy", columns, units);
  if (domain.spec.rigid_base)
    table_ = &add_history(writer_, table_path, table_columns);
  add_monitors();
  add_lines();
  writer_.set_boundary(boundary_faces(domain, face_sources));
}

void RunOutput::add_monitors() {
  for (const scene::Monitor& monitor : scene_.monitors) {
    if (monitor.structure && !domain_.contact.is_elastic(*monitor.structure))
      continue;
    std::vector<results::Attribute> attributes;
    if (monitor.structure)
      attributes.push_back({"structure", scene_.structures[*monitor.structure].name});
    const FollowedPoint point(domain_, monitor.point, monitor.structure);
    add_followers("/monitors/" + monitor.name, {point}, attributes, false);
  }
}

void RunOutput::add_lines() {
  for (const scene::Line& line : scene_.lines) {
    std::vector<FollowedPoint> points;
    for (const scene::Point& place : scene::points_along(line.from, line.to, line.spacing)) {
      const FollowedPoint point(domain_, place);
      // A line may be finer than the particles.
      if (points.empty() || !(points.back() == point))
        points.push_back(point);
    }
    add_followers("/lines/" + line.name, points, {}, true);
  }
}

void RunOutput::add_followers(const std::string& path, const std::vector<FollowedPoint>& points,
                              std::span<const results::Attribute> attributes, bool numbered) {
  std::vector<std::string> names{"time"};
  std::vector<std::string> units{"s"};
  for (std::size_t k = 0; k < points.size(); ++k)
    for (const auto& [name, unit] : FollowedPoint::columns(scene_)) {
      names.push_back(numbered ? fmt::format("{}{}", name, k) : std::string(name));
      units.emplace_back(unit);
    }
  followers_.push_back({path, points, &writer_.add_series(path, names, units, attributes)});
}

std::vector<ParticleName> RunOutput::followed() const {
  std::vector<ParticleName> particles;
  for (const Followers& followers : followers_)
    for (const FollowedPoint& point : followers.points)
      point.add_followed(particles);
  sliding_masses_.add_followed(domain_.sets_of_soil(), particles);
  return particles;
}

Snapshot::Extent RunOutput::needs(const Stepper& stepper) const {
  const double time = stepper.time_of_soil();
  if (time >= next_frame_)
    return Snapshot::Extent::all;
  return time >= next_history_ ? Snapshot::Extent::followed : Snapshot::Extent::nothing;
}

Snapshot::Extent RunOutput::needs_to_finish(const Stepper& stepper) const {
  const double time = stepper.time_of_soil();
  if (time > last_frame_)
    return Snapshot::Extent::all;
  return time > last_history_ ? Snapshot::Extent::followed : Snapshot::Extent::nothing;
}

void RunOutput::after_step(const Stepper& stepper) {
  const double time = stepper.time_of_soil();
  bodies_.after_step(stepper);
  if (time >= next_history_) {
    write_history(stepper);
    next_history_ = scene::next_row(scene_, next_history_, time);
  }
  if (time >= next_frame_) {
    write_frame(stepper, time, bodies_.contact(stepper));
    next_frame_ = scene::next_frame(scene_, next_frame_, time);
  }
}

void RunOutput::write_history(const Stepper& stepper) {
  ++history_rows_;
  last_history_ = stepper.time_of_soil();
  std::vector<double> row{last_history_};
  for (const double value : domain_.energy.row())
    row.push_back(value);
  energy_->append(row);
  for (const Followers& followers : followers_) {
    std::vector<double> values{last_history_};
    for (const FollowedPoint& point : followers.points)
      point.append_values(snapshot_, stepper, scene_.water.has_value(), values);
    followers.series->append(values);
  }
  if (table_ != nullptr) {
    const auto [u, v, a] = stepper.domain().boundary.base_motion();
    table_->append(std::array{last_history_, u.x, u.y, v.x, v.y, a.x, a.y});
  }
  sliding_masses_.write_history(snapshot_, stepper);
  bodies_.write_history(stepper);
  linings_.write_history(stepper);
  props_.write_history(stepper);
  sections_.write_history(stepper);
  write_boundary(stepper);
  writer_.flush_if_large();
}

void RunOutput::write_frame(const Stepper& stepper, double time, const ContactFrame& contact) {
  const Frame frame = collect(domain_, snapshot_, stepper, scene_.water.has_value());
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
  last_frame_ = time;
  bodies_.write_outlines(stepper);
  writer_.write_frame(last_frame_, fields, bodies_.any() ? contact.fields() : std::vector<results::Field>{});
}

void RunOutput::write_boundary(const Stepper& stepper) {
  std::vector<double> v_free, v_domain, traction;
  const double n = stepper.speed_of_time();
  for (std::size_t f = 0; f < domain_.boundary.faces().size(); ++f) {
    const Boundary& boundary = domain_.boundary;
    const Vector& field = boundary.free_field()[f].velocity;
    v_free.insert(v_free.end(), {field.x / n, field.y / n});
    v_domain.insert(v_domain.end(), {boundary.velocities()[f].x / n, boundary.velocities()[f].y / n});
    const Vector t = boundary.traction(f);
    traction.insert(traction.end(), {t.x, t.y});
  }
  const double simulated = stepper.time() - stepper.dt();
  lost_hold_.add(simulated, domain_.boundary.velocities(), domain_.boundary.free_field());
  writer_.append_boundary(stepper.time_of_soil(simulated), {v_free, v_domain, traction});
}

std::optional<std::string> RunOutput::warning() const {
  return scene_.gravity ? lost_hold_.warning() : std::nullopt;
}

std::optional<std::string> RunOutput::note() const {
  return scene_.gravity ? lost_hold_.report() : std::nullopt;
}

void RunOutput::save(results::CheckpointWriter& checkpoint) {
  writer_.sync();
  checkpoint.write("output.rows", std::array<std::uint64_t, 2>{history_rows_, writer_.frame_count()});
  checkpoint.write_text(std::string(results::checksums_name), results::checksum_text(writer_.checksums()));
  state().save("output", checkpoint);
}

SavedNumbers RunOutput::state() {
  SavedNumbers state;
  state.add(next_history_, next_frame_, last_history_, last_frame_);
  bodies_.add_state(state);
  lost_hold_.add_state(state);
  return state;
}

void RunOutput::take_over(const std::filesystem::path& before, const results::CheckpointReader& checkpoint) {
  const results::RunReader old(before);
  const auto rows = checkpoint.integers("output.rows");
  take_over_histories(old, rows.at(0), rows.at(1));
  for (std::size_t frame = 0; frame < rows.at(1); ++frame)
    take_over_frame(old, frame);
  writer_.sync();
  state().restore("output", checkpoint);
}

void RunOutput::take_over_histories(const results::RunReader& before, std::size_t rows, std::size_t frames) {
  const auto append_rows = [&](const std::string& path, results::TimeSeries& series, std::size_t count) {
    const results::SeriesData data = before.series(path);
    for (std::size_t row = 0; row < count; ++row)
      series.append(std::span(data.values).subspan(row * data.columns.size(), data.columns.size()));
  };
  const auto append = [&](const std::string& path, results::TimeSeries& series) {
    append_rows(path, series, rows);
  };
  append("/energy", *energy_);
  if (table_ != nullptr)
    append(std::string(table_path), *table_);
  for (const Followers& followers : followers_)
    append(followers.path, *followers.series);
  for (const auto* const part : {&sliding_masses_.series(), &bodies_.series(), &linings_.series(),
                                 &props_.series(), &sections_.series()})
    for (const auto& [path, series] : *part)
      append(path, *series);
  for (const auto& [path, series] : bodies_.outlines())
    append_rows(path, *series, frames);
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
  const results::StoredFields particles(
      names, [&](const std::string& name) { return before.frame_field(frame, name); });
  const results::StoredFields contact(before.contact_fields(frame), [&](const std::string& name) {
    return before.contact_field(frame, name);
  });
  writer_.write_frame(before.frame_times().at(frame), particles.fields(), contact.fields());
}

std::optional<std::string> RunOutput::finish(const Stepper& stepper, double gravity_seconds,
                                             double waiting_seconds) {
  if (stepper.time_of_soil() > last_history_)
    write_history(stepper);
  if (stepper.time_of_soil() > last_frame_)
    write_frame(stepper, stepper.time_of_soil(), bodies_.contact(stepper));
  std::vector<std::string> names{"gravity stage", "waiting for the exchange"};
  std::vector<double> seconds{gravity_seconds, waiting_seconds};
  for (const PassTime& pass : stepper.times()) {
    names.push_back(pass.name);
    seconds.push_back(pass.seconds);
  }
  if (const auto faces = lost_hold_.faces(); scene_.gravity && !faces.empty())
    writer_.table("/drift", drift_table(faces));
  writer_.table("/timings", {{{"pass", "1", names}, {"seconds", "s", seconds}}});
  return writer_.finish();
}

} // namespace tremolo::mpm_domain
