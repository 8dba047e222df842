// The group by which ParaView opens a run holds no values of its own: what it shows are the frames, number by
// number, padded to three and six components.

#include "results/paraview/vtkhdf.hpp"

#include "results/hdf5/hdf5_read.hpp"
#include "tests/unit/results/sample_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

using namespace sample_run;
using testing::ElementsAre;

namespace {

constexpr std::size_t frames = 9;

std::vector<double> numbers(const FileReader& run, const std::string& name) {
  return run.numbers<double>(run.dataset(name).get(), H5T_NATIVE_DOUBLE, name);
}

/// A tunnel of four corners with a hole, which moves by (1, 2) m and turns by a right angle within 2 s, and
/// two faces.
void add_lines(RunWriter& run) {
  const std::vector<std::string> columns{"time", "x", "y", "tilt"};
  const std::vector<std::string> units{"s", "m", "m", "rad"};
  const std::vector<Attribute> rings{{"outline", std::vector<double>{-1, -1, 1, -1, 1, 1, -1, 1}},
                                     {"hole", std::vector<double>{0, -0.5, 0.5, 0, 0, 0.5}}};
  TimeSeries& body = run.add_series("/bodies/tunnel", columns, units, rings);
  body.append(std::vector<double>{0.0, 0.0, 0.0, 0.0});
  body.append(std::vector<double>{2.0, 1.0, 2.0, std::numbers::pi / 2.0});
  run.set_boundary({{10.0, 0.0, 5.0, -3.0}, {1.0, 0.0, 0.0, -1.0}, {2.0, 4.0}, {"right", "base"}});
}

class VtkHdf : public testing::Test {
protected:
  void write(bool lines) {
    RunWriter run(folder_ / "run.h5", description);
    if (lines)
      add_lines(run);
    for (std::size_t frame = 0; frame < frames; ++frame)
      write_frame(run, frame);
    run.finish();
  }
  FileReader open() const { return {folder_ / "run.h5", "run file"}; }

private:
  Folder folder_;
};

TEST_F(VtkHdf, ShowsTheFramesOneAfterTheOther) {
  write(false);
  const FileReader run = open();
  const auto points = numbers(run, "/VTKHDF/Points");
  const auto velocity = numbers(run, "/VTKHDF/PointData/velocity");
  const auto stress = numbers(run, "/VTKHDF/PointData/stress");
  const auto soil = numbers(run, "/VTKHDF/PointData/soil");
  const auto first = numbers(run, "/VTKHDF/Steps/PointOffsets");
  const auto counts = numbers(run, "/VTKHDF/NumberOfPoints");
  ASSERT_EQ(counts.size(), frames);
  for (std::size_t k = 0; k < frames; ++k) {
    ASSERT_EQ(counts[k], static_cast<double>(particles(k)));
    for (std::size_t i = 0; i < particles(k); ++i) {
      const std::size_t row = static_cast<std::size_t>(first[k]) + i;
      EXPECT_EQ(points[3 * row], value(k, 0, 2 * i));
      EXPECT_EQ(points[3 * row + 1], value(k, 0, 2 * i + 1));
      EXPECT_EQ(points[3 * row + 2], 0.0);
      EXPECT_EQ(velocity[3 * row + 1], value(k, 1, 2 * i + 1));
      EXPECT_EQ(velocity[3 * row + 2], 0.0);
      EXPECT_EQ(stress[6 * row + 3], value(k, 2, 4 * i + 3));
      EXPECT_EQ(stress[6 * row + 5], 0.0);
      EXPECT_EQ(soil[row], static_cast<double>(k));
    }
  }
  EXPECT_EQ(points.size(), 3 * static_cast<std::size_t>(std::accumulate(counts.begin(), counts.end(), 0.0)));
}

TEST_F(VtkHdf, StepsSayWhereATimeBegins) {
  write(true);
  const FileReader run = open();
  EXPECT_EQ(run.attribute_as<std::int64_t>("/VTKHDF/Steps", "NSteps"), static_cast<std::int64_t>(frames));
  EXPECT_EQ(run.attribute_as<std::string>("/VTKHDF", "Type"), "UnstructuredGrid");
  const auto times = numbers(run, "/VTKHDF/Steps/Values");
  const auto parts = numbers(run, "/VTKHDF/Steps/PartOffsets");
  const auto cell_offsets = numbers(run, "/VTKHDF/Steps/CellOffsets");
  const auto cells = numbers(run, "/VTKHDF/NumberOfCells");
  const auto ids = numbers(run, "/VTKHDF/NumberOfConnectivityIds");
  const auto id_offsets = numbers(run, "/VTKHDF/Steps/ConnectivityIdOffsets");
  const auto connectivity = numbers(run, "/VTKHDF/Connectivity");
  const auto offsets = numbers(run, "/VTKHDF/Offsets");
  const auto types = numbers(run, "/VTKHDF/Types");
  for (std::size_t k = 0; k < frames; ++k) {
    EXPECT_EQ(times[k], frame_time(k));
    ASSERT_EQ(parts[k], 2.0 * static_cast<double>(k));
    const auto part = static_cast<std::size_t>(parts[k]);
    // Vertices, each of its own point; then two faces and two rings.
    const auto cell = static_cast<std::size_t>(cell_offsets[k]);
    const auto id = static_cast<std::size_t>(id_offsets[k]);
    EXPECT_EQ(cells[part], static_cast<double>(particles(k)));
    EXPECT_EQ(types[cell], 1.0);
    EXPECT_EQ(connectivity[id + 7], 7.0);
    EXPECT_EQ(offsets[cell + part + 7], 7.0);
    EXPECT_EQ(cells[part + 1], 4.0);
    EXPECT_EQ(ids[part + 1], 2.0 + 2.0 + 5.0 + 4.0);
    const std::size_t lines = cell + particles(k);
    EXPECT_EQ(types[lines], 4.0);
    const auto begin = offsets.begin() + static_cast<std::ptrdiff_t>(lines + part + 1);
    EXPECT_THAT(std::vector<double>(begin, begin + 5), ElementsAre(0.0, 2.0, 4.0, 9.0, 13.0));
    const auto ring = connectivity.begin() + static_cast<std::ptrdiff_t>(id + particles(k) + 4);
    EXPECT_THAT(std::vector<double>(ring, ring + 5), ElementsAre(4.0, 5.0, 6.0, 7.0, 4.0)); // closed
  }
}

TEST_F(VtkHdf, FacesLieAlongTheBoundaryAndStructuresMoveAndTurn) {
  write(true);
  const FileReader run = open();
  const auto points = numbers(run, "/VTKHDF/Points");
  const auto part = numbers(run, "/VTKHDF/PointData/part");
  const auto first = numbers(run, "/VTKHDF/Steps/PointOffsets");
  for (const std::size_t k : {std::size_t{0}, std::size_t{4}, std::size_t{8}}) {
    const std::size_t line = static_cast<std::size_t>(first[k]) + particles(k);
    EXPECT_EQ(part[line - 1], 0.0);
    EXPECT_EQ(part[line], 1.0);
    EXPECT_EQ(part[line + 4], 2.0);
    const auto at = [&](std::size_t i) {
      return std::vector<double>{points[3 * (line + i)], points[3 * (line + i) + 1]};
    };
    EXPECT_THAT(at(0), ElementsAre(10.0, -1.0)); // the right side, 2 m long
    EXPECT_THAT(at(1), ElementsAre(10.0, 1.0));
    EXPECT_THAT(at(2), ElementsAre(3.0, -3.0)); // the base, 4 m long
    EXPECT_THAT(at(3), ElementsAre(7.0, -3.0));
    const double share = std::min(frame_time(k) / 2.0, 1.0);
    const double turn = share * std::numbers::pi / 2.0;
    EXPECT_NEAR(at(4)[0], share - std::cos(turn) + std::sin(turn), 1e-12); // of the corner at (-1, -1)
    EXPECT_NEAR(at(4)[1], 2.0 * share - std::sin(turn) - std::cos(turn), 1e-12);
    EXPECT_NEAR(at(8)[0], share + 0.5 * std::sin(turn), 1e-12); // of the hole's at (0, -0.5)
  }
}

/// Particles of a structure beside those of the soil, a lining of three nodes and a prop.
TEST_F(VtkHdf, StructuresHaveTheirStressAndLiningsAndPropsAreLines) {
  Folder folder;
  const std::vector<double> of_soil{1.0, 2.0, 3.0, 4.0};
  const std::vector<double> soil_stress{1, 2, 3, 4, 5, 6, 7, 8};
  const std::vector<double> of_wall{5.0, 6.0};
  const std::vector<double> wall_stress{11, 12, 13, 14};
  {
    RunWriter run(folder / "run.h5", description);
    TimeSeries& ring =
        run.add_series("/linings/ring",
                       std::vector<std::string>{"time", "x0", "y0", "n0", "x1", "y1", "n1", "x2", "y2", "n2"},
                       std::vector<std::string>{"s", "m", "m", "N/m", "m", "m", "N/m", "m", "m", "N/m"});
    TimeSeries& strut = run.add_series(
        "/props/strut", std::vector<std::string>{"time", "n", "from_x", "from_y", "to_x", "to_y"},
        std::vector<std::string>{"s", "N/m", "m", "m", "m", "m"});
    for (const double time : {0.0, 1.0}) {
      ring.append(std::vector<double>{time, time, 0.0, 9.0, 1.0, 0.0, 9.0, 0.0, 1.0, 9.0});
      strut.append(std::vector<double>{time, 9.0, -7.0, time, 7.0, 0.0});
    }
    const std::vector<Field> wall{{"position", "m", 2, of_wall}, {"stress", "Pa", 4, wall_stress}};
    for (const double time : {0.0, 1.0})
      run.write_frame(time,
                      std::vector<Field>{{"position", "m", 2, of_soil}, {"stress", "Pa", 4, soil_stress}},
                      std::vector<FramePart>{{"structures", wall}});
    run.finish();
  }
  const FileReader run(folder / "run.h5", "run file");
  const auto points = numbers(run, "/VTKHDF/Points");
  const auto part = numbers(run, "/VTKHDF/PointData/part");
  const auto stress = numbers(run, "/VTKHDF/PointData/stress");
  const auto first = static_cast<std::size_t>(numbers(run, "/VTKHDF/Steps/PointOffsets").at(1));
  ASSERT_EQ(first, 8U);
  EXPECT_THAT(std::vector<double>(part.begin() + 8, part.end()),
              ElementsAre(0.0, 0.0, 3.0, 4.0, 4.0, 4.0, 5.0, 5.0));
  EXPECT_EQ(points[3 * 10], 5.0);
  EXPECT_EQ(stress[6 * 9], 5.0);
  EXPECT_EQ(stress[6 * 10 + 3], 14.0);
  EXPECT_EQ(stress[6 * 11], 0.0); // of lines
  EXPECT_EQ(points[3 * 11], 1.0); // the lining has moved
  EXPECT_EQ(points[3 * 14], -7.0);
  EXPECT_EQ(points[3 * 14 + 1], 1.0);
  // Cells: three vertices, a closed ring and a line.
  EXPECT_THAT(numbers(run, "/VTKHDF/NumberOfCells"), ElementsAre(3.0, 2.0, 3.0, 2.0));
  EXPECT_THAT(numbers(run, "/VTKHDF/NumberOfConnectivityIds"), ElementsAre(3.0, 6.0, 3.0, 6.0));
}

TEST_F(VtkHdf, TheFileStaysOneThatIsReadAndAddedTo) {
  write(true);
  const FileReader run = open();
  EXPECT_EQ(run.attribute_as<std::string>("/", "status"), "complete");
}

TEST(VtkHdfOf, ARunWithoutFramesIsLeftAsItIs) {
  const Folder folder;
  {
    RunWriter run(folder / "run.h5", description);
    run.finish();
  }
  EXPECT_FALSE(FileReader(folder / "run.h5", "run file").exists("VTKHDF"));
}

TEST(VtkHdfOf, TablesAreAddedToAFileThatHasIt) {
  const Folder folder;
  {
    RunWriter run(folder / "run.h5", description);
    write_frame(run, 0);
    run.finish();
  }
  append_table(folder / "run.h5", "/processes", {{{"process", "1", std::vector<std::string>{"domain"}}}});
  EXPECT_TRUE(RunReader(folder / "run.h5").has_table("/processes"));
  EXPECT_EQ(RunReader(folder / "run.h5").frame_times().size(), 1U);
}

} // namespace
