#include "scene/rules/rules.hpp"

#include "scene/rules/rule.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace tremolo::scene {

namespace {

/// The rules of a severity under their heading.
std::string section(Severity severity, std::string_view heading, std::string_view says) {
  std::string text = fmt::format("\n## {}\n\n{}\n\n| rule | what it asks for | of a free field alone |\n"
                                 "|---|---|---|\n",
                                 heading, says);
  for (const Rule& rule : all_rules())
    if (rule.severity == severity)
      text +=
          fmt::format("| `{}` | {} | {} |\n", rule.name, rule.asks, rule.needs == Needs::model ? "" : "yes");
  return text;
}

} // namespace

bool mesh_is_sound(const Case& scene, const Findings& findings) {
  if (!findings.sound("mesh.size") || !findings.sound("mesh.box"))
    return false;
  for (std::size_t i = 0; i < scene.mesh.refine.size(); ++i)
    for (const char* key : {"box", "level"})
      if (!findings.sound(fmt::format("refine[{}].{}", i, key)))
        return false;
  return true;
}

void judge(const Case& scene, Findings& findings) {
  constexpr std::array all = {Needs::model, Needs::ground, Needs::effective_stress, Needs::record};
  judge(scene, findings, all);
}

void judge(const Case& scene, Findings& findings, std::span<const Needs> known) {
  for (const Rule& rule : all_rules()) {
    if (std::ranges::find(known, rule.needs) == known.end())
      continue;
    if (rule.severity != Severity::error)
      findings.throw_if_any();
    findings.grade(rule.severity);
    rule.look(scene, findings);
  }
}

std::string checks_page() {
  return "# Checks\n\n`tremolo check CASE` applies all of these to a case before anything is computed, and "
         "so does "
         "every command\nthat reads one. What is found is printed as `file:line:column: [table] what, why, "
         "what would "
         "be right`.\nCommands that compute a free field alone apply those of its ground.\n" +
         section(Severity::error, "Errors", "Nothing is computed until none is left.") +
         section(Severity::warning, "Warnings", "The case runs; its results may not be what they seem.") +
         section(Severity::note, "Notes", "What a user should know before trusting the results.");
}

} // namespace tremolo::scene
