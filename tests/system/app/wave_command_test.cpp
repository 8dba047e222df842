// `tremolo wave` as a user calls it: the closed forms of the reference files, and what it refuses.

#include "tests/support/command.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/reference_table.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <string>

namespace {

using namespace tremolo::testing;
using ::testing::HasSubstr;

std::string case_text(const std::string& wave, const std::string& angle) {
  return "[motion]\n"
         "pulse = { shape = \"ricker\", frequency = 3.0, time = 1.0, velocity = 0.1 }\n"
         "wave = \"" +
         wave + "\"\nangle_deg = " + angle +
         "\nreference = [0.0, -40.0]\n"
         "[surface]\nlevel = 0.0\n"
         "[halfspace]\ndensity = 1700.0\nyoung = 40e6\npoisson = 0.28\n";
}

struct Command {
  TemporaryFolder folder;
  std::filesystem::path out = folder / "field.csv";

  Outcome operator()(const std::string& text, const std::string& points, const std::string& times) const {
    return run_tremolo("wave " + folder.write("case.toml", text).string() + " --points " +
                       folder.write("points.csv", points).string() + " --times " + times + " --out " +
                       out.string());
  }
};

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The distinct points of a reference table, as a points file.
std::string points_of(const std::vector<std::vector<double>>& rows) {
  std::ostringstream points;
  points << "x,y\n";
  for (std::size_t row = 0; row < rows.size(); ++row)
    if (row == 0 || rows[row][1] != rows[row - 1][1] || rows[row][2] != rows[row - 1][2])
      points << rows[row][1] << ',' << rows[row][2] << '\n';
  return points.str();
}

struct ReferenceFile {
  const char* wave;
  const char* angle;
  double tolerance; ///< of the peak of displacement, velocity and stress
};

class WaveCommand : public ::testing::TestWithParam<ReferenceFile> {};

TEST_P(WaveCommand, AgreesWithTheClosedForm) {
  const auto [wave, angle, tolerance] = GetParam();
  const auto file =
      reference_folder() / "waves" / ("halfspace_" + std::string(wave) + "_" + angle + "deg.csv");
  if (!std::filesystem::exists(file))
    GTEST_SKIP() << "no reference data at " << file;
  const auto expected = read_table(file);
  const Command command;
  const auto [status, output] = command(case_text(wave, angle), points_of(expected), "0:3:0.02");
  ASSERT_EQ(status, 0) << output;
  const auto rows = read_table(command.out);
  ASSERT_EQ(rows.size(), expected.size());

  constexpr std::array<std::size_t, 10> kind = {0, 0, 0, 1, 1, 2, 2, 3, 3, 3};
  std::array<double, 4> peak{1.0, 0.0, 0.0, 0.0};
  std::array<double, 4> error{};
  for (std::size_t row = 0; row < rows.size(); ++row) {
    ASSERT_EQ(rows[row].size(), kind.size());
    for (std::size_t i = 0; i < kind.size(); ++i) {
      peak[kind[i]] = std::max(peak[kind[i]], std::abs(expected[row][i]));
      error[kind[i]] = std::max(error[kind[i]], std::abs(rows[row][i] - expected[row][i]));
    }
  }
  for (std::size_t k = 0; k < peak.size(); ++k)
    EXPECT_LE(error[k], tolerance * peak[k]) << "kind " << k;
}

INSTANTIATE_TEST_SUITE_P(Reference, WaveCommand,
                         ::testing::Values(ReferenceFile{"SV", "0", 1e-9}, ReferenceFile{"SV", "15", 1e-9},
                                           ReferenceFile{"SV", "30", 1e-9}, ReferenceFile{"SV", "33.5", 1e-9},
                                           ReferenceFile{"SV", "40", 1e-6}, ReferenceFile{"P", "30", 1e-9}),
                         [](const auto& test) {
                           std::string name = std::string(test.param.wave) + test.param.angle;
                           std::ranges::replace(name, '.', '_');
                           return name;
                         });

TEST(WaveCommand, WritesPointAfterPoint) {
  const Command command;
  EXPECT_EQ(command(case_text("SV", "15"), "x,y\n0,0\n5,-3\n", "0:1:0.5").status, 0);
  const std::string text = text_of(command.out);
  EXPECT_THAT(text, ::testing::StartsWith("t,x,y,ux,uy,vx,vy,sxx,syy,sxy\n0,0,0,"));
  const auto rows = read_table(command.out);
  ASSERT_EQ(rows.size(), 6);
  EXPECT_EQ(rows[2][0], 1.0);
  EXPECT_EQ(rows[2][1], 0.0);
  EXPECT_EQ(rows[3][0], 0.0);
  EXPECT_EQ(rows[3][1], 5.0);
  EXPECT_EQ(rows[3][2], -3.0);
}

TEST(WaveCommand, TakesWholeCasesToo) {
  const TemporaryFolder folder;
  const auto points = folder.write("points.csv", "x,y\n0,0\n");
  const auto [status, output] =
      run_tremolo("wave " + tremolo::source_dir() + "/cases/halfspace_box/case.toml --points " +
                  points.string() + " --times 0:1:0.1 --out " + (folder / "out.csv").string());
  EXPECT_EQ(status, 0) << output;
  EXPECT_EQ(read_table(folder / "out.csv").size(), 11);
}

TEST(WaveCommand, SaysWhatIsWrong) {
  const Command command;
  const std::string good = case_text("SV", "15");
  const auto refuses = [&](const std::string& text, const std::string& points, const std::string& times,
                           int expected_status, const std::string& message) {
    const auto [status, output] = command(text, points, times);
    EXPECT_EQ(status, expected_status);
    EXPECT_THAT(output, HasSubstr(message));
  };
  refuses(good, "a,b\n0,0\n", "0:1:0.1", 1, "points.csv:1: the header must be 'x,y', found 'a,b'");
  refuses(good, "x,y\n0,1\n", "0:1:0.1", 1, "points.csv:2: y = 1 m lies above the free surface at y = 0 m");
  refuses(good, "x,y\n0,0\n", "0:1", 1, "times '0:1': must be T0:T1:DT in s");
  refuses(case_text("SV", "95"), "x,y\n0,0\n", "0:1:0.1", 2,
          "case.toml:4:13: [motion] 'angle_deg' = 95 is out of range");
}

/// The three layers of the reference files layered3_*, undamped.
const std::string layers = "[motion]\n"
                           "pulse = { shape = \"ricker\", frequency = 3.0, time = 1.0, velocity = 0.1 }\n"
                           "wave = \"SV\"\nangle_deg = 20\nreference = [0.0, -20.0]\n"
                           "[surface]\nlevel = 0.0\n"
                           "[[profile]]\nthickness = 6.0\ndensity = 1700.0\nvs = 120.0\nvp = 300.0\n"
                           "[[profile]]\nthickness = 14.0\ndensity = 1850.0\nvs = 220.0\nvp = 500.0\n"
                           "[halfspace]\ndensity = 2100.0\nvs = 500.0\nvp = 1000.0\n";

TEST(WaveCommand, GoesThroughLayers) {
  const auto file = reference_folder() / "waves" / "layered3_SV_20deg_elastic.csv";
  if (!std::filesystem::exists(file))
    GTEST_SKIP() << "no reference data at " << file;
  const auto expected = read_table(file);
  const Command command;
  const auto [status, output] = command(layers, points_of(expected), "0:3:0.02 --wrap-around");
  ASSERT_EQ(status, 0) << output;
  EXPECT_THAT(output, HasSubstr("doubled, it changes displacement by "));
  const auto rows = read_table(command.out);
  ASSERT_EQ(rows.size(), expected.size());
  for (std::size_t row = 0; row < rows.size(); ++row) {
    EXPECT_NEAR(rows[row][5], expected[row][5], 1e-9);                  // vx, of 0.3 m/s
    EXPECT_NEAR(rows[row][9], expected[row][9], 1e-9 * 1700.0 * 120.0); // sxy
  }
}

TEST(WaveCommand, WritesTransferFunctions) {
  const TemporaryFolder folder;
  const auto out = folder / "tf.csv";
  const std::string call =
      "wave " + folder.write("case.toml", layers).string() + " --transfer --out " + out.string();
  const auto [status, output] = run_tremolo(call + " --frequencies 0.1:0.2:0.1");
  ASSERT_EQ(status, 0) << output;
  EXPECT_THAT(text_of(out), ::testing::StartsWith("frequency_hz,re_ux,im_ux,re_uy,im_uy,re_within_ux"));
  const auto rows = read_table(out);
  ASSERT_EQ(rows.size(), 2);
  // layered3_tf_surface.csv, SV, 20 degrees, undamped, 0.2 Hz
  EXPECT_NEAR(rows[1][1], 1.935444059441, 1e-11);
  EXPECT_NEAR(rows[1][2], -0.1112540423438, 1e-11);
  EXPECT_NEAR(rows[1][3], -0.6273146934042, 1e-11);
  EXPECT_NEAR(rows[1][4], 0.03137919849227, 1e-11);
  EXPECT_THAT(run_tremolo(call + " --frequencies 0:1:0.1").output, HasSubstr("F0 is 0 Hz, must be > 0"));
  EXPECT_THAT(run_tremolo("wave " + (folder / "case.toml").string() + " --out " + out.string()).output,
              HasSubstr("needs --points and --times, or --transfer"));
}

TEST(WaveCommand, SaysThatTheDiskIsFull) {
  const TemporaryFolder folder;
  const auto [status, output] =
      run_tremolo("wave " + folder.write("case.toml", case_text("SV", "0")).string() + " --points " +
                  folder.write("points.csv", "x,y\n0,0\n").string() + " --times 0:1:0.1 --out /dev/full");
  EXPECT_EQ(status, 1);
  EXPECT_EQ(output, "tremolo: cannot write /dev/full: No space left on device\n");
}

} // namespace
