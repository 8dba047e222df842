#include "app/free_field/series/computed_field.hpp"

#include "app/verify/hermite.hpp"
#include "freefield/process/column_from_case.hpp"
#include "freefield/process/column_values.hpp"
#include "mpm_domain/process/column_from_case.hpp"
#include "wavefield/process/field_from_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <utility>

namespace tremolo::app {

namespace {

using freefield::ColumnSample;

ColumnSample between(const ColumnSample& a, const ColumnSample& b, double dt, double s) {
  ColumnSample c;
  const auto join = [&](double ColumnSample::*value, double ColumnSample::*rate) {
    const Jet jet = hermite({a.*value, a.*rate}, {b.*value, b.*rate}, dt, s);
    c.*value = jet.value;
    c.*rate = jet.rate;
  };
  join(&ColumnSample::vx, &ColumnSample::vx_rate);
  join(&ColumnSample::vy, &ColumnSample::vy_rate);
  join(&ColumnSample::sxx, &ColumnSample::sxx_rate);
  join(&ColumnSample::syy, &ColumnSample::syy_rate);
  join(&ColumnSample::sxy, &ColumnSample::sxy_rate);
  c.ux = hermite({a.ux, a.vx}, {b.ux, b.vx}, dt, s).value;
  c.uy = hermite({a.uy, a.vy}, {b.uy, b.vy}, dt, s).value;
  c.eyy = a.eyy + s * (b.eyy - a.eyy);
  c.gxy = a.gxy + s * (b.gxy - a.gxy);
  c.pore_pressure = a.pore_pressure + s * (b.pore_pressure - a.pore_pressure);
  return c;
}

/// A sample with rates per second of a time that passes so many times (1) as fast as that of the simulation.
ColumnSample in_time_of_soil(ColumnSample sample, double speed) {
  for (double ColumnSample::*rate : {&ColumnSample::vx, &ColumnSample::vy, &ColumnSample::sxx_rate,
                                     &ColumnSample::syy_rate, &ColumnSample::sxy_rate})
    sample.*rate /= speed;
  for (double ColumnSample::*rate : {&ColumnSample::vx_rate, &ColumnSample::vy_rate})
    sample.*rate /= speed * speed;
  return sample;
}

/// A column marched in time, at rest before its start. States are sampled only at the ends of steps that
/// contain a requested time.
/// @param clock  of the times of the series
void march(freefield::Column& column, const materials::SoilClock& clock, FreeFieldSeries& series) {
  const std::size_t levels = series.levels.size();
  const double dt = column.time_step();
  std::vector<ColumnSample> before(levels);
  std::vector<ColumnSample> after(levels);
  for (std::size_t i = 0; i < series.times.count; ++i) {
    const double time = clock.simulated_time(series.times.start + static_cast<double>(i) * series.times.dt);
    if (column.time() < time) {
      while (column.time() + dt < time)
        column.step();
      column.sample(series.levels, before);
      column.step();
      column.sample(series.levels, after);
    }
    const double s = std::clamp(1.0 - (column.time() - time) / dt, 0.0, 1.0);
    for (std::size_t k = 0; k < levels; ++k)
      series.samples[k * series.times.count + i] =
          in_time_of_soil(between(before[k], after[k], dt, s), clock.speed(time));
  }
}

ColumnSample at_time(const wavefield::History& h, std::size_t i) {
  ColumnSample sample = freefield::sample_at(h, i);
  sample.ux = h.ux[i];
  sample.uy = h.uy[i];
  sample.eyy = h.eyy[i];
  sample.gxy = h.gxy[i];
  return sample;
}

/// Plane waves, in elastic layers or in those of an equivalent-linear iteration.
class PlaneWaves : public ComputedField {
public:
  PlaneWaves(wavefield::Superposition field, double x,
             std::optional<wavefield::EquivalentLinearResult> iterated)
      : field_(std::move(field)), x_(x), iterated_(std::move(iterated)) {}

  // The clock is in the case already: a spectrum has no steps that could be slower.
  void fill(FreeFieldSeries& series, const materials::SoilClock&) override {
    if (iterated_)
      series.report = wavefield::summary(*iterated_);
    series.equivalent_linear = iterated_;
    synthesise(field_, x_, wavefield::Part::total, series);
  }

  std::string description() const override {
    return iterated_ ? wavefield::summary(*iterated_) : "plane waves";
  }

  void try_surface(double y, double from, double to) const override {
    sample_surface(field_, {x_, y}, from, to, true);
  }

private:
  wavefield::Superposition field_;
  double x_;
  std::optional<wavefield::EquivalentLinearResult> iterated_;
};

class MarchedColumn : public ComputedField {
public:
  explicit MarchedColumn(std::unique_ptr<freefield::Column> column) : column_(std::move(column)) {}

  void fill(FreeFieldSeries& series, const materials::SoilClock& clock) override {
    march(*column_, clock, series);
    series.report = column_->report();
  }

  std::string description() const override { return fmt::format("steps of {:.3g} s", column_->time_step()); }

  void try_surface(double, double, double) const override {}

private:
  std::unique_ptr<freefield::Column> column_;
};

using Made = std::unique_ptr<ComputedField>;

Made plane_waves(const scene::Case& scene, const scene::SourceProcess& source, double x, double) {
  return std::make_unique<PlaneWaves>(wavefield::field_from_case(scene, source), x, std::nullopt);
}

Made iterated_waves(const scene::Case& scene, const scene::SourceProcess& source, double x, double) {
  auto iterated = wavefield::equivalent_linear_from_case(scene, source);
  auto field = wavefield::field_from_case(scene, source, iterated);
  return std::make_unique<PlaneWaves>(std::move(field), x, std::move(iterated));
}

template <auto column_from_case>
Made marched(const scene::Case& scene, const scene::SourceProcess& source, double x, double needed_from) {
  return std::make_unique<MarchedColumn>(column_from_case(scene, source, x, needed_from));
}

struct Maker {
  scene::SourceModel model;
  Made (*make)(const scene::Case& scene, const scene::SourceProcess& source, double x, double needed_from);
};

constexpr std::array makers{Maker{scene::SourceModel::wave, plane_waves},
                            Maker{scene::SourceModel::eql, iterated_waves},
                            Maker{scene::SourceModel::fe, marched<freefield::column_from_case>},
                            Maker{scene::SourceModel::ode, marched<freefield::column_from_case>},
                            Maker{scene::SourceModel::mpm, marched<mpm_domain::column_from_case>}};

} // namespace

Made computed_field(const scene::Case& scene, const scene::SourceProcess& source, double x_line,
                    double needed_from) {
  const auto maker = std::ranges::find(makers, source.field.model, &Maker::model);
  if (maker == makers.end())
    throw std::invalid_argument(
        fmt::format("model \"{}\" is not computed here; wave, fe, ode, eql and mpm are",
                    scene::name(source.field.model)));
  return maker->make(scene, source, x_line, needed_from);
}

void synthesise(const wavefield::Superposition& field, double x, wavefield::Part part,
                FreeFieldSeries& series) {
  const auto points = wavefield::points_on_line(x, series.levels);
  const auto histories = field.sample(points, series.times, part);
  for (std::size_t k = 0; k < histories.size(); ++k)
    for (std::size_t i = 0; i < series.times.count; ++i)
      series.samples[k * series.times.count + i] = at_time(histories[k], i);
}

} // namespace tremolo::app
