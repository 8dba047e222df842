#include "scene/text/errors.hpp"

#include "base/printable.hpp"

#include <fmt/format.h>

#include <string_view>

namespace tremolo::scene {

namespace {

std::string all_messages(const std::vector<Finding>& errors) {
  std::string text;
  for (const Finding& error : errors)
    text += fmt::format("{}{}", text.empty() ? "" : "\n", error.message());
  return text;
}

std::string_view prefix(Severity severity) {
  switch (severity) {
  case Severity::error:
    break;
  case Severity::warning:
    return "warning: ";
  case Severity::note:
    return "note: ";
  }
  return "";
}

} // namespace

std::string Finding::message() const {
  const std::string where = table.empty() ? "" : fmt::format("[{}] ", table);
  return printable_line(fmt::format("{}:{}:{}: {}{}{}", file, line, column, prefix(severity), where, text));
}

CaseErrors::CaseErrors(std::vector<Finding> errors)
    : std::runtime_error(all_messages(errors)), errors_(std::move(errors)) {}

} // namespace tremolo::scene
