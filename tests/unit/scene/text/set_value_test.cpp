#include "scene/text/set_value.hpp"

#include "tests/unit/scene/case_text.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

namespace tremolo::scene::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(SetValue, AKeyThatIsThereChangesAndNothingElse) {
  EXPECT_EQ(with_value("[mesh]\nsize = 0.5 # fine\nbox = [0, 1]\n", "mesh.size", "2"),
            "[mesh]\nsize = 2 # fine\nbox = [0, 1]\n");
  EXPECT_EQ(with_value("mesh = { size = 0.5, n = 2 }\n", "mesh.size", "0.25"),
            "mesh = { size = 0.25, n = 2 }\n");
  EXPECT_EQ(with_value("[[region]]\nsoil = \"a\"\n[[region]]\nsoil = \"b\"\n", "region[1].soil", "\"c\""),
            "[[region]]\nsoil = \"a\"\n[[region]]\nsoil = \"c\"\n");
}

TEST(SetValue, AKeyThatIsMissingJoinsItsTable) {
  EXPECT_EQ(with_value("[mesh]\nsize = 0.5 # fine\n\n[time]\n", "mesh.n", "3"),
            "[mesh]\nsize = 0.5\nn = 3 # fine\n\n[time]\n");
  EXPECT_EQ(with_value("base = { model = \"wave\" }\n", "base.form", "\"total\""),
            "base = { model = \"wave\", form = \"total\" }\n");
  EXPECT_EQ(with_value("mesh.size = 0.5\n", "mesh.n", "3"), "mesh.size = 0.5\nmesh.n = 3\n");
  EXPECT_EQ(with_value("title = \"a\"", "version", "1"), "title = \"a\"\nversion = 1");
}

TEST(SetValue, ATableThatIsMissingJoinsTheText) {
  EXPECT_EQ(with_value("[mesh]\nsize = 1", "time.fraction", "0.8"),
            "[mesh]\nsize = 1\n\n[time]\nfraction = 0.8\n");
}

TEST(SetValue, NoneTakesTheKeyOut) {
  EXPECT_EQ(with_value("[mesh]\nsize = 1\nn = 2\n", "mesh.n", std::nullopt), "[mesh]\nsize = 1\n");
  EXPECT_EQ(with_value("[mesh]\nsize = 1\n", "mesh.n", std::nullopt), "[mesh]\nsize = 1\n");
  EXPECT_EQ(with_value("[mesh]\nsize = 1\n", "time.n", std::nullopt), "[mesh]\nsize = 1\n");
}

TEST(SetValue, TheCaseHasTheValue) {
  const auto scene = parse_case(with_value(flat_case, "time.fraction", "0.75"));
  EXPECT_DOUBLE_EQ(scene.time.fraction, 0.75);
  EXPECT_DOUBLE_EQ(parse_case(with_value(scene.text, "mesh.size", "0.25")).mesh.size, 0.25);
}

TEST(SetValue, WordsBecomeStrings) {
  EXPECT_EQ(toml_value("0.5"), "0.5");
  EXPECT_EQ(toml_value("true"), "true");
  EXPECT_EQ(toml_value("[1, 2]"), "[1, 2]");
  EXPECT_EQ(toml_value("\"flip\""), "\"flip\"");
  EXPECT_EQ(toml_value("flip"), "\"flip\"");
  EXPECT_EQ(toml_value("a\"b"), "\"a\\\"b\"");
  EXPECT_EQ(toml_value("1\n[x]"), "\"1\\n[x]\"");
}

TEST(SetValue, RefusesWhatHasNoPlace) {
  const auto set = [](const std::string& key) {
    return [key] { return with_value("[mesh]\nsize = 1\n[time]\n[[region]]\nsoil = 1\n", key, "1"); };
  };
  EXPECT_THAT(set("mesh size"), ThrowsMessage<std::invalid_argument>(HasSubstr("is not a key of a case")));
  EXPECT_THAT(set(""), ThrowsMessage<std::invalid_argument>(HasSubstr("is not a key of a case")));
  EXPECT_THAT(set("mesh."), ThrowsMessage<std::invalid_argument>(HasSubstr("is not a key of a case")));
  EXPECT_THAT(set("region[4].soil"), ThrowsMessage<std::invalid_argument>(HasSubstr("no table region[4]")));
  EXPECT_THAT(set("mesh.size.x"), ThrowsMessage<std::invalid_argument>(HasSubstr("no table mesh.size")));
  EXPECT_THAT(set("mesh"), ThrowsMessage<std::invalid_argument>(HasSubstr("is a table")));
  EXPECT_THAT(set("time.n"), ThrowsMessage<std::invalid_argument>(HasSubstr("[time] of the case is empty")));
}

} // namespace
} // namespace tremolo::scene::testing
