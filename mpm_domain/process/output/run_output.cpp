#include "mpm_domain/process/output/run_output.hpp"

#include "mpm_domain/head/phreatic_line.hpp"
#include "mpm_domain/process/output/add_history.hpp"
#include "mpm_domain/process/output/drift_table.hpp"
#include "mpm_domain/process/output/frames/soil_frame.hpp"
#include "mpm_domain/process/output/frames/structure_frame.hpp"
#include "results/run_checksums.hpp"
#include "results/stored_fields.hpp"
#include "scene/plan/output/intervals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

/// Fields of a frame, before those of the laws.
constexpr std::array<std::string_view, 7> field_order{"position",     "soil",   "displacement", "velocity",
                                                      "acceleration", "stress", "volume"};

constexpr const char* table_path = "/shaking_table";

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
                     const std::string& plan, Domain& domain, std::span<const Particles> start,
                     const Snapshot& snapshot, std::span<const std::string> face_sources)
    : scene_(scene), domain_(domain), snapshot_(snapshot),
      writer_(directory / "run.h5", description(scene, plan)), bodies_(scene, domain, writer_),
      linings_(domain, writer_), props_(domain, writer_), sections_(scene, domain, writer_),
      sliding_masses_(scene, writer_),
      lost_hold_(domain, start, domain.boundary, scene.boundary.base.form != scene::BaseForm::incident,
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
  add_monitors(start);
  add_lines(start);
  for (const Followers& followers : followers_)
    for (const FollowedPoint& point : followers.points)
      point.add_followed(followed_);
  writer_.set_boundary(boundary_faces(domain, face_sources));
}

void RunOutput::add_monitors(std::span<const Particles> start) {
  for (const scene::Monitor& monitor : scene_.monitors) {
    if (monitor.structure && !domain_.contact.is_elastic(*monitor.structure))
      continue;
    std::vector<results::Attribute> attributes;
    if (monitor.structure)
      attributes.push_back({"structure", scene_.structures[*monitor.structure].name});
    const FollowedPoint point(domain_, start, monitor.point, monitor.structure);
    add_followers("/monitors/" + monitor.name, {point}, attributes, false);
  }
}

void RunOutput::add_lines(std::span<const Particles> start) {
  for (const scene::Line& line : scene_.lines) {
    std::vector<FollowedPoint> points;
    for (const scene::Point& position : scene::points_along(line.from, line.to, line.spacing)) {
      const FollowedPoint point(domain_, start, position);
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

Snapshot::Extent RunOutput::needs(const Stepper& stepper) const {
  const double time = stepper.time_of_soil();
  return {time >= next_history_, time >= next_frame_};
}

Snapshot::Extent RunOutput::needs_to_finish(const Stepper& stepper) const {
  const double time = stepper.time_of_soil();
  return {time > last_history_, time > last_frame_};
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
  const SoilFrame soil(domain_, stepper, scene_);
  const StructureFrame structures(domain_, stepper);
  last_frame_ = time;
  bodies_.write_outlines(stepper);
  const std::vector<results::Field> of_contact =
      bodies_.any() ? contact.fields() : std::vector<results::Field>{};
  const std::vector<results::Field> of_structures = structures.fields(scene_);
  writer_.write_frame(
      last_frame_, soil.particle_count(snapshot_.all()), soil.fields(snapshot_.all()),
      std::vector<results::FramePart>{{"contact", of_contact}, {"structures", of_structures}});
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
  std::vector<results::FieldShape> shapes;
  for (const std::string& name : names)
    shapes.push_back(before.frame_field_shape(frame, name));
  std::vector<results::StreamedField> fields; // never all in memory
  for (std::size_t n = 0; n < names.size(); ++n)
    fields.push_back({names[n], shapes[n].unit, shapes[n].components, shapes[n].integers,
                      [&before, frame, &name = names[n]](const auto& take) {
                        before.frame_field_in_pieces(frame, name, take);
                      }});
  std::vector<results::StoredFields> parts;
  std::vector<std::vector<results::Field>> fields_of;
  std::vector<results::FramePart> written;
  for (const std::string_view group : results::frame_parts)
    parts.emplace_back(before.part_fields(group, frame),
                       [&](const std::string& name) { return before.part_field(group, frame, name); });
  for (const results::StoredFields& part : parts)
    fields_of.push_back(part.fields());
  for (std::size_t n = 0; n < parts.size(); ++n)
    written.push_back({results::frame_parts[n], fields_of[n]});
  const std::size_t particles = shapes.empty() ? 0 : shapes.front().particles;
  writer_.write_frame(before.frame_times().at(frame), particles, std::move(fields), written);
}

void RunOutput::write_last(const Stepper& stepper) {
  const auto [history, frame] = needs_to_finish(stepper);
  if (history)
    write_history(stepper);
  if (frame)
    write_frame(stepper, stepper.time_of_soil(), bodies_.contact(stepper));
}

std::optional<std::string> RunOutput::finish(const Stepper& stepper, double gravity_seconds,
                                             double waiting_seconds) {
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
