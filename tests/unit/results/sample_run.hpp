#pragma once

// A small run whose every number follows from its position, so that a test can say what it should read.

#include "results/run_file.hpp"
#include "tests/support/temporary_folder.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace sample_run {

using namespace tremolo::results;

using Folder = tremolo::testing::TemporaryFolder;

inline const RunDescription description{.title = "sample",
                                        .case_text = "title = \"sample\"\n",
                                        .plan = "{\"effects\": []}",
                                        .build_version = "0.1.0",
                                        .compiler = "test",
                                        .build_flags = "-O0"};

inline const std::vector<std::string> monitor_columns{"time", "x", "y", "ux", "uy", "vx", "vy", "ax", "ay"};
inline const std::vector<std::string> monitor_units{"s", "m", "m", "m", "m", "m/s", "m/s", "m/s2", "m/s2"};

inline std::size_t particles(std::size_t frame) {
  return 50 + frame % 7;
}

/// Distinct for every frame, field and entry.
inline double value(std::size_t frame, std::size_t field, std::size_t entry) {
  return 1000.0 * static_cast<double>(frame) + 100.0 * static_cast<double>(field) +
         0.01 * static_cast<double>(entry);
}

inline double frame_time(std::size_t frame) {
  return 0.25 * static_cast<double>(frame);
}

inline std::vector<double> filled(std::size_t frame, std::size_t field, std::size_t size) {
  std::vector<double> values(size);
  for (std::size_t i = 0; i < size; ++i) {
    values[i] = value(frame, field, i);
  }
  return values;
}

inline void write_frame(RunWriter& run, std::size_t frame) {
  const std::size_t n = particles(frame);
  const auto position = filled(frame, 0, 2 * n);
  const auto velocity = filled(frame, 1, 2 * n);
  const auto stress = filled(frame, 2, 4 * n);
  const std::vector<std::int32_t> soil(n, static_cast<std::int32_t>(frame));
  const std::vector<Field> fields{{"position", "m", 2, std::span(position)},
                                  {"velocity", "m/s", 2, std::span(velocity)},
                                  {"stress", "Pa", 4, std::span(stress)},
                                  {"soil", "1", 1, std::span(soil)}};
  run.write_frame(frame_time(frame), fields);
}

inline std::vector<double> monitor_row(std::size_t row) {
  std::vector<double> values = filled(row, 5, monitor_columns.size());
  values[0] = 0.01 * static_cast<double>(row);
  return values;
}

inline BoundaryFaces faces() {
  return {.position = {0, -1, 0, -2, 5, -3},
          .normal = {-1, 0, -1, 0, 0, -1},
          .length = {1, 1, 2},
          .source = {"left", "left", "base"}};
}

} // namespace sample_run
