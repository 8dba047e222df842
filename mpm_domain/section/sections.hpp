#pragma once

// The cuts of a domain through its elastic structures (cut.hpp). They have no state of their own: their
// forces follow from the particles' positions and stresses.

#include "mpm_domain/section/cut.hpp"

#include <span>
#include <string>
#include <vector>

namespace tremolo::mpm_domain {

struct Ground;

/// The cuts of a Section.
struct BodySection {
  std::string name;
  std::string structure; ///< its name
  std::size_t body;      ///< in Ground::bodies
  std::vector<Cut> cuts;
};

class Sections {
public:
  /// Particles are at their positions of the start.
  /// @throws std::invalid_argument for a section through no elastic structure, or a cut that cannot be made
  explicit Sections(const Ground& ground);

  std::span<const BodySection> all() const { return all_; }

private:
  std::vector<BodySection> all_;
};

/// Position of a cut some seconds before the present.
CutPosition position_of(const Ground& ground, const BodySection& section, std::size_t cut, double back);

/// The forces that pass through it, with the present stresses.
SectionForces forces(const Ground& ground, const BodySection& section, std::size_t cut);

} // namespace tremolo::mpm_domain
