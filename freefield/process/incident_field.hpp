#pragma once

#include "freefield/process/column_values.hpp"
#include "scene/case.hpp"
#include "scene/plan/layers.hpp"
#include "wavefield/process/field_from_case.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tremolo::freefield {

/// The incident waves alone, which no layer has met: exact, and known for all times. What a source serves to
/// a base that takes it.
class IncidentField {
public:
  /// @param x, levels  where it is served, m
  /// @param times  the steps of the field
  IncidentField(const scene::Case& scene, const scene::SourceProcess& source, double x,
                const std::vector<double>& levels, const wavefield::TimeGrid& times)
      : histories_(wavefield::elastic_field(scene, scene::layers(scene, source), source.surface)
                       .sample(wavefield::points_on_line(x, levels), times, wavefield::Part::incident,
                               {.displacement = false, .strain = false})) {}

  /// The served values of all levels at one step.
  void fill(std::uint64_t step, std::span<double> values) const {
    auto next = values.begin();
    for (const wavefield::History& history : histories_)
      next = std::ranges::copy(served_values(sample_at(history, step)), next).out;
  }

private:
  std::vector<wavefield::History> histories_;
};

} // namespace tremolo::freefield
