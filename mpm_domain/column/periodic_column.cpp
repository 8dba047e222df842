// Time levels: stress belongs to t_n, grid velocities to t_n -+ dt/2, so that
//
//     v(t_n) = v- + dt/2 a,      d sigma/dt (t_n) = (sigma(t_n+1) - sigma(t_n-1))/(t_n+1 - t_n-1).
//
// At the base the stress is that of Eq. (6) with this velocity, which is what the base's nodes have felt. The
// base has no particle: its displacement is the sum of dt v-. Where water flows, v is that of grains and
// water together and without the residual that dashpots do not see (boundary.hpp). Strains are slopes of the
// displacement over the levels of the start.

#include "mpm_domain/column/periodic_column.hpp"

#include "mpm_domain/gravity/static_traction.hpp"
#include "mpm_domain/particles/water/rest_pressure.hpp"
#include "mpm_domain/step/time_step.hpp"
#include "mpm_domain/strain/total_stress.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

PeriodicColumnSpec checked(PeriodicColumnSpec spec) {
  if (spec.time_step && !(*spec.time_step > 0.0 && std::isfinite(*spec.time_step)))
    throw std::invalid_argument(
        "a periodic column needs a finite interval > 0 between the states that it serves");
  spec.domain.sides = Sides::periodic;
  spec.domain.scheme.dt.reset();
  return spec;
}

eq6::Stress operator-(const eq6::Stress& a, const eq6::Stress& b) {
  return {a.xx - b.xx, a.yy - b.yy, a.xy - b.xy};
}

eq6::Stress operator*(double factor, const eq6::Stress& s) {
  return {factor * s.xx, factor * s.yy, factor * s.xy};
}

} // namespace

PeriodicColumn::PeriodicColumn(PeriodicColumnSpec spec)
    : spec_(checked(std::move(spec))), domain_(spec_.domain) {
  if (spec_.domain.gravity > 0.0)
    replace_constraints(domain_, relax_under_gravity(domain_, {}, [](long, double) {}));
  for (BoundaryFace& face : domain_.boundary.faces()) {
    face.ground.impedance_p = spec_.half_space.density * spec_.half_space.p_wave_speed();
    face.ground.impedance_s = spec_.half_space.density * spec_.half_space.s_wave_speed();
  }
  struct Position {
    double y;
    std::size_t set;
    std::uint32_t id;
  };
  std::vector<Position> positions;
  for (std::size_t s = 0; s < domain_.sets.size(); ++s) {
    const Particles& set = domain_.sets[s];
    for (std::size_t k = 0; k < set.size(); ++k)
      if (set.x[k] - spec_.domain.box.x_min < 2.0 * domain_.half_size())
        positions.push_back({set.y[k], s, set.id[k]});
  }
  std::ranges::sort(positions, {}, &Position::y);
  levels_.push_back(spec_.domain.box.y_min);
  for (const Position& position : positions) {
    sets_.push_back(position.set);
    ids_.push_back(position.id);
    levels_.push_back(position.y);
  }
  levels_.push_back(positions.back().y + domain_.half_size());
  points_.resize(levels_.size());
  find_wet_cells();

  velocity_before_.resize(levels_.size());
  if (!spec_.time_step)
    spec_.time_step = domain_.spec.scheme.fraction * critical_time_step(domain_, 0.0);
  cut_interval();
  stepper_ = std::make_unique<Stepper>(domain_, spec_.start_time, [this](long, double t, auto, auto field) {
    const Grid& grid = domain_.grid;
    sample_nodes(velocity_before_, [&grid](std::size_t n) { return grid.mixture_before(n); });
    base_displacement_.x += previous_dt_ * velocity_before_.front().x;
    base_displacement_.y += previous_dt_ * velocity_before_.front().y;
    std::ranges::fill(field, spec_.incident(t));
  });
  at_rest_ = before_ = now_ = rows();
  time_ = spec_.start_time;
  previous_dt_ = *domain_.spec.scheme.dt;
  advance();
}

