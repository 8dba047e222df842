#pragma once

#include "scene/case.hpp"
#include "scene/plan/plan.hpp"
#include "wavefield/signal/history.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::app {

/// A free field to compute alone, and where it stands.
struct ColumnGround {
  scene::Case scene;
  scene::SourceProcess source;
  double x = 0.0; ///< m
};

/// The [[profile]] of a file of which only the tables of a free field are needed, at the reference point.
/// @throws scene::CaseErrors, std::runtime_error for ground without layers
ColumnGround column_ground(const std::filesystem::path& file, scene::SourceModel model);

/// y of the lowest level, m.
/// @throws std::runtime_error where the ground has no layers
double deepest_level(const scene::Case& scene, const scene::SourceProcess& source);

/// Times of the histories: until the motion has ended and the column has rung out, unless given.
/// @throws std::runtime_error naming the option where there are too few or too many
wavefield::TimeGrid column_times(const ColumnGround& ground, std::optional<double> duration = {},
                                 std::optional<double> every = {});

/// Builds what computes the free field, without a step of it, so that what it refuses is known.
/// @returns in a few words what it is
/// @throws as free_field_series() before its first step
std::string start_column(const ColumnGround& ground);

/// Builds the free fields wave, fe and ode of a complete case as their processes do.
/// @throws std::runtime_error that names the side and says why one cannot be built
void start_free_fields(const scene::Case& scene, const scene::Plan& plan);

/// Layers from the surface down, in lines.
std::string layers_text(const ColumnGround& ground);

} // namespace tremolo::app
