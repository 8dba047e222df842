#include "materials/sand/pdmy03/pdmy03_parameters.hpp"

#include "materials/elastic/elastic_parameters.hpp"

#include <array>
#include <vector>

namespace tremolo::materials {
namespace {

using Input = Pdmy03Input;
using Law = Pdmy03;
using enum Pdmy03Evidence;

template <auto Member>
std::optional<double>& of(Input& input) {
  return input.*Member;
}

template <auto Member, std::size_t K>
std::optional<double>& entry(Input& input) {
  return (input.*Member)[K];
}

template <auto Member>
double in(const Law& law) {
  return law.*Member;
}

template <auto Member, std::size_t K>
double entry_in(const Law& law) {
  return (law.*Member)[K];
}

constexpr std::string_view set = "of the recommended set of `relative_density`";
constexpr Range angle = {.low = 1.0, .high = 65.0};

constexpr Parameter relative_density_of_set = {
    .name = "relative_density",
    .unit = "1",
    .meaning = "relative density D_R that names a recommended set",
    .range = {.low = 0.05, .high = 1.2},
    .otherwise = "all is given",
    .remark = "0.33, 0.57, 0.74 or 0.87; between them there is none, and none is guessed."};

/// A coefficient of contraction or dilation.
constexpr Pdmy03Row coefficient(std::string_view name, std::string_view meaning, Range range,
                                std::optional<double>& (*input)(Input&), double (*value)(const Law&),
                                Pdmy03Evidence evidence) {
  return {{.name = name, .unit = "1", .meaning = meaning, .range = range, .otherwise = set},
          input,
          value,
          0.0,
          evidence};
}

constexpr std::array<Pdmy03Row, Law::origin_count> rows = {{
    {{.name = "density",
      .unit = "kg/m3",
      .meaning = "density of the saturated soil",
      .range = above_zero,
      .otherwise = set},
     &of<&Input::density>,
     [](const Law& law) { return law.elastic.density; }},
    {{.name = "shear_modulus",
      .unit = "Pa",
      .meaning = "shear modulus G_r at small strain and the reference pressure",
      .range = above_zero,
      .otherwise = set},
     &of<&Input::shear_modulus>,
     [](const Law& law) { return law.elastic.shear_modulus(); },
     0.0,
     strength},
    {{.name = "bulk_modulus",
      .unit = "Pa",
      .meaning = "bulk modulus B_r at the reference pressure",
      .range = above_zero,
      .otherwise = set},
     &of<&Input::bulk_modulus>,
     [](const Law& law) { return law.elastic.bulk_modulus(); },
     0.0,
     strength},
    {{.name = "friction_deg",
      .unit = "degrees",
      .meaning = "friction angle in the test that `cone` names",
      .range = angle,
      .otherwise = set},
     &of<&Input::friction>,
     &in<&Law::friction>,
     0.0,
     strength},
    {{.name = "phase_transformation_deg",
      .unit = "degrees",
      .meaning = "angle of phase transformation, of the `cone`: contraction below and dilation above",
      .range = angle,
      .otherwise = set},
     &of<&Input::phase_transformation>,
     &in<&Law::phase_transformation>,
     0.0,
     strength},
    coefficient("contraction_a", "rate of contraction c_a", from_zero, &entry<&Input::contraction, 0>,
                &entry_in<&Law::contraction, 0>, strength),
    coefficient("contraction_b", "contraction c_b: growth with the dilative strain of earlier cycles",
                from_zero, &entry<&Input::contraction, 1>, &entry_in<&Law::contraction, 1>, none),
    coefficient("contraction_c", "contraction c_c: dependence on pressure (K_sigma)",
                {.low = 0.0, .high = 10.0}, &entry<&Input::contraction, 2>, &entry_in<&Law::contraction, 2>,
                none),
    coefficient("contraction_d", "contraction c_d: dependence on the cyclic stress ratio", from_zero,
                &entry<&Input::contraction, 3>, &entry_in<&Law::contraction, 3>, strength),
    coefficient("contraction_e", "contraction c_e: dependence on static shear (K_alpha)",
                {.low = -100.0, .high = 100.0}, &entry<&Input::contraction, 4>,
                &entry_in<&Law::contraction, 4>, none),
    coefficient("dilation_a", "rate of dilation d_a", from_zero, &entry<&Input::dilation, 0>,
                &entry_in<&Law::dilation, 0>, none),
    coefficient("dilation_b", "dilation d_b: exponent of the strain of the present dilative phase",
                {.low = 0.0, .high = 100.0}, &entry<&Input::dilation, 1>, &entry_in<&Law::dilation, 1>, none),
    coefficient("dilation_c", "dilation d_c: dependence on pressure", {.low = -10.0, .high = 10.0},
                &entry<&Input::dilation, 2>, &entry_in<&Law::dilation, 2>, none),
    {{.name = "peak_shear_strain",
      .unit = "1",
      .meaning = "octahedral shear strain at which the strength is reached, at the reference pressure",
      .range = above_zero,
      .otherwise = "0.1"},
     &of<&Input::peak_shear_strain>,
     &in<&Law::peak_shear_strain>,
     0.1},
    {{.name = "reference_pressure",
      .unit = "Pa",
      .meaning = "mean effective pressure p_r of the moduli",
      .range = above_zero,
      .otherwise = "101e3"},
     &of<&Input::reference_pressure>,
     &in<&Law::reference_pressure>,
     101e3},
    {{.name = "pressure_exponent",
      .unit = "1",
      .meaning = "exponent d of the moduli over pressure",
      .range = {.low = 0.0, .high = 1.0},
      .otherwise = "0.5"},
     &of<&Input::pressure_exponent>,
     &in<&Law::pressure_exponent>,
     0.5},
    {{.name = "surfaces",
      .unit = "1",
      .meaning = "number of nested yield surfaces",
      .range = {.low = 3.0, .high = static_cast<double>(most_pdmy03_surfaces)},
      .otherwise = "20",
      .whole = true},
     &of<&Input::surfaces>,
     [](const Law& law) { return static_cast<double>(law.surfaces); },
     20.0},
    {{.name = "liquefaction_1",
      .unit = "1",
      .meaning = "share of dilative strain that widens the perfectly plastic zone",
      .range = from_zero,
      .otherwise = "1"},
     &of<&Input::liquefaction_1>,
     &in<&Law::liquefaction_1>,
     1.0},
    {{.name = "liquefaction_2",
      .unit = "1",
      .meaning = "share of biased strain by which the perfectly plastic zone moves",
      .range = from_zero,
      .otherwise = "0"},
     &of<&Input::liquefaction_2>,
     &in<&Law::liquefaction_2>,
     0.0},
    {{.name = "atmospheric_pressure",
      .unit = "Pa",
      .meaning = "atmospheric pressure p_A of the formulas",
      .range = {.low = 1.0, .high = 1e9},
      .otherwise = "101e3"},
     &of<&Input::atmospheric_pressure>,
     &in<&Law::atmospheric_pressure>,
     101e3},
    {{.name = "zero_pressure_strength",
      .unit = "Pa",
      .meaning = "shear strength S0 at zero mean effective pressure",
      .range = from_zero,
      .otherwise = "1.73e3",
      .remark = "At most `reference_pressure`."},
     &of<&Input::zero_pressure_strength>,
     &in<&Law::zero_pressure_strength>,
     1.73e3},
}};

} // namespace

std::span<const Pdmy03Row> pdmy03_rows() {
  return rows;
}

std::span<const InputField<Pdmy03Input>> pdmy03_parameters() {
  static const std::vector<InputField<Input>> all = [] {
    std::vector<InputField<Input>> list = {{relative_density_of_set, &of<&Input::relative_density>}};
    for (const Pdmy03Row& one : rows)
      list.push_back({one.text, one.input});
    return list;
  }();
  return all;
}

} // namespace tremolo::materials
