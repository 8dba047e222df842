#include "results/hdf5/hdf5_read.hpp"
#include "sample_run.hpp"

#include <gmock/gmock.h>
#include <hdf5.h>

#include <array>
#include <csignal>
#include <fstream>
#include <sys/resource.h>
#include <sys/wait.h>

using namespace tremolo::results;
using namespace sample_run;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

namespace {

/// Writes a run with everything a run may hold.
void write_full_run(const std::filesystem::path& file, std::size_t frames) {
  RunWriter run(file, description);
  run.attribute("mesh_size", 0.5);
  run.attribute("box", std::vector<double>{0, -40, 100, 0});
  run.attribute("wave", std::string("SV"));
  run.attribute("soil_names", std::vector<std::string>{"sand", "clay of the deep"});
  run.attribute("threads", std::int64_t{2});
  TimeSeries& toe = run.add_series("/monitors/toe", monitor_columns, monitor_units);
  run.add_series("/monitors/crest", monitor_columns, monitor_units);
  run.set_boundary(faces());
  for (std::size_t frame = 0; frame < frames; ++frame) {
    for (std::size_t row = 0; row < 10; ++row) {
      toe.append(monitor_row(10 * frame + row));
    }
    const auto v_ff = filled(frame, 6, 6);
    const auto v_m = filled(frame, 7, 6);
    const auto traction = filled(frame, 8, 6);
    run.append_boundary(frame_time(frame), {v_ff, v_m, traction});
    write_frame(run, frame);
  }
  run.table("/timings", {{{"pass", "", std::vector<std::string>{"p2g", "stress update"}},
                          {"seconds", "s", std::vector<double>{1.5, 2.5}},
                          {"calls", "1", std::vector<std::int64_t>{10, 20}}}});
  run.finish();
}

/// Sources of 9,000 faces are 135 kB of names.
TEST(RunFile, HasRoomForTheSourcesOfManyFaces) {
  const Folder folder;
  BoundaryFaces many;
  constexpr std::size_t count = 9000;
  many.position.assign(2 * count, 1.0);
  many.normal.assign(2 * count, 0.0);
  many.length.assign(count, 0.25);
  for (std::size_t f = 0; f < count; ++f)
    many.source.push_back(f % 2 == 0 ? "left-right-base" : "base");
  RunWriter run(folder / "run.h5", description);
  run.set_boundary(many);
  run.finish();
  const FileReader file(folder / "run.h5", "run file");
  EXPECT_EQ(file.attribute_as<std::vector<std::string>>("/boundary", "source"), many.source);
}

TEST(RunFile, ReturnsWhatWasWritten) {
  const Folder folder;
  write_full_run(folder / "run.h5", 12);
  const RunReader run(folder / "run.h5");

  EXPECT_EQ(run.title(), "sample");
  EXPECT_EQ(run.status(), "complete");
  EXPECT_EQ(run.case_text(), description.case_text);
  EXPECT_EQ(run.plan(), description.plan);
  EXPECT_EQ(std::get<double>(run.attribute("mesh_size")), 0.5);
  EXPECT_THAT(std::get<std::vector<double>>(run.attribute("box")), ElementsAre(0, -40, 100, 0));
  EXPECT_EQ(std::get<std::string>(run.attribute("wave")), "SV");
  EXPECT_EQ(std::get<std::int64_t>(run.attribute("threads")), 2);
  EXPECT_THAT(std::get<std::vector<std::string>>(run.attribute("soil_names")),
              ElementsAre("sand", "clay of the deep"));
  EXPECT_FALSE(run.has_attribute("angle_deg"));

  ASSERT_EQ(run.frame_times().size(), 12U);
  for (std::size_t frame = 0; frame < 12; ++frame) {
    EXPECT_EQ(run.frame_times()[frame], frame_time(frame));
    EXPECT_THAT(run.frame_fields(frame), ElementsAre("position", "soil", "stress", "velocity"));
    const FieldData stress = run.frame_field(frame, "stress");
    EXPECT_EQ(stress.unit, "Pa");
    EXPECT_EQ(stress.components, 4U);
    EXPECT_EQ(stress.values, filled(frame, 2, 4 * particles(frame)));
    EXPECT_EQ(run.frame_field(frame, "soil").values,
              std::vector<double>(particles(frame), static_cast<double>(frame)));
  }

  EXPECT_THAT(run.monitors(), ElementsAre("crest", "toe"));
  const SeriesData toe = run.series("/monitors/toe");
  EXPECT_EQ(toe.columns, monitor_columns);
  EXPECT_EQ(toe.units, monitor_units);
  ASSERT_EQ(toe.rows(), 120U);
  const auto last = monitor_row(119);
  EXPECT_TRUE(std::equal(last.begin(), last.end(), toe.values.end() - 9));
  const std::vector<double> second = toe.column(monitor_columns[1]);
  ASSERT_EQ(second.size(), 120U);
  EXPECT_EQ(second.back(), last[1]);
  EXPECT_FALSE(toe.has("nothing"));
  EXPECT_THAT([&] { toe.column("nothing"); },
              ThrowsMessage<std::runtime_error>("a series of the run has no column 'nothing'"));
  EXPECT_EQ(run.series("/monitors/crest").rows(), 0U);
}

TEST(RunFile, KeepsWhatFramesHaveBesideSoilAndHowMuchThereIs) {
  const Folder folder;
  const std::vector<double> position{1.0, 2.0, 3.0, 4.0};
  {
    RunWriter run(folder / "run.h5", description);
    for (const std::size_t nodes : {2U, 0U}) { // a body that hovers has none
      const std::vector<double> place(position.begin(), position.begin() + static_cast<long>(2 * nodes));
      const std::vector<double> force(nodes, 5.0);
      const std::vector<std::int32_t> body(nodes, 1);
      const std::vector<Field> contact{
          {"position", "m", 2, place}, {"normal_force", "N/m", 1, force}, {"body", "1", 1, body}};
      const std::vector<Field> structures{{"position", "m", 2, position}};
      run.write_frame(0.1, std::vector<Field>{{"position", "m", 2, position}},
                      std::vector<FramePart>{{"contact", contact}, {"structures", structures}});
    }
    const std::vector<Field> wrong{{"position", "m", 2, position}, {"area", "m", 1, std::span(position)}};
    EXPECT_THAT(
        [&] {
          run.write_frame(0.2, std::vector<Field>{{"position", "m", 2, position}},
                          std::vector<FramePart>{{"contact", wrong}});
        },
        ThrowsMessage<std::invalid_argument>(
            HasSubstr("field area has 4 values where 2 point of contacts with 1 components need 2")));
    run.finish();
  }
  const RunReader run(folder / "run.h5");
  ASSERT_EQ(run.frame_times().size(), 2U);
  EXPECT_THAT(run.frame_fields(0), ElementsAre("position"));
  EXPECT_THAT(run.part_fields("contact", 0), ElementsAre("body", "normal_force", "position"));
  EXPECT_THAT(run.part_fields("structures", 1), ElementsAre("position"));
  EXPECT_EQ(run.part_field("structures", 1, "position").values, position);
  EXPECT_EQ(run.part_field("contact", 0, "position").values, position);
  EXPECT_EQ(run.part_field("contact", 0, "normal_force").unit, "N/m");
  EXPECT_THAT(run.part_field("contact", 0, "body").values, ElementsAre(1, 1));
  EXPECT_TRUE(run.part_field("contact", 0, "body").integers);
  EXPECT_THAT(run.part_field("contact", 1, "position").values, ElementsAre());
  EXPECT_EQ(run.part_field("contact", 1, "position").components, 2U);
}

TEST(RunFile, HasNoContactNodesWithoutStructures) {
  const Folder folder;
  write_full_run(folder / "run.h5", 1);
  EXPECT_THAT(RunReader(folder / "run.h5").part_fields("contact", 0), ElementsAre());
}

TEST(RunFile, KeepsTablesOfTextNumbersAndCounts) {
  const Folder folder;
  write_full_run(folder / "run.h5", 1);
  append_table(
      folder / "run.h5", "/processes",
      {{{"name", "", std::vector<std::string>{"domain"}}, {"seconds", "s", std::vector<double>{3.25}}}});
  const RunReader run(folder / "run.h5");
  const Table timings = run.table("/timings");
  ASSERT_EQ(timings.columns.size(), 3U);
  EXPECT_THAT(std::get<std::vector<std::string>>(timings.columns[0].values),
              ElementsAre("p2g", "stress update"));
  EXPECT_THAT(std::get<std::vector<double>>(timings.columns[1].values), ElementsAre(1.5, 2.5));
  EXPECT_THAT(std::get<std::vector<std::int64_t>>(timings.columns[2].values), ElementsAre(10, 20));
  EXPECT_EQ(timings.columns[1].unit, "s");
  EXPECT_TRUE(run.has_table("/processes"));
  EXPECT_FALSE(run.has_table("/nothing"));
}

TEST(RunFile, WritesFilesOfTables) {
  const Folder folder;
  const std::vector<NamedTable> tables{
      {"/points", {{{"name", "", std::vector<std::string>{"toe"}}, {"x", "m", std::vector<double>{30.0}}}}},
      {"/histories/toe", {{{"time", "s", std::vector<double>{0.0, 0.5}}}}}};
  write_tables(folder / "verify.h5", "verification", tables);
  const hid_t file = H5Fopen((folder / "verify.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t time = H5Dopen2(file, "/histories/toe/time", H5P_DEFAULT);
  std::array<double, 2> values{};
  EXPECT_GE(H5Dread(time, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  EXPECT_THAT(values, ElementsAre(0.0, 0.5));
  EXPECT_GT(H5Lexists(file, "/points/name", H5P_DEFAULT), 0);
  H5Dclose(time);
  H5Fclose(file);
}

TEST(RunFile, SaysWhyARunEnded) {
  const Folder folder;
  {
    RunWriter run(folder / "a.h5", description);
    write_frame(run, 0);
    EXPECT_EQ(RunReader(folder / "a.h5").status(), "running"); // and can be read while it goes on
    run.abort("column 'left' died with signal 9");
  }
  EXPECT_EQ(RunReader(folder / "a.h5").status(), "aborted: column 'left' died with signal 9");
  { const RunWriter run(folder / "b.h5", description); }
  EXPECT_EQ(RunReader(folder / "b.h5").status(), "running");
  mark_aborted(folder / "b.h5", "killed");
  EXPECT_EQ(RunReader(folder / "b.h5").status(), "aborted: killed");
}

TEST(RunFile, UsesTheFormatWithoutConsistencyFlags) {
  const Folder folder;
  write_full_run(folder / "run.h5", 2);
  std::ifstream in(folder / "run.h5", std::ios::binary);
  std::array<char, 9> head{};
  in.read(head.data(), head.size());
  EXPECT_EQ(head[8], 0) << "superblock version";
}

TEST(RunFile, RefusesWhatContradictsItself) {
  const Folder folder;
  RunWriter run(folder / "run.h5", description);
  TimeSeries& toe = run.add_series("/monitors/toe", monitor_columns, monitor_units);
  const std::vector<double> short_row{1.0, 2.0};
  EXPECT_THAT([&] { toe.append(short_row); },
              ThrowsMessage<std::invalid_argument>("a row of /monitors/toe has 2 values where 9 are needed"));
  EXPECT_THAT([&] { run.add_series("/monitors/toe", monitor_columns, monitor_units); },
              ThrowsMessage<std::invalid_argument>("/monitors/toe is in the run already"));
  EXPECT_THAT([&] { run.attribute("title", std::string("again")); },
              ThrowsMessage<std::invalid_argument>("attribute title is in the run already"));

  const std::vector<double> four(4, 0.0);
  const std::vector<double> three(3, 0.0);
  const std::vector<Field> uneven{{"position", "m", 2, std::span(four)},
                                  {"volume", "m2", 1, std::span(three)}};
  EXPECT_THAT([&] { run.write_frame(0.0, uneven); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("field volume has 3 values where 2 particles")));
  const std::vector<Field> nowhere{{"volume", "m2", 1, std::span(three)}};
  EXPECT_THROW(run.write_frame(0.0, nowhere), std::invalid_argument);
  EXPECT_THROW(run.append_boundary(0.0, {four, four, four}), std::invalid_argument);

  write_frame(run, 0);
  EXPECT_THAT([&] { run.attribute("late", 1.0); },
              ThrowsMessage<std::invalid_argument>("an attribute must be declared before the first frame"));
  run.finish();
  EXPECT_THROW(run.flush(), std::invalid_argument);
  EXPECT_EQ(RunReader(folder / "run.h5").frame_times().size(), 1U) << "refusals leave the run as it was";
}

TEST(RunFile, ReaderNamesTheFileAndTheReason) {
  const Folder folder;
  EXPECT_THAT([&] { RunReader run(folder / "absent.h5"); },
              ThrowsMessage<std::runtime_error>(AllOf(HasSubstr("absent.h5"), HasSubstr("No such file"))));
  std::ofstream(folder / "text.h5") << "not HDF5";
  EXPECT_THAT([&] { RunReader run(folder / "text.h5"); },
              ThrowsMessage<std::runtime_error>(AllOf(HasSubstr("text.h5"), HasSubstr("cannot open"))));
  write_full_run(folder / "run.h5", 1);
  const RunReader run(folder / "run.h5");
  EXPECT_THAT([&] { run.frame_field(3, "stress"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("no frame 3, the run holds 1")));
  EXPECT_THAT([&] { run.frame_field(0, "pressure"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("cannot open /frames/0000/pressure")));
}

/// A link of a group is a message of its header: version, flags, order of creation (8 bytes), length of the
/// name, name (HDF5 File Format Specification IV.A.2.g). Where one cannot be decoded, libhdf5 1.10 frees
/// links that it has not read.
TEST(RunFile, ALinkThatCannotBeDecodedIsRefused) {
  const Folder folder;
  write_full_run(folder / "run.h5", 12);
  std::fstream file(folder / "run.h5", std::ios::in | std::ios::out | std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(file), {});
  const auto name = bytes.find(std::string("\4") + "0001");
  ASSERT_NE(name, std::string::npos);
  ASSERT_EQ(bytes[name - 10], 1);
  file.seekp(static_cast<std::streamoff>(name - 10));
  file.put(99);
  file.close();
  EXPECT_THAT([&] { RunReader run(folder / "run.h5"); },
              ThrowsMessage<std::runtime_error>(
                  AllOf(HasSubstr("run.h5: cannot list /frames: "), HasSubstr("bad version number"))));
}

TEST(RunFile, SeriesMayHaveAttributesAndAGroupOfTheirOwn) {
  const Folder folder;
  const std::array<std::string, 2> columns{"time", "x"};
  const std::array<std::string, 2> units{"s", "m"};
  {
    RunWriter run(folder / "run.h5", description);
    const std::vector<Attribute> attributes{{"outline", std::vector<double>{0.0, 1.0, 2.0}}, {"mass", 5.0}};
    TimeSeries& block = run.add_series("/bodies/block", columns, units, attributes);
    run.add_series("/bodies/wall", columns, units).append(std::array{0.0, 2.0});
    block.append(std::array{0.0, 1.0});
    run.finish();
  }
  EXPECT_THAT(RunReader(folder / "run.h5").series("/bodies/block").values, ElementsAre(0.0, 1.0));
  EXPECT_THAT(RunReader(folder / "run.h5").series("/bodies/wall").values, ElementsAre(0.0, 2.0));
  const hid_t file = H5Fopen((folder / "run.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t outline = H5Aopen_by_name(file, "/bodies/block", "outline", H5P_DEFAULT, H5P_DEFAULT);
  std::array<double, 3> corners{};
  H5Aread(outline, H5T_NATIVE_DOUBLE, corners.data());
  H5Aclose(outline);
  const hid_t mass = H5Aopen_by_name(file, "/bodies/block", "mass", H5P_DEFAULT, H5P_DEFAULT);
  double kilograms = 0.0;
  H5Aread(mass, H5T_NATIVE_DOUBLE, &kilograms);
  H5Aclose(mass);
  EXPECT_LE(H5Aexists_by_name(file, "/bodies/wall", "outline", H5P_DEFAULT), 0);
  H5Fclose(file);
  EXPECT_THAT(corners, ElementsAre(0.0, 1.0, 2.0));
  EXPECT_EQ(kilograms, 5.0);
}

TEST(RunFile, RefusesAnotherMajorSchema) {
  const Folder folder;
  write_full_run(folder / "run.h5", 1);
  const hid_t file = H5Fopen((folder / "run.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const hid_t attribute = H5Aopen(file, "schema_version", H5P_DEFAULT);
  const hid_t type = H5Aget_type(attribute);
  H5Awrite(attribute, type, "2.0");
  H5Tclose(type);
  H5Aclose(attribute);
  H5Fclose(file);
  EXPECT_THAT([&] { RunReader run(folder / "run.h5"); },
              ThrowsMessage<std::runtime_error>(HasSubstr("schema version 2.0 cannot be read")));
}

TEST(RunFile, WriterNamesTheFileThatCannotBeCreated) {
  EXPECT_THAT([] { RunWriter run("/proc/no-such-folder/run.h5", description); },
              ThrowsMessage<std::runtime_error>(AllOf(HasSubstr("/proc/no-such-folder/run.h5: cannot create"),
                                                      HasSubstr("No such file or directory"))));
}

/// A child whose files may not pass 1 MB, as on a disk that fills up; it returns the message of the
/// failure.
std::string message_of_full_disk(const std::filesystem::path& file, const std::filesystem::path& message) {
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1'000'000, 1'000'000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write_full_run(file, 2000);
    } catch (const std::runtime_error& error) {
      std::ofstream(message) << error.what();
      ::_exit(7);
    }
    ::_exit(0);
  }
  int state = 0;
  ::waitpid(child, &state, 0);
  EXPECT_EQ(WEXITSTATUS(state), 7);
  std::ifstream in(message);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(RunFile, FullDiskIsAnErrorAndLeavesAReadableFile) {
  const Folder folder;
  const std::string message = message_of_full_disk(folder / "run.h5", folder / "message");
  EXPECT_THAT(message, AllOf(HasSubstr((folder / "run.h5").string()), HasSubstr("File too large")));
  const RunReader run(folder / "run.h5");
  ASSERT_GT(run.frame_times().size(), 0U);
  for (std::size_t frame = 0; frame < run.frame_times().size(); ++frame) {
    EXPECT_EQ(run.frame_field(frame, "velocity").values, filled(frame, 1, 2 * particles(frame)));
  }
}

} // namespace
