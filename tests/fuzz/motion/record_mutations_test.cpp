// Whatever is done to a file of a motion, reading it gives a sound motion or refuses it in one line that
// names the file: it never crashes, hangs, lets another exception out or takes memory without bound.
// Mutations are drawn from a seeded generator; a failure prints the text. TREMOLO_FUZZ_MUTANTS sets another
// number of them for each format: 100000 is the long form, which is run by hand.

#include "motion/make/recipe.hpp"
#include "motion/read/read.hpp"
#include "motion/read/write.hpp"
#include "tests/support/hdf5_motion.hpp"
#include "tests/support/network_texts.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_mutator.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::motion {
namespace {

using namespace std::string_view_literals;

constexpr std::array tokens = {"nan"sv,
                               "-inf"sv,
                               "1e308"sv,
                               "-1"sv,
                               "0"sv,
                               "1e-300"sv,
                               "99999999999999999999"sv,
                               "1e-12"sv,
                               "1E-8"sv,
                               "1e9"sv,
                               "0,5 1,5"sv,
                               "9007199254740993"sv,
                               "NPTS="sv,
                               "DT="sv,
                               "UNITS"sv,
                               "CM/S/S"sv,
                               "VELOCITY"sv,
                               "within"sv,
                               "1.0D+5"sv,
                               ","sv,
                               ";"sv,
                               "\n"sv,
                               "\r\r\n"sv,
                               "#"sv,
                               "\xff"sv,
                               "\0"sv,
                               "\t"sv,
                               "t,a"sv,
                               "0.02"sv,
                               "20000000"sv,
                               "UNITS OF 1000 G"sv,
                               "x 1e-3 g"sv,
                               "/&\n"sv,
                               "-999"sv,
                               "99999999"sv,
                               "1.7E+38"sv,
                               "(8F10.3)"sv,
                               "[pulse]\n"sv,
                               "= [1, 2"sv,
                               "\""sv};

/// A motion in HDF5 of which anything may be missing, of another size or out of range.
testing::Hdf5Motion hdf5(tremolo::testing::Draw& draw) {
  constexpr std::array<double, 6> steps = {0.01, 0.0, -1.0, NAN, INFINITY, 1e-300};
  constexpr std::array<double, 4> values = {0.25, -1e308, NAN, INFINITY};
  const auto plain_word = [&draw](std::string_view key) -> std::string {
    if (key == "unit")
      return draw.below(2) == 0 ? "g" : "cm/s";
    return key == "quantity" ? "acceleration" : "within";
  };
  testing::Hdf5Motion motion;
  for (std::size_t n = 1 + draw.below(12); n > 0; --n)
    motion.samples.push_back(values[draw.below(40) == 0 ? draw.below(values.size()) : 0]);
  if (draw.below(8) != 0)
    motion.dt = steps[draw.below(8) == 0 ? draw.below(steps.size()) : 0];
  for (const char* key : {"unit", "quantity", "kind"})
    if (draw.below(2) == 0)
      motion.texts[key] = draw.below(16) == 0 ? std::string(1 + draw.below(200), 'x') : plain_word(key);
  if (draw.below(8) == 0)
    motion.name = "record";
  motion.variable_length = draw.below(2) == 0;
  return motion;
}

/// The end of a file cut off, as a transfer or a full disk leaves it.
std::uintmax_t cut(tremolo::testing::Draw& draw, std::uintmax_t size) {
  return draw.below(4) == 0 ? draw.below(size + 1) : size;
}

struct Tally {
  std::size_t read = 0;
  std::size_t refused = 0;
};

/// One reading; `input` is printed where anything but a motion or a clear refusal comes out.
template <class Read>
void attempt(Read&& read, const std::string& input, Tally& tally) {
  try {
    read();
    ++tally.read;
  } catch (const RecordError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("x."), std::string::npos) << text;
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    ++tally.refused;
  } catch (const std::exception& error) {
    FAIL() << error.what() << "\n" << input;
  }
}

/// In the suite, or as many as the environment asks for.
int mutants(int in_suite) {
  const char* asked = std::getenv("TREMOLO_FUZZ_MUTANTS");
  return asked != nullptr ? std::atoi(asked) : tremolo::test_support::repetitions(in_suite);
}

struct Format {
  std::string name;
  std::string file;
  std::string text;
  ReadAs as = {};
  int in_suite = 10000;
};

/// The name of a case in the list of tests.
void PrintTo(const Format& format, std::ostream* stream) {
  *stream << format.name;
}

class TextFuzz : public ::testing::TestWithParam<Format> {};

TEST_P(TextFuzz, MutationsAreReadOrRefused) {
  const Format& format = GetParam();
  tremolo::testing::TextMutator mutate(42, tokens);
  Tally tally;
  const int count = mutants(format.in_suite);
  for (int i = 0; i < count; ++i) {
    const std::string text = mutate(format.text);
    attempt(
        [&] {
          std::istringstream stream(text);
          require_sound(parse_record(stream, format.file, format.as));
        },
        text, tally);
  }
  const auto few = static_cast<std::size_t>(count / 40); // the generator reaches both outcomes
  EXPECT_GT(tally.read, few);
  EXPECT_GT(tally.refused, few);
}

