// What reduced dispersion makes of a slope that yields, which a case file may not ask for: the slope of
// cases/slope_oblique/uniform.toml on other cells, in one process, read as a case with plain dispersion that
// is changed behind the rules of a scene. Laws see the mean change of volume of their cell. Prints CSV:
//
//     cost_yielding_slope CASE plain|reduced CELL_SIZE ANGLE_DEG [END_S [THREADS]]
//
// When it fails, as `tremolo failure` tells it, at mean plastic strains of a cell of 0.05, 0.1 and 0.2; how
// far the tip of the soil that lay above the toe is before the toe at the end; the area of cells with a mean
// strain of at least 0.1, 0.3 s after failure; steps of the gravity stage.

#include "base/text/text_file.hpp"
#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/process/spec_from_case.hpp"
#include "mpm_domain/step/stepper.hpp"
#include "scene/case.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace tremolo;
using mpm_domain::Particles;
using Cell = std::pair<long, long>;

constexpr double toe_x = 40.0, crest_y = 10.0; // m
constexpr std::array strains{0.05, 0.1, 0.2};

std::string replaced(std::string text, std::string_view old, std::string_view by) {
  const std::size_t at = text.find(old);
  if (at == std::string::npos)
    throw std::runtime_error(fmt::format("the case has no '{}'", old));
  return text.replace(at, old.size(), by);
}

scene::Case slope(const std::filesystem::path& file, double cell_size, double angle_deg,
                  mpm_domain::Dispersion dispersion) {
  std::string text = read_text_file(file);
  text = replaced(text, "\nsize = 0.5", fmt::format("\nsize = {:.6f}", cell_size));
  text = replaced(text, "dilatation = \"particle\"", "dilatation = \"cell\"");
  text = replaced(text, "angle_deg = 15.0", fmt::format("angle_deg = {:.6f}", angle_deg));
  scene::Case scene = scene::parse(text, file, file.parent_path());
  scene.mesh.dispersion = dispersion;
  return scene;
}

/// The free field on one vertical line, x = 0, at some levels.
class Line {
public:
  Line(const wavefield::LayeredField& field, std::vector<double> levels, wavefield::Part part, double width,
       double end)
      : levels_(std::move(levels)), slowness_(field.slowness_x()),
        start_(-slowness_ * width - 2.0 * interval) {
    std::ranges::sort(levels_);
    levels_.erase(std::ranges::unique(levels_).begin(), levels_.end());
    std::vector<wavefield::Point> points;
    for (const double level : levels_)
      points.push_back({0.0, level});
    const auto count = static_cast<std::size_t>(std::ceil((end - start_) / interval)) + 3;
    histories_ = field.sample(points, {start_, interval, count}, part,
                              {.displacement = false, .strain = false, .rates = false});
  }

  eq6::FreeField at(double x, double level, double time) const {
    const auto row = static_cast<std::size_t>(std::ranges::lower_bound(levels_, level) - levels_.begin());
    const wavefield::History& h = histories_.at(row);
    const double steps = (time - slowness_ * x - start_) / interval;
    const auto step = static_cast<std::size_t>(steps);
    const auto of = [&](const std::vector<double>& series) {
      return std::lerp(series.at(step), series.at(step + 1), steps - std::floor(steps));
    };
    return {{of(h.vx), of(h.vy)}, {of(h.sxx), of(h.syy), of(h.sxy)}};
  }

private:
  static constexpr double interval = 0.002; // s: the motion has frequencies up to 25 Hz
  std::vector<double> levels_;
  double slowness_, start_;
  std::vector<wavefield::History> histories_;
};

/// The free field of all faces, where they were at the start.
class FaceFields {
public:
  FaceFields(const mpm_domain::Domain& domain, const scene::Case& scene)
      : faces_(domain.boundary.faces().begin(), domain.boundary.faces().end()) {
    using mpm_domain::Side;
    const auto line = [&](Side side, double surface, wavefield::Part part) {
      std::vector<double> levels;
      for (const mpm_domain::BoundaryFace& face : faces_)
        if (face.side == side)
          levels.push_back(face.position.y);
      lines_.emplace(side, Line(wavefield::elastic_field(scene, {}, surface).waves().front(), levels, part,
                                domain.spec.box.x_max, scene.end()));
    };
    line(Side::left, scene.boundary.left.surface, wavefield::Part::total);
    line(Side::right, scene.boundary.right.surface, wavefield::Part::total);
    line(Side::base, scene.boundary.left.surface, wavefield::Part::incident);
  }

  void take(double time, std::span<eq6::FreeField> field) const {
    for (std::size_t f = 0; f < field.size(); ++f)
      field[f] = lines_.at(faces_[f].side).at(faces_[f].position.x, faces_[f].position.y, time);
  }

private:
  std::vector<mpm_domain::BoundaryFace> faces_;
  std::map<mpm_domain::Side, Line> lines_;
};

