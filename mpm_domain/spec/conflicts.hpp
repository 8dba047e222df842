#pragma once

// What of a model does not go together. The domain refuses it, and before a run a rule of cases reports it at
// the key that asks for it: both read this table, in which each pair stands once, with why and with what to
// do instead.

#include "mpm_domain/spec/numerics.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::mpm_domain {

struct Spec;

/// What a model has, as far as it does not go with everything else.
struct Combination {
  Scheme scheme;
  int particles_per_cell = 2;
  ParticleBoxes boxes = ParticleBoxes::fixed;
  Sides sides = Sides::free_field;
  bool levels = false, rigid_base = false, matched_layer = false, water = false, structures = false,
       linings = false, surface_loads = false, earthworks = false;
};

struct Feature {
  std::string_view text; ///< in messages
  std::string_view key;  ///< of a case that asks for it; empty: a table of its own does
  bool (*is_in)(const Combination& model);
};

/// Two features that do not go together. The first is the one to change.
struct Conflict {
  const Feature& feature;
  const Feature& other;
  std::string_view why;

  bool is_in(const Combination& model) const { return feature.is_in(model) && other.is_in(model); }
  /// A sentence of it.
  std::string text() const;
};

/// All that are known.
std::span<const Conflict> all_conflicts();

/// @throws std::invalid_argument naming all conflicts of a spec
void refuse_conflicts(const Spec& spec);

} // namespace tremolo::mpm_domain
