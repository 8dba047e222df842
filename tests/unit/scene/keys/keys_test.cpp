// Each kind of error in a single key, with its exact message, and the values that a good case gives.

#include "tests/unit/scene/case_text.hpp"
#include "scene/keys/keys.hpp"

#include <gmock/gmock.h>

#include <sys/stat.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace tremolo::scene::testing {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

TEST(Keys, GoodCaseHasItsValuesAndDefaults) {
  const auto scene = parse_case(std::string(flat_case));
  EXPECT_EQ(scene.title, "flat");
  EXPECT_EQ(std::get<RickerPulse>(scene.motion.shakings.at(0).source).frequency, 3.0);
  EXPECT_EQ(scene.motion.reference.y, -10.0);
  EXPECT_EQ(materials::elasticity(scene.soils.at(0).law).young, 40e6);
  EXPECT_EQ(scene.mesh.particles_per_cell, 2);
  EXPECT_EQ(scene.time.fraction, 0.5);
  EXPECT_EQ(scene.time.transfer, Transfer::apic);
  EXPECT_EQ(scene.boundary.base.form, BaseForm::total);
  EXPECT_FALSE(scene.gravity.has_value());
  EXPECT_EQ(scene.timed.at(0).duration, 2.0);
  EXPECT_EQ(scene.coupling.mode, ExchangeMode::window);
  EXPECT_EQ(scene.coupling.connect_deadline, 30.0);
  EXPECT_EQ(scene.output.fields.size(), 5U);
}

TEST(Keys, ValuesInForceTellWhereTheyCameFrom) {
  const auto scene = parse_case(std::string(flat_case));
  const auto origin = [&](std::string_view key) {
    for (const auto& value : scene.values)
      if (value.key == key)
        return value.value + " " + value.origin;
    return std::string("absent");
  };
  EXPECT_EQ(origin("mesh.size"), "1 case.toml:22:8");
  EXPECT_EQ(origin("time.fraction"), "0.5 default");
  EXPECT_EQ(origin("region[0].soil"), "\"sand\" case.toml:19:8");
  EXPECT_EQ(origin("mesh.box"), "[0, -10, 20, 0] case.toml:23:7");
}

TEST(Keys, TrueOrFalse) {
  EXPECT_FALSE(parse_case(std::string(flat_case)).recording.exchange);
  const auto scene = parse_case(plus("[record]\nexchange = true\non_full_disk = \"go_on\"\n"));
  EXPECT_TRUE(scene.recording.exchange);
  EXPECT_EQ(scene.recording.on_full_disk, OnFullDisk::go_on);
  const auto value = std::ranges::find(scene.values, "record.exchange", &ValueInForce::key);
  ASSERT_NE(value, scene.values.end());
  EXPECT_EQ(value->value, "true");
  EXPECT_THAT(errors_of(plus("[record]\nexchange = \"yes\"\n")),
              Contains(HasSubstr("[record] 'exchange' must be true or false, found a string")));
}

TEST(Keys, TheSideOfARecordingBelongsToRecordings) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "keys_recording.h5";
  std::ofstream(file, std::ios::binary) << "\x89HDF\r\n\x1a\n";
  const auto text = with("left = { model = \"wave\" }", "left = { model = \"recording\", file = \"" +
                                                            file.string() + "\", side = \"right\" }");
  EXPECT_EQ(parse_case(text).boundary.left.field.side, Side::right);
  std::filesystem::remove(file);
  EXPECT_THAT(errors_of(with("left = { model = \"wave\" }", "left = { model = \"wave\", side = \"left\" }")),
              Contains(HasSubstr("'side' does not apply to model = \"wave\", only to recording")));
}

TEST(Keys, IntegersThatNoDoubleHoldsAreReadAsTheNearestOne) {
  // 2^53 + 1 lies halfway between two doubles; the even one, 2^53, is the nearest.
  const auto scene = parse_case(with("young = 40e6", "young = 9007199254740993"));
  EXPECT_EQ(scene.halfspace.young, 9007199254740992.0);
  EXPECT_THAT(errors_of(with("young = 40e6", "young = -9007199254740993")),
              ElementsAre(HasSubstr("[halfspace] 'young' = -9007199254740993 is out of range, must be > 0")));
}