/// Cells of the undeformed model whose mean plastic strain is at least so large.
std::set<Cell> band(const mpm_domain::Domain& domain, double strain) {
  std::map<Cell, std::pair<double, int>> sums;
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k) {
      auto& [sum, count] = sums[{std::lround(std::floor(set.x_initial[k] / domain.grid.h)),
                                 std::lround(std::floor(set.y_initial[k] / domain.grid.h))}];
      sum += set.state[k * set.state_size + materials::equivalent_plastic_strain];
      ++count;
    }
  std::set<Cell> cells;
  for (const auto& [cell, sum] : sums)
    if (sum.first >= strain * sum.second)
      cells.insert(cell);
  return cells;
}

/// Whether one piece of a band comes within a fifth of the slope's height of the toe, and within two cells of
/// the ground behind the crest.
bool connects(std::set<Cell> cells, double h) {
  while (!cells.empty()) {
    std::vector<Cell> edge{*cells.begin()};
    cells.erase(cells.begin());
    bool at_toe = false, at_crest = false;
    while (!edge.empty()) {
      const auto [i, j] = edge.back();
      edge.pop_back();
      const double x = (double(i) + 0.5) * h, y = (double(j) + 0.5) * h;
      at_toe |= std::hypot(x - toe_x, y) <= 0.2 * crest_y;
      at_crest |= y >= crest_y - 2.0 * h;
      for (const long a : {-1, 0, 1})
        for (const long b : {-1, 0, 1})
          if (cells.erase({i + a, j + b}) > 0)
            edge.push_back({i + a, j + b});
    }
    if (at_toe && at_crest)
      return true;
  }
  return false;
}

/// How far soil that lay above the toe has come before it, m.
double run_out(const mpm_domain::Domain& domain) {
  double reach = 0.0;
  for (const Particles& set : domain.sets)
    for (std::size_t k = 0; k < set.size(); ++k)
      if (set.y_initial[k] > 0.0)
        reach = std::max(reach, toe_x - set.x[k]);
  return reach;
}

std::string told(const std::optional<double>& value) {
  return value ? fmt::format("{:.3g}", *value) : "-";
}

void run(const std::filesystem::path& file, mpm_domain::Dispersion dispersion, double cell_size,
         double angle_deg, std::optional<double> end, int threads) {
  scene::Case scene = slope(file, cell_size, angle_deg, dispersion);
  mpm_domain::Domain domain(mpm_domain::spec_from_case(scene, threads));
  long gravity_steps = 0;
  mpm_domain::replace_constraints(
      domain, mpm_domain::relax_under_gravity(domain, {scene.gravity->residual, scene.gravity->max_time},
                                              [&](long step, double residual) {
                                                gravity_steps = step;
                                                if (step % 1000 == 0)
                                                  fmt::print(stderr, "gravity {} {:.3g}\n", step, residual);
                                              }));
  const FaceFields fields(domain, scene);
  mpm_domain::Stepper stepper(
      domain, 0.0, [&](long, double t, auto, std::span<eq6::FreeField> field) { fields.take(t, field); });
  std::array<std::optional<double>, strains.size()> fails;
  std::optional<double> area;
  const double last = end.value_or(scene.end());
  for (double look = 0.1; stepper.time() < last; look += 0.1) {
    while (stepper.time() < std::min(look, last))
      stepper.step();
    for (std::size_t s = 0; s < strains.size(); ++s)
      if (!fails[s] && connects(band(domain, strains[s]), domain.grid.h))
        fails[s] = look;
    if (!area && fails[1] && look > *fails[1] + 0.25)
      area = double(band(domain, strains[1]).size()) * std::pow(domain.grid.h, 2);
  }
  fmt::print("{},{:g},{:g},{},{},{},{},{:.3g},{:.2f},{}\n", name(dispersion), cell_size, angle_deg,
             told(fails[0]), told(fails[1]), told(fails[2]), told(area), run_out(domain), stepper.time(),
             gravity_steps);
}

} // namespace

int main(int argc, char** argv) {
  if (argc < 5) {
    fmt::print(stderr, "usage: {} CASE plain|reduced CELL_SIZE ANGLE_DEG [END_S [THREADS]]\n", argv[0]);
    return 2;
  }
  fmt::print("dispersion,cell_m,angle_deg,fails_0.05_s,fails_0.1_s,fails_0.2_s,bands_m2,run_out_m,end_s,"
             "gravity_steps\n");
  run(argv[1],
      std::string_view(argv[2]) == "reduced" ? mpm_domain::Dispersion::reduced
                                             : mpm_domain::Dispersion::plain,
      std::atof(argv[3]), std::atof(argv[4]), argc > 5 ? std::optional(std::atof(argv[5])) : std::nullopt,
      argc > 6 ? std::atoi(argv[6]) : 1);
}