void PeriodicColumn::find_wet_cells() {
  const auto cell_of = [&](std::size_t row) {
    return std::floor((levels_[row + 1] - spec_.domain.box.y_min) / spec_.domain.cell_size);
  };
  const auto wet = [&](std::size_t row) { return domain_.sets[sets_[row]].traits.wet; };
  for (std::size_t r = 0; r < ids_.size(); ++r) {
    if (!wet(r))
      continue;
    if (r == 0 || !wet(r - 1) || cell_of(r) != cell_of(r - 1))
      wet_cells_.push_back({.first_row = r});
    WetCell& cell = wet_cells_.back();
    cell.end_row = r + 1;
    cell.y = 0.5 * (levels_[cell.first_row + 1] + levels_[r + 1]);
  }
}

double PeriodicColumn::pore_pressure_at(double y) const {
  if (wet_cells_.empty() || y >= domain_.spec.water->level)
    return 0.0;
  const auto above = std::ranges::upper_bound(wet_cells_, y, {}, &WetCell::y);
  if (above == wet_cells_.begin())
    return above->pore_pressure; // nothing flows through the base
  const WetCell& below = *(above - 1);
  if (above != wet_cells_.end())
    return std::lerp(below.pore_pressure, above->pore_pressure, (y - below.y) / (above->y - below.y));
  if (!domain_.sets[sets_[below.first_row]].traits.flowing)
    return below.pore_pressure;
  const double top = std::min(domain_.spec.water->level, levels_.back());
  return below.pore_pressure * std::max(0.0, top - y) / (top - below.y);
}

void PeriodicColumn::step() {
  ++intervals_;
  time_ = spec_.start_time + static_cast<double>(intervals_) * time_step();
  advance();
}

int PeriodicColumn::cut_interval() {
  constexpr double margin = 0.9; // for pressure that grows, and soil that moves, within the interval
  const int parts =
      static_cast<int>(std::ceil(time_step() / (margin * critical_time_step(domain_, 0.0)) - 1e-9));
  domain_.spec.scheme.dt = time_step() / parts;
  return parts;
}

void PeriodicColumn::advance() {
  const int parts = cut_interval();
  for (int part = 0; part < parts; ++part) {
    stepper_->step();
    const std::vector<Row> after = rows();
    if (part == 0) {
      record(after);
      record_deformation();
    }
    if (domain_.has_water())
      sample_nodes(velocity_kicked_, [this](std::size_t n) { return domain_.grid.mixture_after(n); });
    before_ = std::exchange(now_, after);
    previous_dt_ = stepper_->dt();
  }
}

void PeriodicColumn::record(const std::vector<Row>& after) {
  const double dt = stepper_->dt();
  find_velocities();
  for (std::size_t r = 0; r < ids_.size(); ++r) {
    points_[r + 1].stress = now_[r].stress - at_rest_[r].stress;
    points_[r + 1].stress_rate = 1.0 / (dt + previous_dt_) * (after[r].stress - before_[r].stress);
  }
  const auto at_base = [&](double time, Vector v) {
    const Vector t =
        eq6::boundary_traction(domain_.boundary.faces().front().ground, v, spec_.incident(time), {}).total();
    return eq6::Stress{points_[1].stress.xx, -t.y, -t.x};
  };
  const Vector v = points_.front().velocity;
  const Vector a = points_.front().acceleration;
  points_.front().stress = at_base(time_, v);
  points_.front().stress_rate =
      0.5 / dt * (at_base(time_ + dt, v + dt * a) - at_base(time_ - dt, v - dt * a));
  points_.front().stress_rate.xx = points_[1].stress_rate.xx;
  points_.back().stress = {points_[ids_.size()].stress.xx, 0.0, 0.0};
  points_.back().stress_rate = {points_[ids_.size()].stress_rate.xx, 0.0, 0.0};
}

void PeriodicColumn::find_velocities() {
  const Grid& grid = domain_.grid;
  const double dt = stepper_->dt();
  std::vector<Vector> acceleration(levels_.size());
  sample_nodes(acceleration, [&grid](std::size_t n) { return grid.acceleration(n); });
  std::vector<Vector> kicked;
  if (domain_.has_water()) {
    kicked.resize(levels_.size());
    sample_nodes(kicked, [&grid](std::size_t n) { return grid.mixture_after(n); });
  }
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vector v = velocity_before_[i];
    const Vector a = acceleration[i];
    points_[i].acceleration = a;
    if (!domain_.has_water()) {
      points_[i].velocity = v + 0.5 * dt * a;
      continue;
    }
    const Vector seen = velocity_kicked_.empty() ? v : without_residual(v, velocity_kicked_[i]);
    points_[i].velocity = seen + 0.5 * (kicked[i] - v);
  }
}

