#pragma once

// The ladder of `tremolo cost`: every combination of the values of some knobs, a case each.

#include "scene/case.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tremolo::app {

/// A key of the case file and the values that it takes. `width` is not a key: it moves the sides of the
/// model.
struct Knob {
  std::string key;
  std::vector<std::string> values; ///< as the user writes them; "none": without the key
};

/// The cell size, along which an error converges.
inline constexpr const char* size_key = "mesh.size";
/// Distance of the sides, m: the box and the regions' corners on its sides move, its centre stays.
inline constexpr const char* width_key = "width";

/// One knob from "KEY=VALUE,VALUE,...". Commas in brackets, braces and quotes do not part values.
/// @throws std::invalid_argument where it is not written so, or a value stands twice
Knob knob_from(const std::string& text);

/// Variants worth trying on any case: cells of four, two and one times the case's size, both transfers
/// without dissipation, and the step of the case and one near the stability limit.
std::vector<Knob> default_knobs(const scene::Case& scene);

/// One combination.
struct Rung {
  std::vector<std::string> values; ///< one a knob
  std::string text;                ///< of the case
  std::optional<scene::Case> scene;
  std::string refused; ///< why there is no such case; empty where there is
};

/// All combinations; the last knob turns fastest.
/// @throws std::invalid_argument for a knob named twice, or a key that cannot be written into the text
std::vector<Rung> ladder(const scene::Case& given, const std::vector<Knob>& knobs);

/// The rung with these values.
Rung rung_with(const scene::Case& given, const std::vector<Knob>& knobs, std::vector<std::string> values);

/// "mesh.size = 0.5, time.transfer = apic": the knobs that have more than one value; `but` is left out.
std::string setting(const std::vector<Knob>& knobs, const std::vector<std::string>& values,
                    const std::string& but = {});

/// A name for the rung's folder, which depends only on the requested values.
std::string folder_name(const std::vector<Knob>& knobs, const std::vector<std::string>& values);

/// The largest cell size (m) not above `size` that the case takes with these values of the other knobs; none
/// where no size near it is taken.
std::optional<double> admissible_size(const scene::Case& given, const std::vector<Knob>& knobs,
                                      std::vector<std::string> values, double size);

} // namespace tremolo::app