INSTANTIATE_TEST_SUITE_P(
    Formats, TextFuzz,
    ::testing::Values(
        Format{"PEER", "x.AT2",
               "A RECORD\nACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.2 Hz\n"
               "NPTS=   8, DT=   .0200 SEC\n .1E-01 -.2 0.3 .4\n .1E-01 -.2 0.3 .4\n"},
        Format{"PEER, velocity", "x.txt",
               "A RECORD\nVELOCITY TIME SERIES IN UNITS OF CM/S, OUTCROP\n"
               "8    0.0100    NPTS, DT\n .1E-01 -.2 0.3 .4\n .1E-01 -.2 0.3 .4\n"},
        Format{"PEER, fields that touch", "x.AT2",
               "ACCELERATION IN UNITS OF MILLI-G\nNPTS= 8, DT= .02\n"
               " 0.000541-0.000624-0.002109 0.000000\n-0.003872-0.000624-0.002109 0.000000\n"},
        Format{"table", "x.csv",
               "# made by hand\ntime (s),acceleration (m/s2) within\n0,1e-3\n0.01,-2\n0.02,3\n0.03,4\n"},
        Format{"table of columns",
               "x.csv",
               "time (ms),N-S (0.1 g),E-W (x 1e-3 g)\n0,1e-3,1\n10,-2,2\n20,3,3\n30,4,4\n",
               {.column = "E-W"}},
        Format{"count and step",
               "x.txt",
               "a title\n8 0.0100\n .1E-01 -.2 0.3 .4\n .1E-01 -.2 0.3 .4\n",
               {.unit = Unit::g}}));

std::vector<Format> networks() {
  std::vector<Format> formats;
  for (const auto& network : tremolo::testing::network_texts())
    formats.push_back({.name = network.format,
                       .file = network.file,
                       .text = network.text,
                       .as = {.component = "1"},
                       .in_suite = 2000});
  return formats;
}

INSTANTIATE_TEST_SUITE_P(Networks, TextFuzz, ::testing::ValuesIn(networks()));

/// Cut or with a byte changed, a number of a header can only be found by chance; so one after the other.
TEST(NetworkFuzz, EachNumberOfAHeaderIsReplaced) {
  for (const auto& network : tremolo::testing::network_texts()) {
    Tally tally;
    const std::string& text = network.text;
    for (std::size_t at = 0; at < text.size(); ++at) {
      const auto is_digit = [&](std::size_t i) { return text[i] >= '0' && text[i] <= '9'; };
      if (!is_digit(at) || (at > 0 && is_digit(at - 1)))
        continue;
      const std::size_t end = std::min(text.find_first_not_of("0123456789", at), text.size());
      for (const char* number : {"0", "9", "-1", "99999999"}) {
        std::string changed = text;
        changed.replace(at, end - at, number);
        attempt(
            [&] {
              std::istringstream stream(changed);
              require_sound(parse_record(stream, network.file, {.component = "1"}));
            },
            changed, tally);
      }
    }
    EXPECT_GT(tally.refused, 10U) << network.format;
  }
}

TEST(RecipeFuzz, MutationsAreReadOrRefused) {
  const std::string original =
      "# A pulse between four corner frequencies; what happens to this line, or to the\n"
      "# next, is of no consequence, so that some of the mutations leave a good recipe\n"
      "title = \"a\"\nkind = \"incident\"\ndt = 0.01\nsamples = 400\n[pulse]\nshape = "
      "\"ormsby\"\nunit = \"g\"\namplitude = 1\ntime = 1\ncorners = [1, 2, 3, 4.0]\n";
  tremolo::testing::TextMutator mutate(7, tokens);
  Tally tally;
  for (int i = 0, count = mutants(5000); i < count; ++i) {
    const std::string text = mutate(original);
    attempt(
        [&] {
          std::istringstream stream(text);
          parse_recipe(stream, "x.toml");
        },
        text, tally);
  }
  const std::size_t few = (tally.read + tally.refused) / 50;
  EXPECT_GT(tally.read, few);
  EXPECT_GT(tally.refused, few);
}

// Bytes inside HDF5's own tables are left alone: libhdf5 1.10 reads freed memory there, which no caller can
// mend.
TEST(Hdf5Fuzz, FilesAreReadOrRefused) {
  const testing::TemporaryFolder folder;
  const auto file = folder / "x.h5";
  tremolo::testing::Draw draw(3);
  Tally tally;
  const int count = tremolo::test_support::repetitions(1500);
  for (int i = 0; i < count; ++i) {
    testing::write_hdf5(file, hdf5(draw));
    std::filesystem::resize_file(file, cut(draw, std::filesystem::file_size(file)));
    attempt([&] { require_sound(read_record(file)); }, "file " + std::to_string(i), tally);
  }
  const auto few = static_cast<std::size_t>(count / 15);
  EXPECT_GT(tally.read, few);
  EXPECT_GT(tally.refused, few);
}

} // namespace
} // namespace tremolo::motion
