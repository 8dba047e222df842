// What `check` passes, every process takes. Cases cover all pairs of values of all factors (drawn_case.hpp)
// that are possible: beginning with the plain case, as many values as are not refused together are put into
// each. A case without errors starts every process and makes three steps; a refusal names the key, in a table
// that the file has. TREMOLO_AGREEMENT_CASES asks for so many random cases besides, TREMOLO_AGREEMENT_SEED
// for others.

#include "drawn_case.hpp"
#include "started.hpp"

#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/plan.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>

namespace tremolo::testing {
namespace {

using Random = std::mt19937;

Draw plain() {
  return Draw(factors().size(), 0);
}

/// A value of one factor, and a pair of those of two, the first factor first.
using Value = std::pair<std::size_t, std::size_t>;
using Pair = std::pair<Value, Value>;

Pair pair_of(Value a, Value b) {
  return a < b ? Pair{a, b} : Pair{b, a};
}

/// Pairs of which no case has had both yet.
class OpenPairs {
public:
  OpenPairs() {
    for (std::size_t f = 0; f < factors().size(); ++f)
      for (std::size_t g = f + 1; g < factors().size(); ++g)
        for (std::size_t a = 0; a < factors()[f].values.size(); ++a)
          for (std::size_t b = 0; b < factors()[g].values.size(); ++b)
            open_.insert({{f, a}, {g, b}});
  }

  std::size_t count() const { return open_.size(); }
  const std::set<Pair>& all() const { return open_; }
  bool has(Value a, Value b) const { return open_.contains(pair_of(a, b)); }
  void close(const Draw& draw) {
    for (std::size_t f = 0; f < draw.size(); ++f)
      for (std::size_t g = f + 1; g < draw.size(); ++g)
        open_.erase({{f, draw[f]}, {g, draw[g]}});
  }
  void give_up(const Pair& pair) { open_.erase(pair); }

  /// How many of them a case with this value besides would close.
  std::size_t closed_by(const Draw& draw, Value value) const {
    std::size_t count = 0;
    for (std::size_t g = 0; g < draw.size(); ++g)
      if (g != value.first && has(value, {g, draw[g]}))
        ++count;
    return count;
  }

private:
  std::set<Pair> open_;
};

class Agreement : public ::testing::Test {
protected:
  Agreement() { write_record(folder_ / ""); }

  /// The case where it has no errors; of one that has, each names a key.
  std::optional<scene::Case> read(const Draw& draw) const {
    const std::string text = case_text(draw);
    try {
      return scene::parse(text, "case.toml", folder_ / "");
    } catch (const scene::CaseErrors& errors) {
      for (const scene::Finding& error : errors.errors())
        EXPECT_TRUE(names_a_key(text, error)) << described(draw) << "\n" << error.message();
    }
    return std::nullopt;
  }

  /// @returns whether `check` passes the case
  static bool expect_starts(const scene::Case& scene, const Draw& draw) {
    try {
      app::start_free_fields(scene, scene::plan(scene));
    } catch (const std::exception& error) {
      const std::string what = error.what();
      EXPECT_TRUE(what.starts_with("case.toml: [boundary.")) << described(draw) << "\n" << what;
      return false;
    }
    try {
      start_processes(scene);
    } catch (const std::exception& error) {
      ADD_FAILURE() << described(draw) << "\n" << error.what() << "\n" << case_text(draw);
    }
    return true;
  }

  /// What `check --column` passes, `column` runs.
  /// @returns whether it has passed
  static bool expect_column_runs(const std::filesystem::path& file, scene::SourceModel model) {
    std::optional<app::ColumnGround> ground;
    try {
      ground = app::column_ground(file, model);
      app::start_column(*ground);
    } catch (const std::exception& refusal) {
      return false;
    }
    try {
      run_column(*ground);
    } catch (const std::exception& error) {
      ADD_FAILURE() << ground->scene.text << "\ncolumn of " << scene::name(model) << ": " << error.what();
    }
    return true;
  }

  std::size_t expect_columns_run(const Draw& draw) const {
    const auto file = folder_.write("column.toml", column_text(draw));
    return static_cast<std::size_t>(std::ranges::count_if(
        scene::computed_models(), [&](scene::SourceModel model) { return expect_column_runs(file, model); }));
  }

  double start_pairs(unsigned seed, std::size_t most) const;

private:
  /// It stands at a table or key of the file and names it.
  static bool names_a_key(const std::string& text, const scene::Finding& error) {
    const bool named = !error.table.empty() || error.text.find('\'') != std::string::npos ||
                       error.text.find('[') != std::string::npos;
    return named && error.line <= 1 + std::ranges::count(text, '\n');
  }

