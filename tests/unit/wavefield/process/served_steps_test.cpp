#include "wavefield/process/served_steps.hpp"

#include <array>
#include <cstdlib>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace tremolo::wavefield {
namespace {

constexpr std::size_t count = 5000;                 // more than a block of a lot of three levels holds
constexpr std::array pieces{3000UL, 1500UL, 500UL}; // in which they come

/// Values that tell step, level and quantity.
double value(std::size_t step, std::size_t level, std::size_t quantity) {
  return static_cast<double>(step) + 1e-2 * static_cast<double>(level) + 1e-4 * static_cast<double>(quantity);
}

/// A level's history over the steps of a piece.
History level(std::size_t number, std::size_t piece) {
  const std::size_t first = std::accumulate(pieces.begin(), pieces.begin() + piece, 0UL);
  History h;
  std::size_t quantity = 0;
  for (auto* series : {&h.vx, &h.vy, &h.sxx, &h.syy, &h.sxy, &h.vx_rate, &h.vy_rate, &h.sxx_rate, &h.syy_rate,
                       &h.sxy_rate}) {
    for (std::size_t step = first; step < first + pieces[piece]; ++step)
      series->push_back(value(step, number, quantity));
    ++quantity;
  }
  return h;
}

TEST(ServedSteps, AStepHoldsAllLevelsFromTheLowestUp) {
  ServedSteps steps(4, {pieces.begin(), pieces.end()});
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    steps.put(piece, 0, std::vector{level(0, piece), level(1, piece), level(2, piece)});
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
    steps.put(piece, 3, std::vector{level(3, piece)});
  std::vector<double> row(4 * ServedSteps::values_per_level);
  for (std::size_t step = 0; step < count; ++step) {
    steps.read(step, row);
    for (std::size_t i = 0; i < row.size(); ++i)
      ASSERT_EQ(row[i], value(step, i / ServedSteps::values_per_level, i % ServedSteps::values_per_level))
          << "step " << step;
  }
}

TEST(ServedSteps, AFolderThatIsNotThereIsNamed) {
  const char* before = std::getenv("TMPDIR");
  const std::string kept = before == nullptr ? "" : before;
  ::setenv("TMPDIR", "/nonexistent", 1);
  EXPECT_THAT([] { ServedSteps steps(1, {1}); },
              testing::ThrowsMessage<std::runtime_error>(testing::AllOf(
                  testing::HasSubstr("/nonexistent"), testing::HasSubstr("No such file or directory"))));
  before == nullptr ? ::unsetenv("TMPDIR") : ::setenv("TMPDIR", kept.c_str(), 1);
}

} // namespace
} // namespace tremolo::wavefield
