#pragma once

#include "scene/plan/plan.hpp"

#include <cstddef>
#include <string_view>
#include <vector>

namespace tremolo::scene {

/// A field that a source serves, and the levels at which it does, ascending, m; interfaces of layers twice.
struct ServedLine {
  BaseForm field = BaseForm::total;
  std::vector<double> levels;
};

/// Service required of a source process so that every boundary face finds its free field: fields on a
/// vertical line at the model's left edge, and the time on that line. With the horizontal slowness p a face
/// at x reads the line at t - p (x - x_line), so the line starts p times the model's width before the
/// shaking.
struct Service {
  std::vector<ServedLine> lines; ///< the free field at all levels; the incident wave at the base only
  double x_line = 0.0;           ///< m
  double start_time = 0.0;       ///< s
  double end_time = 0.0;         ///< s
};

/// Suffixes of the names of served fields, by the index of their plane wave: a face that requests "total"
/// takes the sum of "total" and "total+vertical" (coupler/wire/field.hpp).
constexpr std::string_view suffix_of_wave(std::size_t wave) {
  return wave == 0 ? "" : "+vertical";
}

/// @param slowness_x p of the source, s/m
Service service(const Case& scene, const SourceProcess& source, double slowness_x);

/// @throws std::invalid_argument if the plan has no source of this name
const SourceProcess& source_named(const Plan& plan, std::string_view name);

} // namespace tremolo::scene
