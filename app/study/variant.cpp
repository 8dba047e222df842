#include "app/study/variant.hpp"

#include "scene/text/errors.hpp"

#include <fmt/format.h>

namespace tremolo::app {

Variant variant_of(const scene::Case& given, std::string name, std::string text, Combination values) {
  Variant variant{std::move(name), std::move(text), std::move(values), {}, {}};
  try {
    variant.scene = scene::parse(variant.text, given.file, given.directory);
  } catch (const scene::CaseErrors& errors) {
    variant.refused = errors.errors().front().message();
  }
  return variant;
}

std::string setting(const std::vector<scene::Axis>& axes, const Combination& values,
                    const std::function<bool(const scene::Axis&)>& named) {
  std::string text;
  for (std::size_t a = 0; a < axes.size(); ++a)
    if (named(axes[a]))
      text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", axes[a].key, values[a].shown);
  return text;
}

} // namespace tremolo::app