void PeriodicColumn::record_deformation() {
  points_.front().displacement = base_displacement_;
  for (std::size_t r = 0; r < ids_.size(); ++r) {
    const Vector start = at_rest_[r].displacement;
    points_[r + 1].displacement = now_[r].displacement - start;
  }
  const std::size_t top = ids_.size();
  points_[top + 1].displacement = points_[top].displacement;
  for (WetCell& cell : wet_cells_) {
    double sum = 0.0;
    for (std::size_t r = cell.first_row; r < cell.end_row; ++r)
      sum += now_[r].pore_pressure;
    cell.pore_pressure = sum / static_cast<double>(cell.end_row - cell.first_row);
  }
  // The slope of the parabola through three neighbours, rows if there are as many: nodes give the base, where
  // no box is averaged over, another error.
  const std::size_t first = top > 2 ? 1 : 0;
  const std::size_t last = std::max<std::size_t>(top, 2);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const std::size_t a = std::clamp(i > 0 ? i - 1 : 0, first, last - 2);
    const double lower = levels_[a + 1] - levels_[a];
    const double upper = levels_[a + 2] - levels_[a + 1];
    const double share = (2.0 * levels_[i] - levels_[a] - levels_[a + 1]) / (lower + upper);
    const auto slope = [&](double Vector::*component) {
      const double below =
          (points_[a + 1].displacement.*component - points_[a].displacement.*component) / lower;
      const double above =
          (points_[a + 2].displacement.*component - points_[a + 1].displacement.*component) / upper;
      return std::lerp(below, above, share);
    };
    points_[i].eyy = slope(&Vector::y);
    points_[i].gxy = slope(&Vector::x);
  }
}

/// Samples at the faces of the base, at the rows of particles and at the surface, as side faces of a domain
/// would.
template <typename OfNode>
void PeriodicColumn::sample_nodes(std::vector<Vector>& v, const OfNode& of_node) const {
  const Grid& grid = domain_.grid;
  v.resize(levels_.size());
  const auto column = static_cast<int>(std::lround((spec_.domain.box.x_min - grid.x0) / grid.h));
  const BoundaryFace& base = domain_.boundary.faces().front();
  v.front() = {};
  FaceWeights weights_of_base;
  face_weights(domain_, base, weights_of_base);
  for (const auto& [n, w] : weights_of_base) {
    const Vector at = of_node(n);
    v.front().x += w * at.x;
    v.front().y += w * at.y;
  }
  for (std::size_t r = 0; r < ids_.size(); ++r) {
    const Particles& set = domain_.sets[sets_[r]];
    const std::size_t k = set.index_of[ids_[r]];
    const Weights weights = cell_weights(set.y[k], domain_.y_axis(), half_sides(set, k).y);
    Vector& sum = v[r + 1] = {};
    for (int a = 0; a < 4; ++a) {
      const Vector at = of_node(grid.index(column, weights.base + a));
      sum.x += weights.s[a] * at.x;
      sum.y += weights.s[a] * at.y;
    }
  }
  v.back() = v[ids_.size()]; // no strain where there is no stress
}

std::vector<PeriodicColumn::Row> PeriodicColumn::rows() const {
  std::vector<Row> all;
  all.reserve(ids_.size());
  for (std::size_t r = 0; r < ids_.size(); ++r) {
    const Particles& set = domain_.sets[sets_[r]];
    const std::size_t k = set.index_of[ids_[r]];
    const TotalStress stress = total_stress(set, k);
    all.push_back({{stress.xx, stress.yy, stress.xy},
                   {set.x[k] - set.x_initial[k], set.y[k] - set.y_initial[k]},
                   set.traits.wet ? excess_pressure(set, k) : 0.0});
  }
  return all;
}

} // namespace tremolo::mpm_domain
