#pragma once

// Conditions on a case beyond each key's own type and range, and warnings and notes for its user. A rule is a
// row of rule_table.cpp and a function in a file of its own: it looks at the case as read and reports what is
// violated, why, and how to mend it. A rule whose findings are errors stays silent where a value that it
// needs is missing or wrong, since that has been reported already; the others see only cases without errors.

#include "scene/case.hpp"
#include "scene/text/findings.hpp"

#include <span>
#include <string>
#include <string_view>

namespace tremolo::scene {

/// What must have been read before the rule runs.
enum class Needs {
  model,            ///< all of the case
  ground,           ///< the ground of a free field alone
  effective_stress, ///< such ground, of which a model knows the stress of the grains
  record,           ///< such ground, and the motion's record
};

struct Rule {
  Severity severity;
  Needs needs;
  void (*look)(const Case& scene, Findings& findings);
  std::string_view name;
  std::string_view asks; ///< what holds if the rule finds nothing; for a note, its content
};

/// Errors, then warnings, then notes.
std::span<const Rule> all_rules();

/// Applies the rules: those whose findings are errors, and to a case without errors the others.
/// @throws CaseErrors where anything is wrong, which includes what was found before
void judge(const Case& scene, Findings& findings);

/// Applies the rules that need no more than what is known.
void judge(const Case& scene, Findings& findings, std::span<const Needs> known);

/// The page docs/checks.md: all rules with what they ask for.
std::string checks_page();

} // namespace tremolo::scene
