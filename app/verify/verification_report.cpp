#include "app/verify/verification_report.hpp"

#include "app/output_place.hpp"
#include "base/text/text_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <stdexcept>

namespace tremolo::app {
namespace {

constexpr const char* json_beginning = "{\n  \"schema_version\": ";
constexpr const char* verification_content = "verification";

nlohmann::ordered_json to_json(const Verification& verification, const scene::Case& scene,
                               const std::string& run_name) {
  nlohmann::ordered_json json = {
      {"schema_version", results::schema_version},
      {"run", run_name},
      {"wave", scene::name(scene.motion.wave)},
      {"angle_deg", scene.motion.angle_deg},
      {"base", scene::name(scene.boundary.base.form)},
      {"mesh_size", scene.mesh.size},
      {"tolerance", scene.verify_tolerance},
      {"passed", passed(verification, scene)},
      {"boundary_width", verification.particles.boundary_width},
  };
  if (verification.energy_residual)
    json["energy_residual"] = *verification.energy_residual;
  for (const Agreement& region : verification.particles.regions)
    json["regions"].push_back({{"name", region.name},
                               {"particles", region.particles},
                               {"relative_l2", region.relative_l2},
                               {"peak_error", region.peak_error},
                               {"phase_lag", region.phase_lag}});
  return json;
}

std::vector<results::NamedTable> tables(const Verification& verification) {
  const ParticleAgreement& particles = verification.particles;
  std::vector<results::NamedTable> all{{"/particles",
                                        {{{"x", "m", particles.x},
                                          {"y", "m", particles.y},
                                          {"relative_error", "1", particles.relative_error}}}}};
  std::vector<std::string> names;
  std::vector<double> x, y;
  for (const PointHistory& point : verification.points) {
    names.push_back(point.name);
    x.push_back(point.x);
    y.push_back(point.y);
    all.push_back({"/histories/" + point.name,
                   {{{"time", "s", point.time},
                     {"exact_vx", "m/s", point.exact_vx},
                     {"exact_vy", "m/s", point.exact_vy},
                     {"vx", "m/s", point.vx},
                     {"vy", "m/s", point.vy}}}});
  }
  all.push_back({"/points", {{{"name", "1", names}, {"x", "m", x}, {"y", "m", y}}}});
  return all;
}

} // namespace

bool passed(const Verification& verification, const scene::Case& scene) {
  return verification.particles.regions.front().relative_l2 <= scene.verify_tolerance;
}

std::string text(const Verification& verification, const scene::Case& scene) {
  std::string out = fmt::format("{}: {} at {:g} degrees, base {}, h = {:g} m\n", scene.title,
                                scene::name(scene.motion.wave), scene.motion.angle_deg,
                                scene::name(scene.boundary.base.form), scene.mesh.size);
  out += fmt::format("{:<11} {:>10} {:>12} {:>11} {:>13}\n", "region", "particles", "relative L2",
                     "peak error", "phase lag");
  for (const Agreement& region : verification.particles.regions)
    out += fmt::format("{:<11} {:>10} {:>10.3f} % {:>9.3f} % {:>10.4f} ms\n", region.name, region.particles,
                       100.0 * region.relative_l2, 100.0 * region.peak_error, 1000.0 * region.phase_lag);
  out += fmt::format("near: within {:g} m\n", verification.particles.boundary_width);
  if (verification.energy_residual)
    out += fmt::format("energy ledger: largest residual {:.3f} % of the largest kinetic energy\n",
                       100.0 * *verification.energy_residual);
  out +=
      fmt::format("{}: relative L2 of the whole {:.3f} %, tolerance {:g} %\n",
                  passed(verification, scene) ? "passed" : "FAILED",
                  100.0 * verification.particles.regions.front().relative_l2, 100.0 * scene.verify_tolerance);
  return out;
}

void require_report_writable(const std::filesystem::path& run_file) {
  const std::filesystem::path folder = run_file.parent_path();
  require_writable_in(folder,
                      {{"verify.json", begins_with(json_beginning)},
                       {"verify.h5", has_content(verification_content)},
                       {"verify.png", is_picture_of_tremolo}},
                      {run_file});
}

void write_report(const Verification& verification, const scene::Case& scene,
                  const std::filesystem::path& run_file) {
  const std::filesystem::path folder = run_file.parent_path();
  write_text_file(folder / "verify.json",
                  to_json(verification, scene, run_file.filename().string()).dump(2) + "\n");
  results::write_tables(folder / "verify.h5", verification_content, tables(verification));
}

} // namespace tremolo::app
