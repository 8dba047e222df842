// A strong-motion record as the outcrop motion of a case, all the way from its file: the surface of three
// layers against the plain Fourier solution of the same samples, and the incident wave that columns take
// against the one of the frequency domain.

#include "freefield/process/incident_input.hpp"
#include "motion/spectra.hpp"
#include "scene/case.hpp"
#include "scene/plan/plan.hpp"
#include "tests/support/reference_table.hpp"
#include "tests/support/temporary_folder.hpp"
#include "wavefield/process/field_from_case.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

namespace tremolo {
namespace {

constexpr double dt = 0.02;         // of the record, s
constexpr std::size_t count = 2000; // its samples
constexpr double g = motion::standard_gravity;
constexpr std::array periods = {0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0};

class RecordOfACase : public ::testing::Test {
protected:
  void SetUp() override {
    const auto record = testing::reference_folder() / "records" / "RSN985_NORTHR_BLD090.AT2";
    if (!std::filesystem::exists(record))
      GTEST_SKIP() << record << " is absent; set TREMOLO_REFERENCE to the folder with the reference data";
    std::ofstream(folder_ / "case.toml") << "title = \"three layers\"\n[motion]\nfile = \""
                                         << std::filesystem::absolute(record).string() << R"("
kind = "outcrop"
wave = "SV"
angle_deg = 0.0
reference = [0.0, -20.0]
[surface]
level = 0.0
[halfspace]
density = 2100.0
vs = 500.0
vp = 1000.0
damping = 0.01
[damping]
model = "hysteretic"
[[profile]]
thickness = 6.0
density = 1700.0
vs = 120.0
vp = 300.0
damping = 0.05
[[profile]]
thickness = 14.0
density = 1850.0
vs = 220.0
vp = 500.0
damping = 0.03
)";
    scene_ = scene::load_free_field(folder_ / "case.toml", scene::SourceModel::wave);
  }

  scene::SourceProcess source() const {
    return {.name = "wave", .field = {scene::SourceModel::wave, {}}, .surface = 0.0};
  }

  testing::TemporaryFolder folder_;
  scene::Case scene_;
};

/// Spectral accelerations of a row of the reference, g.
std::vector<double> reference_spectrum(const std::string& motion) {
  std::ifstream stream(testing::reference_folder() / "waves" / "record_BLD090_layered3.csv");
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with(motion + ",")) {
      std::istringstream cells(line);
      std::vector<double> row;
      std::string cell;
      std::getline(cells, cell, ',');
      while (std::getline(cells, cell, ','))
        row.push_back(std::stod(cell));
      return {row.begin() + 5, row.end()}; // behind PGA, PGV, PGD, Arias intensity and duration
    }
  return {};
}

TEST_F(RecordOfACase, ReachesTheSurfaceAsItsSamplesSay) {
  const auto rows =
      testing::read_table(testing::reference_folder() / "waves" / "record_BLD090_layered3_ts.csv");
  const auto field = wavefield::field_from_case(scene_, source());
  const wavefield::TimeGrid times{0.0, dt, count};
  const std::array places = {wavefield::Point{0.0, 0.0}, wavefield::Point{0.0, -20.0}};
  const auto histories = field.sample(places, times);
  ASSERT_EQ(rows.size(), count);
  struct Place {
    const char* name;
    std::size_t column;
    const std::vector<double>& acceleration;
  };
  for (const auto& [name, column, acceleration] :
       {Place{"surface", 3, histories[0].vx_rate}, Place{"within_base", 2, histories[1].vx_rate}}) {
    double difference = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      difference += std::pow(acceleration[i] / g - rows[i][column], 2);
      square += std::pow(rows[i][column], 2);
    }
    const double error = std::sqrt(difference / square);
    EXPECT_LT(error, 2e-4) << name;
    const auto expected = reference_spectrum(name);
    ASSERT_EQ(expected.size(), periods.size()) << name;
    const auto spectrum = motion::response_spectrum(acceleration, dt, periods, 0.05);
    double largest = 0.0;
    for (std::size_t i = 0; i < periods.size(); ++i) {
      EXPECT_NEAR(spectrum[i].acceleration / g, expected[i], 2e-4 * expected[i])
          << name << ", " << periods[i] << " s";
      largest = std::max(largest, std::abs(spectrum[i].acceleration / g / expected[i] - 1.0));
    }
    std::printf("%s: acceleration %.2e (L2), spectrum %.2e\n", name, error, largest);
  }
}

TEST_F(RecordOfACase, IsOneMotionForColumnsAndForTheFrequencyDomain) {
  const double y = -25.0; // in the half-space, undamped so that the incident wave keeps its shape
  scene_.halfspace_damping = 0.0;
  const auto input = freefield::incident_input(scene_, source(), 0.0, y);
  const wavefield::TimeGrid times{0.0, 0.003, 12000};
  const auto history = wavefield::field_from_case(scene_, source())
                           .sample(std::array{wavefield::Point{0.0, y}}, times, wavefield::Part::incident)
                           .front();
  double difference = 0.0;
  double peak = 0.0;
  for (std::size_t i = 0; i < times.count; ++i) {
    const double v = input.velocity(static_cast<double>(i) * times.dt).x;
    difference = std::max(difference, std::abs(v - history.vx[i]));
    peak = std::max(peak, std::abs(v));
  }
  EXPECT_LT(difference, 1e-4 * peak);
}

} // namespace
} // namespace tremolo