  TemporaryFolder folder_;
};

/// A sound case with a pair of values and, in a random order, as many others that close pairs as go with it.
std::optional<Draw> row_with(const Pair& pair, const OpenPairs& open, Random& random, const auto& is_sound) {
  Draw draw = plain();
  draw[pair.first.first] = pair.first.second;
  draw[pair.second.first] = pair.second.second;
  if (!is_sound(draw))
    return std::nullopt;
  std::vector<std::size_t> order(factors().size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::shuffle(order, random);
  for (const std::size_t f : order) {
    if (f == pair.first.first || f == pair.second.first)
      continue;
    std::vector<std::size_t> values(factors()[f].values.size());
    std::iota(values.begin(), values.end(), 0);
    std::ranges::stable_sort(values, std::greater{}, [&](std::size_t v) {
      return open.closed_by(draw, {f, v});
    });
    const std::size_t best = values.front();
    if (best == draw[f] || open.closed_by(draw, {f, best}) == 0)
      continue;
    Draw more = draw;
    more[f] = best;
    if (is_sound(more))
      draw = std::move(more);
  }
  return draw;
}

/// Cases that cover all pairs, one after the other, until so many have started.
/// @returns the share of the pairs that is left
double Agreement::start_pairs(unsigned seed, std::size_t most) const {
  Random random(seed);
  OpenPairs open;
  std::size_t rows = 0, columns = 0, impossible = 0;
  const std::size_t all = open.count();
  while (open.count() > 0 && rows < most) {
    const auto at = std::uniform_int_distribution<std::size_t>(0, open.count() - 1)(random);
    const Pair pair = *std::next(open.all().begin(), static_cast<std::ptrdiff_t>(at));
    const auto row = row_with(pair, open, random, [&](const Draw& draw) { return read(draw).has_value(); });
    if (!row) {
      ++impossible;
      open.give_up(pair);
      continue;
    }
    if (!expect_starts(*read(*row), *row)) {
      open.give_up(pair);
      continue;
    }
    ++rows;
    open.close(*row);
    columns += expect_columns_run(*row);
    if (HasFailure())
      return 0.0;
  }
  std::printf("%zu cases and %zu columns; of %zu pairs %zu are refused, %zu are left\n", rows, columns, all,
              impossible, open.count());
  EXPECT_TRUE(rows == most || open.count() == 0) << rows;
  EXPECT_GT(columns, rows / 3);
  return static_cast<double>(open.count()) / static_cast<double>(all);
}

/// None of these has undamped layers that ring without end beyond the critical angle, which take 40 s to
/// refuse.
TEST_F(Agreement, CasesOfManyPairsStart) {
  EXPECT_LT(start_pairs(2, 30), 0.6);
}

TEST_F(Agreement, AcceptanceCasesOfAllPairsStart) {
  const bool all = std::getenv("TREMOLO_AGREEMENT_CASES") != nullptr;
  EXPECT_LT(start_pairs(20261125, all ? std::numeric_limits<std::size_t>::max() : 60), 0.5);
}

class ShippedColumns : public Agreement, public ::testing::WithParamInterface<scene::SourceModel> {};

TEST_P(ShippedColumns, Run) {
  std::size_t columns = 0;
  for (const auto& folder : std::filesystem::directory_iterator(source_dir() + "/cases"))
    if (const auto file = folder.path() / "case.toml"; std::filesystem::exists(file))
      columns += expect_column_runs(file, GetParam()) ? 1 : 0;
  std::printf("%zu columns\n", columns);
  EXPECT_GT(columns, 1u);
}

std::string name_of_model(const ::testing::TestParamInfo<scene::SourceModel>& of) {
  return std::string(scene::name(of.param));
}

INSTANTIATE_TEST_SUITE_P(Models, ShippedColumns,
                         ::testing::Values(scene::SourceModel::wave, scene::SourceModel::fe), name_of_model);
INSTANTIATE_TEST_SUITE_P(AcceptanceModels, ShippedColumns,
                         ::testing::Values(scene::SourceModel::ode, scene::SourceModel::eql), name_of_model);

/// Random cases: each factor is that of the plain case as often as not.
TEST_F(Agreement, RandomCasesStart) {
  const char* const asked = std::getenv("TREMOLO_AGREEMENT_CASES");
  if (asked == nullptr)
    GTEST_SKIP() << "TREMOLO_AGREEMENT_CASES is not set";
  const char* const seed = std::getenv("TREMOLO_AGREEMENT_SEED");
  Random random(seed != nullptr ? static_cast<unsigned>(std::stoul(seed)) : 1u);
  std::size_t sound = 0, columns = 0;
  const auto cases = std::stoul(asked);
  std::bernoulli_distribution changes(0.15);
  for (std::size_t i = 0; i < cases; ++i) {
    Draw draw = plain();
    for (std::size_t f = 0; f < draw.size(); ++f)
      if (changes(random))
        draw[f] = std::uniform_int_distribution<std::size_t>(0, factors()[f].values.size() - 1)(random);
    if (const auto scene = read(draw))
      sound += expect_starts(*scene, draw) ? 1 : 0;
    columns += expect_columns_run(draw);
  }
  std::printf("%zu cases: %zu started, %zu columns ran, the others were refused\n", cases, sound, columns);
}

} // namespace
} // namespace tremolo::testing
