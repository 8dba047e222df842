// The committed reference is what the program would write now.

#include "scene/reference.hpp"

#include "scene/keys.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace tremolo::scene {
namespace {

std::string committed(const char* name) {
  std::ifstream stream(std::string(TREMOLO_SOURCE_DIR "/docs/") + name);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

TEST(Reference, CommittedFilesAreCurrent) {
  EXPECT_EQ(committed("case-file.md"), reference_markdown()) << "run: tremolo docs docs";
  EXPECT_EQ(committed("case.schema.json"), reference_json_schema()) << "run: tremolo docs docs";
}

TEST(Reference, DefaultsLieInTheirRange) {
  for (const Table& table : key_table())
    for (const Key& key : table.keys)
      if (!key.fallback.empty() && (key.type == Type::number || key.type == Type::integer)) {
        EXPECT_TRUE(key.range.contains(std::stod(std::string(key.fallback))))
            << table.name << "." << key.name;
      }
}

TEST(Reference, EveryKeyHasAMeaningAndAPresence) {
  for (const Table& table : key_table())
    for (const Key& key : table.keys) {
      EXPECT_FALSE(key.meaning.empty()) << table.name << "." << key.name;
      EXPECT_EQ(1, (key.required ? 1 : 0) + (key.fallback.empty() ? 0 : 1) + (key.otherwise.empty() ? 0 : 1))
          << table.name << "." << key.name;
    }
}

} // namespace
} // namespace tremolo::scene
