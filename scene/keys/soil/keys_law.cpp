#include "scene/keys/soil/keys_law.hpp"

#include "materials/elastic/elastic_parameters.hpp"
#include "materials/law/law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <deque>
#include <map>
#include <string>

namespace tremolo::scene {

namespace {

using materials::Parameter;

/// Keys view their texts.
std::string_view kept(std::string text) {
  static std::deque<std::string> texts;
  return texts.emplace_back(std::move(text));
}

/// The words with a capital letter in front.
std::string capitalised(std::string_view words) {
  std::string text(words);
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

/// The meaning as a sentence, with a remark behind it.
std::string sentences(std::string_view meaning, std::string_view remark) {
  return fmt::format("{}.{}{}", capitalised(meaning), remark.empty() ? "" : " ", remark);
}

std::vector<Parameter> with_elastic_constants(std::vector<Parameter> own) {
  own.insert(own.begin(), materials::elastic_constants.begin(), materials::elastic_constants.end());
  return own;
}

std::vector<Parameter> of_backbone(std::initializer_list<std::string_view> names) {
  std::vector<Parameter> own;
  for (const std::string_view name : names)
    own.push_back(materials::find(materials::backbone_parameters(), name));
  return with_elastic_constants(std::move(own));
}

template <class Parameters>
std::vector<Parameter> list(const Parameters& parameters) {
  return {parameters.begin(), parameters.end()};
}

std::vector<Parameter> of_fields(std::string_view law_name) {
  materials::Law law = materials::law_of_fields(law_name).value();
  return materials::texts(materials::fields(law));
}

std::vector<Parameter> taken_by(SoilModel model) {
  using enum SoilModel;
  switch (model) {
  case mohr_coulomb:
    return with_elastic_constants(list(materials::mohr_coulomb_parameters()));
  case multi_yield_clay:
    return with_elastic_constants(list(materials::multi_yield_clay_parameters()));
  case hyperbolic:
    return of_backbone({"reference_strain", "shear_strength"});
  case mkz:
    return of_backbone({"reference_strain", "beta", "exponent", "shear_strength"});
  case gqh:
    return of_backbone({"shear_strength"});
  case pm4sand:
    return materials::texts(materials::pm4sand_parameters());
  case pdmy03:
    return materials::texts(materials::pdmy03_parameters());
  default:
    return with_elastic_constants(of_fields(name(model)));
  }
}

/// Models that say the same of a parameter.
struct Use {
  Parameter parameter;
  std::vector<std::string_view> models;

  std::string named() const {
    return models.size() > 3 ? "others" : fmt::format("`{}`", fmt::join(models, "`, `"));
  }
};

bool same(const Range& a, const Range& b) {
  return a.text() == b.text();
}

bool same(const Parameter& a, const Parameter& b) {
  return a.meaning == b.meaning && a.remark == b.remark && a.otherwise == b.otherwise &&
         a.fallback == b.fallback && same(a.range, b.range);
}

/// From the least to the largest that any model takes.
Range hull(const std::vector<Use>& uses) {
  Range all = uses.front().parameter.range;
  for (const Use& use : uses) {
    const Range& one = use.parameter.range;
    if (one.low < all.low || (one.low == all.low && !one.low_open)) {
      all.low = one.low;
      all.low_open = one.low_open;
    }
    if (one.high > all.high || (one.high == all.high && !one.high_open)) {
      all.high = one.high;
      all.high_open = one.high_open;
    }
  }
  return all;
}

bool all_remark(const std::vector<Use>& uses) {
  return std::ranges::all_of(
      uses, [&](const Use& use) { return use.parameter.remark == uses.front().parameter.remark; });
}

/// The parameter as most models have it.
const Parameter& most_used(const std::vector<Use>& uses) {
  return std::ranges::max_element(uses, {}, [](const Use& use) { return use.models.size(); })->parameter;
}

std::string meaning_of(const std::vector<Use>& uses, const Range& all) {
  const Parameter& common = most_used(uses);
  const bool one_remark = all_remark(uses);
  std::string text = sentences(common.meaning, one_remark ? common.remark : "");
  for (const Use& use : uses) {
    std::vector<std::string> parts;
    if (use.parameter.meaning != common.meaning)
      parts.emplace_back(use.parameter.meaning);
    if (!same(use.parameter.range, all))
      parts.push_back(use.parameter.range.text());
    if (!one_remark && !use.parameter.remark.empty())
      parts.emplace_back(use.parameter.remark);
    if (!parts.empty())
      text += fmt::format(" {}: {}{}", capitalised(use.named()), fmt::join(parts, "; "),
                          parts.back().ends_with('.') ? "" : ".");
  }
  return text;
}

/// What holds without the key, where models differ in it.
std::string otherwise_of(const std::vector<Use>& uses) {
  std::vector<std::string> parts;
  for (const Use& use : uses)
    parts.push_back(
        use.parameter.needed()
            ? fmt::format("needed by {}", use.named())
            : fmt::format("{}: {}", use.named(),
                          use.parameter.fallback.empty() ? use.parameter.otherwise : use.parameter.fallback));
  return fmt::format("{}", fmt::join(parts, "; "));
}

bool agree_without(const std::vector<Use>& uses) {
  return std::ranges::all_of(uses, [&](const Use& use) {
    return use.parameter.otherwise == uses.front().parameter.otherwise &&
           use.parameter.fallback == uses.front().parameter.fallback;
  });
}

Key merged(std::vector<Use> uses) {
  // What holds for most stands last, as that of "others".
  std::ranges::stable_sort(uses, {}, [](const Use& use) { return use.models.size() > 3; });
  Key key = key_of(uses.front().parameter);
  std::vector<std::string_view> models;
  for (const Use& use : uses)
    models.insert(models.end(), use.models.begin(), use.models.end());
  key.range = hull(uses);
  key.meaning = kept(meaning_of(uses, key.range));
  if (!agree_without(uses)) {
    key.required = false;
    key.fallback = {};
    key.otherwise = kept(otherwise_of(uses));
  }
  if (models.size() < all_words<SoilModel>().size())
    key.when = {"model", std::move(models)};
  return key;
}

} // namespace

std::span<const Parameter> parameters_of(SoilModel model) {
  static const std::map<SoilModel, std::vector<Parameter>> all = [] {
    std::map<SoilModel, std::vector<Parameter>> taken;
    for (const auto& each : words(SoilModel{}))
      taken[each.value] = taken_by(each.value);
    return taken;
  }();
  return all.at(model);
}

Key key_of(const Parameter& parameter) {
  return {.name = parameter.name,
          .type = parameter.whole ? Type::integer : Type::number,
          .unit = parameter.unit,
          .meaning = kept(sentences(parameter.meaning, parameter.remark)),
          .required = parameter.needed(),
          .fallback = parameter.fallback,
          .otherwise = parameter.otherwise,
          .range = parameter.range};
}

std::vector<Key> law_keys() {
  std::vector<std::string_view> names;
  std::map<std::string_view, std::vector<Use>> uses;
  for (const auto& [model, word] : words(SoilModel{}))
    for (const Parameter& parameter : parameters_of(model)) {
      auto& known = uses[parameter.name];
      if (known.empty())
        names.push_back(parameter.name);
      const auto alike =
          std::ranges::find_if(known, [&](const Use& use) { return same(use.parameter, parameter); });
      if (alike == known.end())
        known.push_back({parameter, {word}});
      else
        alike->models.push_back(word);
    }
  std::vector<Key> keys;
  for (const std::string_view name : names)
    keys.push_back(merged(uses[name]));
  return keys;
}

} // namespace tremolo::scene
