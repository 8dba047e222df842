// The processes that serve the free fields. Equal fields (same model, same surface level and layers) share a
// process. The total field at the base is the one that both sides have; the incident wave knows no surface
// and is taken from the left side's ground, whoever serves that side: so a side that is replaced changes no
// bit of it.

#include "scene/plan/sources.hpp"
#include "scene/plan/free_field_traits.hpp"
#include "scene/plan/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace tremolo::scene {

namespace {

void serve(std::vector<SourceProcess>& sources, const FreeFieldModel& field, double surface,
           std::optional<Side> profile, Served served) {
  const auto equal = std::ranges::find_if(sources, [&](const SourceProcess& source) {
    return source.field == field && source.surface == surface && source.profile == profile;
  });
  SourceProcess& source =
      equal != sources.end() ? *equal : sources.emplace_back(SourceProcess{"", field, surface, profile, {}});
  source.serves.push_back(served);
  source.name += fmt::format("{}{}", source.name.empty() ? "" : "-", name(served.side));
}

/// The side, if it has layers of its own.
std::optional<Side> own(const LateralBoundary& boundary, Side side) {
  return boundary.own_profile.empty() ? std::nullopt : std::optional(side);
}

/// The source that serves the base with the ground of one side.
const SourceProcess& under_side(const Plan& plan, const LateralBoundary& boundary, Side side) {
  const auto source = std::ranges::find_if(plan.sources, [&](const SourceProcess& candidate) {
    return candidate.surface == boundary.surface && candidate.profile == own(boundary, side) &&
           std::ranges::find(candidate.serves, Side::base, &Served::side) != candidate.serves.end();
  });
  if (source == plan.sources.end())
    throw std::logic_error(fmt::format("no source of the base has the ground of the {} side", name(side)));
  return *source;
}

} // namespace

std::vector<SourceProcess> plan_sources(const Case& scene) {
  const auto& [sides, left, right, base] = scene.boundary;
  std::vector<SourceProcess> sources;
  if (scene.boundary.has_lateral_fields()) {
    serve(sources, left.field, left.surface, own(left, Side::left), {Side::left, BaseForm::total});
    serve(sources, right.field, right.surface, own(right, Side::right), {Side::right, BaseForm::total});
  }
  const bool blended = base.form == BaseForm::blended;
  serve(sources, base.field, left.surface, own(left, Side::left),
        {Side::base, blended ? BaseForm::total : base.form});
  if (blended)
    serve(sources, base.field, right.surface, own(right, Side::right), {Side::base, BaseForm::total});
  return sources;
}

std::string describe_base(const Case& scene, const std::vector<SourceProcess>& sources) {
  const auto& [sides, left, right, base] = scene.boundary;
  const auto& source = sources[source_index(sources, Side::base)];
  if (scene.boundary.base_is_rigid())
    return fmt::format("shaking table: rigid, it moves as '{}' says; the run is seen from it", source.name);
  if (base.form == BaseForm::total)
    return fmt::format("total: velocity and stress of the whole free field with its surface at y = {} m, "
                       "from '{}'; dashpots "
                       "see scattered waves only, exact at any angle",
                       left.surface, source.name);
  if (base.form == BaseForm::blended)
    return fmt::format("blended: the total free fields with their surfaces at y = {} m (left) and y = {} m "
                       "(right), blended linearly from the left side to the right one",
                       left.surface, right.surface);
  std::string text =
      fmt::format("incident: velocity and stress of the incident wave alone, from '{}'; dashpots take up all "
                  "waves that come down, exact at vertical incidence",
                  source.name);
  if (left.surface != right.surface)
    text += fmt::format(
        "; the surfaces at y = {} m (left) and {} m (right) do not enter, since a wave that only travels up "
        "has met neither",
        left.surface, right.surface);
  return text;
}

std::size_t source_index(const std::vector<SourceProcess>& sources, Side side) {
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (std::ranges::find(sources[i].serves, side, &Served::side) != sources[i].serves.end())
      return i;
  throw std::invalid_argument(
      fmt::format("the case has no free field at the {}: its sides are periodic, or walls", name(side)));
}

std::string program(const FreeFieldModel& field) {
  const std::string_view ours = traits(field.model).program;
  return ours.empty() ? field.file.string() : std::string(ours);
}

BaseSources base_sources(const Case& scene, const Plan& plan) {
  const auto& [sides, left, right, base] = scene.boundary;
  if (base.form != BaseForm::blended)
    return {source_of(plan, Side::base).name, std::nullopt};
  return {under_side(plan, left, Side::left).name, under_side(plan, right, Side::right).name};
}

const SourceProcess& source_of(const Plan& plan, Side side) {
  return plan.sources[source_index(plan.sources, side)];
}

} // namespace tremolo::scene
