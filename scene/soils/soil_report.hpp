#pragma once

// The parameters of a soil in force, in the names and units of its table.

#include "scene/case.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tremolo::scene {

struct ParameterInForce {
  std::string name;
  double value = 0.0;
  std::string unit; ///< angles in degrees
  std::string meaning;
  std::string origin; ///< "case.toml:14:9", "library hostun_dr45", or the rule it follows from
  std::string word;   ///< of a choice, what the file says
};

/// The name of a soil's model as its table, or the library, gives it.
/// @param table   the soil's in the file, "soil.sand"
/// @param values  of the file
std::string model_in_force(const std::string& table, const std::vector<ValueInForce>& values);

/// Every parameter of a soil; none of a law whose parameters are all given as they are.
/// @param table   the soil's in the file, "soil.sand"
/// @param values  of the file
std::vector<ParameterInForce> parameters_in_force(const Soil& soil, const std::string& table,
                                                  const std::vector<ValueInForce>& values);

/// The parameters as lines of text.
std::string text(const std::vector<ParameterInForce>& parameters);

/// The strength that a backbone implies against the one that the case gives.
struct ImpliedStrength {
  std::string text;  ///< in words
  bool near = false; ///< within a tenth
};

/// The stress of a hysteretic soil's backbone at 10 % shear strain, which implies a strength, compared with
/// the strength that the case gives. Empty for other soils, and if no strength is given.
std::optional<ImpliedStrength> implied_strength(const Soil& soil);

} // namespace tremolo::scene
