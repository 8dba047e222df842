// The committed reference is what the program would write now.

#include "scene/keys/reference.hpp"

#include "scene/keys/keys.hpp"
#include "scene/rules/rule.hpp"
#include "tests/support/paths.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace tremolo::scene {
namespace {

std::string committed(std::string_view name) {
  std::ifstream stream(source_dir() + "/docs/" + std::string(name));
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

TEST(Reference, CommittedFilesAreCurrent) {
  for (const Reference& reference : references()) {
    EXPECT_EQ(committed(reference.page), markdown(reference)) << "run: tremolo docs docs";
    EXPECT_EQ(committed(reference.schema), json_schema(reference)) << "run: tremolo docs docs";
  }
  EXPECT_EQ(committed("checks.md"), checks_page()) << "run: tremolo docs docs";
}

TEST(Reference, DefaultsLieInTheirRange) {
  for (const Reference& reference : references())
    for (const Table& table : reference.keys)
      for (const Key& key : table.keys)
        if (!key.fallback.empty() && (key.type == Type::number || key.type == Type::integer)) {
          EXPECT_TRUE(key.range.contains(std::stod(std::string(key.fallback))))
              << table.name << "." << key.name;
        }
}

TEST(Reference, EveryKeyHasAMeaningAndAPresence) {
  for (const Reference& reference : references())
    for (const Table& table : reference.keys)
      for (const Key& key : table.keys) {
        EXPECT_FALSE(key.meaning.empty()) << table.name << "." << key.name;
        EXPECT_EQ(1,
                  (key.required ? 1 : 0) + (key.fallback.empty() ? 0 : 1) + (key.otherwise.empty() ? 0 : 1))
            << table.name << "." << key.name;
      }
}

} // namespace
} // namespace tremolo::scene
