#include "scene/text/findings.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <tuple>

namespace tremolo::scene {

namespace {

/// "soil.sand.young" -> "soil.sand" -> "soil" -> ""; "region[0]" -> "region".
std::string parent(const std::string& path) {
  const auto cut = path.find_last_of(".[");
  return cut == std::string::npos ? "" : path.substr(0, cut);
}

} // namespace

Place Findings::place(std::string path) const {
  for (; !path.empty(); path = parent(path))
    if (const auto found = places_.find(path); found != places_.end())
      return found->second;
  return {};
}

void Findings::add(const std::string& path, std::string text) {
  add(path, place(path), std::move(text));
}

void Findings::add(const std::string& path, const Place& place, std::string text) {
  const bool is_error = severity_ == Severity::error;
  if (is_error)
    unsound_.insert(path);
  if (!reported_.insert(fmt::format("{}:{}:{}", place.line, place.column, text)).second)
    return;
  (is_error ? errors_ : remarks_)
      .push_back({file_, place.line, place.column, place.table, std::move(text), severity_});
}

bool Findings::sound(std::string path) const {
  for (; !path.empty(); path = parent(path))
    if (unsound_.contains(path))
      return false;
  return true;
}

void Findings::throw_if_any() const {
  if (errors_.empty())
    return;
  auto errors = errors_;
  std::ranges::stable_sort(errors, {}, [](const Finding& e) { return std::tuple(e.line, e.column); });
  throw CaseErrors(std::move(errors));
}

} // namespace tremolo::scene
