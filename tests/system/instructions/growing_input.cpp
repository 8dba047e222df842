// Work whose input grows, for test_growing_input.py to count.
//
//     instructions_growing_input WORK:SIZE
//
// WORK is `strip`, ground of SIZE corners that is asked whether it crosses itself, `stack`, SIZE polygons
// upon each other whose overlaps are named, or `tables`, a case file with SIZE unknown tables. Prints SIZE.

#include "scene/case.hpp"
#include "scene/geometry.hpp"
#include "scene/meeting_boxes.hpp"
#include "scene/text/errors.hpp"

#include <iostream>
#include <string>
#include <string_view>
#include <vector>

namespace {

using namespace tremolo::scene;

/// Ground of uneven surface over an even base.
Polygon strip(std::size_t corners) {
  Polygon polygon{{0.0, 0.0}, {static_cast<double>(corners), 0.0}};
  for (std::size_t i = corners; i-- > 0;)
    polygon.push_back({static_cast<double>(i), i % 2 == 0 ? 1.0 : 1.1});
  return polygon;
}

std::string unknown_tables(std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
    text += "[x" + std::to_string(i) + "]\n";
  return text;
}

bool refused(const std::string& text) {
  try {
    parse(text, "case.toml", ".");
    return false;
  } catch (const CaseErrors&) {
    return true;
  }
}

bool did(std::string_view work, std::size_t size) {
  if (work == "strip")
    return !intersects_itself(strip(size));
  if (work == "stack")
    return overlaps(std::vector<Polygon>(size, {{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}})).size() ==
           size - 1;
  return work == "tables" && refused(unknown_tables(size));
}

} // namespace

int main(int count, char** arguments) {
  const std::string word = count == 2 ? arguments[1] : "";
  const auto colon = word.find(':');
  if (colon == std::string::npos || !did(word.substr(0, colon), std::stoul(word.substr(colon + 1)))) {
    std::cerr << "usage: instructions_growing_input strip:SIZE|stack:SIZE|tables:SIZE\n";
    return 2;
  }
  std::cout << word.substr(colon + 1) << '\n';
}
