#pragma once

// The ladder of `tremolo cost`: every combination of the values of some knobs, a variant of the case each. A
// knob is an axis whose values stand as the user writes them; "none" is the case without the key.

#include "app/study/variant.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tremolo::app {

/// The cell size, along which an error converges.
inline constexpr const char* size_key = "mesh.size";
/// No key, but the distance of the sides, m: the box and the regions' corners on its sides move, its centre
/// stays.
inline constexpr const char* width_key = "width";

scene::AxisValue knob_value(const std::string& value);
scene::Axis knob(std::string key, const std::vector<std::string>& values);

/// One knob from "KEY=VALUE,VALUE,...". Commas in brackets, braces and quotes do not part values.
/// @throws std::invalid_argument where it is not written so, or a value stands twice
scene::Axis knob_from(const std::string& text);

/// Variants worth trying on any case: cells of four, two and one times the case's size, both transfers
/// without dissipation, and the step of the case and one near the stability limit.
std::vector<scene::Axis> default_knobs(const scene::Case& scene);

/// All combinations; the last knob turns fastest. The name of a variant is the same whenever the same values
/// are asked for.
/// @throws std::invalid_argument for a knob named twice, or a key that cannot be written into the text
std::vector<Variant> ladder(const scene::Case& given, const std::vector<scene::Axis>& knobs);

/// The variant with these values.
Variant rung(const scene::Case& given, const std::vector<scene::Axis>& knobs, const Combination& values);

/// "time.transfer = apic": the knobs that have more than one value, but the cell size.
std::string family(const std::vector<scene::Axis>& knobs, const Combination& values);

/// The largest cell size (m) not above `size` that the case takes with these values of the other knobs; none
/// where no size near it is taken.
std::optional<double> admissible_size(const scene::Case& given, const std::vector<scene::Axis>& knobs,
                                      Combination values, double size);

} // namespace tremolo::app
