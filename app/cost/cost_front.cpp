#include "app/cost/cost_front.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tremolo::app {

namespace {

/// An error that falls by less than this power of h does not converge.
constexpr double least_order = 0.5;
/// Smallest size to which a fit is extrapolated, relative to the smallest measured one.
constexpr double farthest = 0.25;

/// y = intercept + slope x
struct Line {
  double intercept = 0.0;
  double slope = 0.0;
};

/// Least squares of weight w.
Line line(std::span<const double> x, std::span<const double> y, std::span<const double> w) {
  double sum = 0.0, mean_x = 0.0, mean_y = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum += w[i];
    mean_x += w[i] * x[i];
    mean_y += w[i] * y[i];
  }
  mean_x /= sum;
  mean_y /= sum;
  double xx = 0.0, xy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += w[i] * (x[i] - mean_x) * (x[i] - mean_x);
    xy += w[i] * (x[i] - mean_x) * (y[i] - mean_y);
  }
  const double slope = xy / xx;
  return {mean_y - slope * mean_x, slope};
}

/// t0 + t1 u; a start that would be negative is none.
Line time_line(std::span<const double> work, std::span<const double> cpu) {
  std::vector<double> weight;
  double relative_work = 0.0, relative_work2 = 0.0;
  for (std::size_t i = 0; i < cpu.size(); ++i) {
    weight.push_back(1.0 / (cpu[i] * cpu[i]));
    relative_work += work[i] / cpu[i];
    relative_work2 += work[i] * work[i] / (cpu[i] * cpu[i]);
  }
  const Line fitted = line(work, cpu, weight);
  return fitted.intercept >= 0.0 ? fitted : Line{0.0, relative_work / relative_work2};
}

CostFit fit(std::span<const CostPoint> points) {
  std::vector<double> size, error, log_work, work, cpu;
  for (const CostPoint& point : points) {
    size.push_back(std::log(point.size));
    error.push_back(std::log(point.error));
    log_work.push_back(std::log(point.work));
    work.push_back(point.work);
    cpu.push_back(point.cpu);
  }
  const std::vector<double> equal(points.size(), 1.0);
  const Line of_error = line(size, error, equal);
  const Line of_work = line(size, log_work, equal);
  const Line of_time = time_line(work, cpu);
  CostFit result{.family = points.front().family,
                 .points = points.size(),
                 .order = of_error.slope,
                 .constant = std::exp(of_error.intercept),
                 .work_order = -of_work.slope,
                 .work = std::exp(of_work.intercept),
                 .start = of_time.intercept,
                 .per_update = of_time.slope,
                 .smallest = std::exp(*std::ranges::min_element(size)),
                 .largest = std::exp(*std::ranges::max_element(size))};
  for (const CostPoint& point : points) {
    const double error_ratio = point.error / result.error_at(point.size);
    const double time_ratio = point.cpu / result.cpu_at(point.size);
    result.error_spread = std::max({result.error_spread, error_ratio, 1.0 / error_ratio});
    result.time_spread = std::max({result.time_spread, time_ratio, 1.0 / time_ratio});
  }
  return result;
}

} // namespace

double CostFit::error_at(double size) const {
  return constant * std::pow(size, order);
}

double CostFit::cpu_at(double size) const {
  return start + per_update * work * std::pow(size, -work_order);
}

std::vector<std::size_t> pareto_front(std::span<const CostPoint> points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
    return points[a].cpu != points[b].cpu ? points[a].cpu < points[b].cpu : points[a].error < points[b].error;
  });
  std::vector<std::size_t> front;
  for (const std::size_t i : order)
    if (front.empty() || points[i].error < points[front.back()].error)
      front.push_back(i);
  return front;
}

std::vector<CostFit> fits(std::span<const CostPoint> points) {
  std::vector<CostFit> all;
  for (const CostPoint& first : points) {
    if (std::ranges::find(all, first.family, &CostFit::family) != all.end())
      continue;
    std::vector<CostPoint> family;
    std::ranges::copy_if(points, std::back_inserter(family), [&](const CostPoint& point) {
      return point.family == first.family && point.error > 0.0;
    });
    const auto sizes = [&](const CostPoint& point) { return point.size != family.front().size; };
    if (std::ranges::any_of(family, sizes))
      all.push_back(fit(family));
  }
  return all;
}

std::optional<double> size_for(const CostFit& fit, double target) {
  if (fit.order < least_order)
    return std::nullopt;
  const double size = std::min(std::pow(target / fit.constant, 1.0 / fit.order), fit.largest);
  if (size < farthest * fit.smallest)
    return std::nullopt;
  return size;
}

} // namespace tremolo::app