TEST(Keys, WholeNumbersAreRefusedAsTheyStandInTheFile) {
  const auto keep = [](const char* value) {
    return errors_of(plus(std::string("[checkpoint]\nkeep = ") + value + "\n"));
  };
  EXPECT_THAT(keep("2"), IsEmpty());
  EXPECT_THAT(
      keep("-9223372036854775808"),
      ElementsAre(HasSubstr("'keep' = -9223372036854775808 is out of range, must be in [0, 1000000]")));
  EXPECT_THAT(keep("9007199254740993"),
              ElementsAre(HasSubstr("'keep' = 9007199254740993 is out of range, must be in [0, 1000000]")));
}

TEST(Keys, EveryWholeNumberFitsAnInt) {
  for (const KeyTable keys : {case_keys(), soil_test_keys(), library_keys()})
    for (const Table& table : keys)
      for (const Key& key : table.keys)
        if (key.type == Type::integer) {
          EXPECT_GE(key.range.low, std::numeric_limits<int>::min()) << table.name << " " << key.name;
          EXPECT_LE(key.range.high, std::numeric_limits<int>::max()) << table.name << " " << key.name;
        }
}

TEST(Keys, UnknownKeyNamesTheNearest) {
  EXPECT_THAT(errors_of(with("size = 1.0", "size = 1.0\nsiz = 2.0")),
              ElementsAre("case.toml:23:1: [mesh] unknown key 'siz', did you mean 'size'?"));
  EXPECT_THAT(errors_of(with("title", "titel = \"x\"\ntitle")),
              ElementsAre("case.toml:1:1: unknown key 'titel', did you mean 'title'?"));
  EXPECT_THAT(errors_of(with("model = \"wave\" }", "model = \"wave\", modle = 1 }")),
              ElementsAre("case.toml:25:26: [boundary.left] unknown key 'modle', did you mean 'model'?"));
}

TEST(Keys, UnknownTableNamesTheNearest) {
  EXPECT_THAT(errors_of(plus("[couplin]\nmode = \"window\"\n")),
              ElementsAre("case.toml:31:2: unknown key 'couplin', did you mean 'coupling'?"));
}

TEST(Keys, UnknownKeyFarFromAllListsThem) {
  EXPECT_THAT(errors_of(plus("[verify]\nabracadabra = 1\n")),
              ElementsAre("case.toml:32:1: [verify] unknown key 'abracadabra', known: tolerance"));
}

TEST(Keys, MissingKeyAndTable) {
  EXPECT_THAT(errors_of(with("size = 1.0\n", "")),
              ElementsAre("case.toml:21:1: [mesh] missing 'size', number m: Cell size h."));
  EXPECT_THAT(
      errors_of(with("[surface]\nlevel = 0.0\n", "")),
      ElementsAre("case.toml:1:1: missing table [surface]: the free surface of the free field, unless "
                  "the base is a shaking table"));
}

TEST(Keys, WrongType) {
  EXPECT_THAT(errors_of(with("size = 1.0", "size = \"1.0\"")),
              ElementsAre("case.toml:22:8: [mesh] 'size' must be a number, found a string"));
  EXPECT_THAT(errors_of(with("size = 1.0", "size = 1.0\nparticles_per_cell = 2.5")),
              ElementsAre("case.toml:23:22: [mesh] 'particles_per_cell' must be an integer, found a number"));
  EXPECT_THAT(errors_of(with("\"flat\"", "3")),
              ElementsAre("case.toml:1:9: 'title' must be a string, found an integer"));
  EXPECT_THAT(
      errors_of(with("[0.0, -10.0]", "[0.0]")),
      ElementsAre(
          "case.toml:6:13: [motion] 'reference' must be an array of 2 numbers [x, y], found 1 entries"));
  EXPECT_THAT(
      errors_of(with("[[region]]", "[region]")),
      ElementsAre(
          "case.toml:18:1: [[region]] 'region' must be an array of tables, found a table: write [[region]]"));
  EXPECT_THAT(
      errors_of(with("[surface]\nlevel = 0.0", "").insert(0, "surface = 0.0\n")),
      ElementsAre("case.toml:1:11: [surface] 'surface' must be a table, found a number: write [surface]"));
}

