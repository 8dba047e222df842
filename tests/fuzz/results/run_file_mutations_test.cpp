// Bits of a run file are flipped, one at a time. Either its checksums, taken before, say that it is damaged,
// or all that a resumed run takes over reads as it was. More of them, by hand:
//
//     TREMOLO_RUN_FILE_MUTANTS=100000 test_results_fuzz

#include "base/own_process.hpp"
#include "base/text/text_file.hpp"
#include "results/run_checksums.hpp"
#include "results/run_file.hpp"
#include "results/stored_fields.hpp"
#include "tests/unit/results/sample_run.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <random>
#include <span>

using namespace tremolo;
using namespace sample_run;

namespace {

constexpr std::size_t frames = 3;
constexpr std::size_t boundary_numbers = 6; ///< of each of its datasets, a frame
constexpr ProcessLimits limits{.memory_bytes = std::uint64_t{1} << 29, .cpu_seconds = 5};

/// Chunked and compressed fields as well as small ones, contact nodes, a series, the boundary.
std::vector<Checksum> write_run(const std::filesystem::path& file) {
  RunWriter run(file, description);
  TimeSeries& toe = run.add_series("/monitors/toe", monitor_columns, monitor_units);
  run.set_boundary(faces());
  const std::vector<double> node{1.0, 2.0};
  const std::vector<std::int32_t> body{0};
  for (std::size_t frame = 0; frame < frames; ++frame) {
    const auto exchange = filled(frame, 6, boundary_numbers);
    toe.append(monitor_row(frame));
    run.append_boundary(frame_time(frame), {exchange, exchange, exchange});
    const auto position = filled(frame, 0, 1100);
    const auto small = filled(frame, 1, 550);
    const std::vector<Field> contact{{"position", "m", 2, node}, {"body", "1", 1, body}};
    run.write_frame(frame_time(frame),
                    std::vector<Field>{{"position", "m", 2, position}, {"mass", "kg", 1, small}},
                    std::vector<FramePart>{{"contact", contact}});
  }
  run.flush();
  return run.checksums();
}

/// All that a resumed run takes over, as bytes: of what grows, the rows that its checkpoint counts. A file
/// may have more, and a dataset that a flipped bit has made longer has them as well.
std::string taken_over(const std::filesystem::path& file) {
  const RunReader run(file);
  std::string all;
  const auto add = [&all](const auto& values) {
    all.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(*values.data()));
  };
  const auto add_rows = [&](const std::vector<double>& values, std::size_t width) {
    add(std::span(values).first(std::min(values.size(), frames * width)));
  };
  const SeriesData toe = run.series("/monitors/toe");
  all += std::to_string(toe.columns.size());
  add_rows(toe.values, toe.columns.size());
  const BoundaryHistory boundary = run.boundary();
  add_rows(boundary.time, 1);
  for (const auto* values : {&boundary.free_field_velocity, &boundary.domain_velocity, &boundary.traction})
    add_rows(*values, boundary_numbers);
  for (std::size_t frame = 0; frame < frames; ++frame) {
    all += std::to_string(run.frame_times().at(frame));
    const StoredFields particles(run.frame_fields(frame),
                                 [&](const std::string& name) { return run.frame_field(frame, name); });
    const StoredFields contact(run.part_fields("contact", frame), [&](const std::string& name) {
      return run.part_field("contact", frame, name);
    });
    for (const StoredFields* stored : {&particles, &contact})
      for (const Field& field : stored->fields()) {
        all += std::string(field.name) + std::string(field.unit) + std::to_string(field.components);
        std::visit(add, field.values);
      }
  }
  return all;
}

std::size_t mutants() {
  constexpr std::size_t short_form = 60;
  const char* wanted = std::getenv("TREMOLO_RUN_FILE_MUTANTS");
  return wanted != nullptr ? std::strtoul(wanted, nullptr, 10) : short_form;
}

TEST(RunFileMutations, AreNoticedOrHarmless) {
  const Folder folder;
  const auto checksums = write_run(folder / "run.h5");
  const std::string good = read_text_file(folder / "run.h5");
  const std::string wanted = taken_over(folder / "run.h5");
  ASSERT_NO_THROW(require_undamaged(folder / "run.h5", checksums));
  std::vector<std::size_t> written; // room that is kept for links is most of the file
  for (std::size_t i = 0; i < good.size(); ++i)
    if (good[i] != 0)
      written.push_back(i);
  std::mt19937 random(1);
  std::map<std::string, std::size_t> outcomes;
  for (std::size_t mutant = 0; mutant < mutants(); ++mutant) {
    const std::size_t byte =
        written[std::uniform_int_distribution<std::size_t>(0, written.size() - 1)(random)];
    const int bit = std::uniform_int_distribution<int>(0, 7)(random);
    std::string bad = good;
    bad[byte] = static_cast<char>(bad[byte] ^ (1 << bit));
    write_text_file(folder / "bad.h5", bad);
    try {
      const std::string found = in_own_process(
          [&] {
            require_undamaged(folder / "bad.h5", checksums);
            return taken_over(folder / "bad.h5");
          },
          limits);
      ++outcomes["harmless"];
      ASSERT_TRUE(found == wanted) << "bit " << bit << " of byte " << byte << " is not noticed";
    } catch (const std::runtime_error& error) {
      const std::string text = error.what();
      ++outcomes[text.starts_with("it ") ? text : "named"];
      ASSERT_FALSE(text.empty());
    }
  }
  for (const auto& [outcome, count] : outcomes)
    std::printf("%-60s %zu\n", outcome.c_str(), count);
  EXPECT_GT(outcomes["named"], mutants() / 20);
}

} // namespace
