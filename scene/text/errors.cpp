#include "scene/text/errors.hpp"

#include "base/text/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace tremolo::scene {

namespace {

/// Errors that are printed; those behind them mostly repeat them.
constexpr std::size_t most_printed = 100;

std::string all_messages(const std::vector<Finding>& errors) {
  std::string text;
  for (std::size_t i = 0; i < std::min(errors.size(), most_printed); ++i)
    text += fmt::format("{}{}", text.empty() ? "" : "\n", errors[i].message());
  if (errors.size() > most_printed)
    text += fmt::format("\n{}: {} more errors like these", errors.back().file, errors.size() - most_printed);
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