TEST(Keys, NotFinite) {
  EXPECT_THAT(errors_of(with("size = 1.0", "size = nan")),
              ElementsAre("case.toml:22:8: [mesh] 'size' is nan, must be a finite number"));
  EXPECT_THAT(errors_of(with("level = 0.0", "level = -inf")),
              ElementsAre("case.toml:8:9: [surface] 'level' is -inf, must be a finite number"));
  EXPECT_THAT(errors_of(with("[20.0, 0.0]", "[20.0, nan]")),
              ElementsAre("case.toml:20:48: [[region]] 'polygon' is nan, must be a finite number"));
}

TEST(Keys, OutOfRange) {
  EXPECT_THAT(
      errors_of(with("angle_deg = 0.0", "angle_deg = 90.0")),
      ElementsAre("case.toml:5:13: [motion] 'angle_deg' = 90 is out of range, must be in [0, 90) degrees"));
  EXPECT_THAT(errors_of(with("density = 1700.0", "density = 0.0")),
              ElementsAre("case.toml:10:11: [halfspace] 'density' = 0 is out of range, must be > 0 kg/m3"));
  EXPECT_THAT(errors_of(plus("[time]\nfraction = 1.5\n")),
              ElementsAre("case.toml:32:12: [time] 'fraction' = 1.5 is out of range, must be in (0, 1]"));
  // Sampled, either would take all memory.
  EXPECT_THAT(
      errors_of(with("frequency = 3.0", "frequency = 1e9")),
      ElementsAre("case.toml:3:41: [motion.pulse] 'frequency' = 1000000000 is out of range, must be in "
                  "[0.001, 1000] Hz"));
  EXPECT_THAT(errors_of(with("time = 1.0", "time = 1e9")),
              ElementsAre("case.toml:3:53: [motion.pulse] 'time' = 1000000000 is out of range, must be in "
                          "[-10000, 10000] s"));
}

TEST(Keys, UnknownChoice) {
  EXPECT_THAT(errors_of(with("wave = \"SV\"", "wave = \"XYZ\"")),
              ElementsAre("case.toml:4:8: [motion] 'wave' = \"XYZ\" is not known, known: SV, P"));
  EXPECT_THAT(
      errors_of(plus("[output]\nfields = [\"velocty\"]\n")),
      ElementsAre("case.toml:32:11: [output] 'velocty' in 'fields' is not known, did you mean 'velocity'?"));
}

TEST(Keys, KeyOfAnotherChoiceDoesNotApply) {
  EXPECT_THAT(
      errors_of(with("poisson = 0.28\n[[region]]", "poisson = 0.28\nsoftening = 15.0\n[[region]]")),
      ElementsAre(
          "case.toml:18:13: [soil.sand] 'softening' does not apply to model = \"linear_elastic\", only to "
          "mohr_coulomb"));
}

TEST(Keys, InvalidToml) {
  EXPECT_THAT(errors_of(with("size = 1.0", "size = ")),
              ElementsAre(::testing::StartsWith("case.toml:22:8: not valid TOML: ")));
}

TEST(Keys, AllErrorsAtOnceInTheOrderOfTheFile) {
  auto text = with("angle_deg = 0.0", "angle_deg = -1.0");
  text = with("level = 0.0", "levle = 0.0", text);
  text = with("soil = \"sand\"", "soil = \"snad\"", text);
  text = with("size = 1.0", "size = 0.0", text);
  EXPECT_THAT(
      errors_of(text),
      ElementsAre("case.toml:5:13: [motion] 'angle_deg' = -1 is out of range, must be in [0, 90) degrees",
                  "case.toml:7:1: [surface] missing 'level', number m: y of the free surface.",
                  "case.toml:8:1: [surface] unknown key 'levle', did you mean 'level'?",
                  "case.toml:19:8: [[region]] soil 'snad' is not defined, did you mean 'sand'?",
                  "case.toml:22:8: [mesh] 'size' = 0 is out of range, must be > 0 m"));
}

