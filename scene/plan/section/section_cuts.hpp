#pragma once

// Cuts of a section's lines through its structure.

#include "scene/case.hpp"
#include "scene/text/findings.hpp"

#include <string>
#include <vector>

namespace tremolo::scene {

/// Way in which a line crosses a structure.
enum class Crossing {
  once,        ///< from one surface to another
  never,       ///< it passes by
  ends_within, ///< it begins or ends in the structure
  repeatedly,  ///< it leaves the structure and enters it again, as on both sides of a hole
};

struct SectionCut {
  Crossing crossing = Crossing::never;
  Section::Line line; ///< the part within the structure, from its first entry to its last exit

  double thickness() const; ///< m
};

/// @param line  of a length
SectionCut cut_of(const Structure& structure, const Section::Line& line);

/// The cuts of a section of a case without errors.
std::vector<SectionCut> cuts_of(const Case& scene, const Section& section);

/// Path of a section's line or ring, for messages.
std::string line_path(const Section& section);

/// Whether nothing is wrong with the lines of a section, and with the structure that it cuts.
bool has_lines(const Case& scene, const Section& section, const Findings& findings);

/// A line for each section: what it cuts, and how many cells.
std::string sections_text(const Case& scene);

} // namespace tremolo::scene
