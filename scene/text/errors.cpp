#include "scene/text/errors.hpp"

#include <fmt/format.h>

namespace tremolo::scene {

namespace {

std::string all_messages(const std::vector<CaseError>& errors) {
  std::string text;
  for (const CaseError& error : errors)
    text += fmt::format("{}{}", text.empty() ? "" : "\n", error.message());
  return text;
}

} // namespace

std::string CaseError::message() const {
  const std::string where = table.empty() ? "" : fmt::format("[{}] ", table);
  return fmt::format("{}:{}:{}: {}{}", file, line, column, where, text);
}

CaseErrors::CaseErrors(std::vector<CaseError> errors)
    : std::runtime_error(all_messages(errors)), errors_(std::move(errors)) {}

} // namespace tremolo::scene