TEST(Elasticity, ModuliAndSpeedsGiveTheSameSoil) {
  // E = 40 MPa, nu = 0.28, rho = 1700: G = E/(2(1+nu)) = 15.625 MPa, c_s = sqrt(G/rho), c_p/c_s =
  // sqrt((2-2nu)/(1-2nu)).
  const double vs = std::sqrt(15.625e6 / 1700.0);
  const double vp = vs * std::sqrt(1.44 / 0.44);
  const auto scene = parse_case(
      with("young = 40e6\npoisson = 0.28", "vs = " + std::to_string(vs) + "\nvp = " + std::to_string(vp)));
  EXPECT_NEAR(scene.halfspace.young, 40e6, 1.0);
  EXPECT_NEAR(scene.halfspace.poisson, 0.28, 1e-7);
  const auto mixed = parse_case(with("young = 40e6\n", "vs = " + std::to_string(vs) + "\n"));
  EXPECT_NEAR(mixed.halfspace.young, 40e6, 1.0);
  EXPECT_EQ(mixed.halfspace.poisson, 0.28);
}

TEST(Elasticity, RefusesHalfAndDoubleDescriptions) {
  EXPECT_THAT(errors_of(with("poisson = 0.28\n", "")),
              ElementsAre("case.toml:9:1: [halfspace] missing 'poisson': 'young' needs it"));
  EXPECT_THAT(errors_of(with("young = 40e6\npoisson = 0.28\n", "")),
              ElementsAre("case.toml:9:1: [halfspace] missing elastic constants: give 'young' and 'poisson', "
                          "'vs' and 'vp', or 'vs' and 'poisson'"));
  EXPECT_THAT(errors_of(with("young = 40e6\n", "young = 40e6\nvs = 95.0\n")),
              ElementsAre("case.toml:12:6: [halfspace] 'vs' is one value too many: give 'young' and "
                          "'poisson', 'vs' and 'vp', "
                          "or 'vs' and 'poisson'"));
  EXPECT_THAT(errors_of(with("young = 40e6\n", "vs = 95.0\nvp = 200.0\n")),
              ElementsAre(HasSubstr("[halfspace] 'vp' is one value too many")));
  EXPECT_THAT(errors_of(with("young = 40e6\npoisson = 0.28\n", "vs = 95.0\n")),
              ElementsAre(HasSubstr("[halfspace] missing 'vp' or 'poisson': 'vs' needs one of them")));
  EXPECT_THAT(
      errors_of(with("young = 40e6\npoisson = 0.28\n", "vs = 100.0\nvp = 110.0\n")),
      ElementsAre(
          "case.toml:12:6: [halfspace] 'vp' = 110 is too low for 'vs' = 100, must be > sqrt(4/3) vs = 115.47 "
          "m/s"));
}

TEST(Stages, AShakingAfterAtMostOneGravity) {
  EXPECT_THAT(errors_of(with("[[stage]]", "[[stage]]\nkind = \"gravity\"\n[[stage]]")), IsEmpty());
  EXPECT_THAT(errors_of(plus("[[stage]]\nkind = \"gravity\"\n")),
              ElementsAre("case.toml:32:8: [[stage]] the gravity stage must come before the shaking stage"));
  EXPECT_THAT(
      errors_of(with("kind = \"shaking\"\nduration_s = 2.0", "kind = \"gravity\"")),
      ElementsAre(
          "case.toml:28:1: [[stage]] missing [[stage]] of kind = \"shaking\": how long the motion acts"));
  EXPECT_THAT(
      errors_of(with("kind = \"shaking\"", "kind = \"shaking\"\nacceleration = 9.81")),
      ElementsAre(
          "case.toml:30:16: [[stage]] 'acceleration' does not apply to kind = \"shaking\", only to gravity"));
}

TEST(MotionTable, PulseOrFileButOne) {
  EXPECT_THAT(errors_of(with("wave = \"SV\"", "file = \"a.AT2\"\nwave = \"SV\"")),
              ElementsAre("case.toml:2:1: [motion] 'pulse' and 'file' exclude each other: remove one"));
  EXPECT_THAT(
      errors_of(with("pulse = { shape = \"ricker\", frequency = 3.0, time = 1.0, velocity = 0.1 }\n", "")),
      ElementsAre("case.toml:2:1: [motion] missing 'pulse' or 'file': what the incident wave is"));
  EXPECT_THAT(errors_of(with("wave = \"SV\"", "scale = 2.0\nwave = \"SV\"")),
              ElementsAre("case.toml:4:9: [motion] 'scale' does not apply to 'pulse', only to 'file'"));
}

TEST(SoilTable, SofteningIsScaledToTheMesh) {
  const std::string law =
      "model = \"mohr_coulomb\"\ncohesion_peak = 4e3\ncohesion_residual = 0.0\nfriction_peak_deg = 45.0\n"
      "friction_residual_deg = 28.0\nsoftening = 15.0\nreference_size = 0.5";
  const auto scene = parse_case(with("model = \"linear_elastic\"", law));
  const auto& soil = std::get<materials::MohrCoulomb>(scene.soils.at(0).law);
  EXPECT_DOUBLE_EQ(soil.softening, 30.0); // h = 1 m: eta h/h_ref
  EXPECT_DOUBLE_EQ(soil.friction_peak, std::acos(-1.0) / 4.0);
  EXPECT_FALSE(soil.tension_cutoff.has_value());
}

TEST(Text, KeysOfTooManyPartsAreRefused) {
  std::string deep = "a";
  for (int i = 0; i < 50000; ++i)
    deep += ".a";
  EXPECT_THAT(errors_of(deep + " = 1\n"), ElementsAre("case.toml:1:1: a key of more than 100 parts"));
  EXPECT_THAT(errors_of("title = \"" + deep + "\"\n" + with("title = \"flat\"\n", "")), IsEmpty());
}

TEST(Text, ManyUnknownTablesAreTold) {
  std::string text(flat_case);
  for (int i = 0; i < 20000; ++i)
    text += "[x" + std::to_string(i) + "]\n";
  EXPECT_EQ(errors_of(text).size(), 20000U);
  EXPECT_THAT(
      [&] { parse_case(text); },
      ThrowsMessage<CaseErrors>(AllOf(HasSubstr("unknown key 'x99'"), Not(HasSubstr("unknown key 'x100'")),
                                      EndsWith("\ncase.toml: 19900 more errors like these"))));
}

/// What a terminal would obey.
TEST(Text, ControlCharactersOfTheFileAreShownNotObeyed) {
  EXPECT_THAT(errors_of("\"\\u001b[31mred\\n\" = 1\n" + std::string(flat_case)),
              ElementsAre(StartsWith("case.toml:1:1: unknown key '\\x1b[31mred\\n', known: ")));
  EXPECT_THAT(
      errors_of(with("title = \"flat\"", "title = \"\\u001b[31mred\"")),
      ElementsAre("case.toml:1:9: 'title' = \"\\x1b[31mred\" holds a control character or the end of a "
                  "line, must be plain text"));
  EXPECT_THAT(errors_of(with("[soil.sand]", "[soil.\"sand\\u0007\"]",
                             with("soil = \"sand\"", "soil = \"sand\\u0007\""))),
              Contains(HasSubstr("[soil.sand\\x07] the name holds a control character")));
}

TEST(Load, FoldersAndPipesAreNoCases) {
  const auto refusal = [](const std::filesystem::path& file) {
    try {
      load(file);
    } catch (const CaseErrors& errors) {
      return std::string(errors.what()).substr(file.string().size());
    }
    return std::string();
  };
  EXPECT_EQ(refusal(::testing::TempDir()), ":1:1: cannot be read: this is a folder; give the file in it");
  const auto pipe = std::filesystem::path(::testing::TempDir()) / "case_pipe.toml";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(refusal(pipe), ":1:1: cannot be read: not a regular file");
  std::filesystem::remove(pipe);
}

TEST(Load, MissingFileIsOneClearError) {
  try {
    load("/nowhere/case.toml");
    FAIL();
  } catch (const CaseErrors& errors) {
    EXPECT_STREQ(errors.what(), "/nowhere/case.toml:1:1: there is no such file");
  }
}

} // namespace
} // namespace tremolo::scene::testing
