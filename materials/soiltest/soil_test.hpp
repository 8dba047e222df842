#pragma once

// Element tests as a laboratory knows them, on any law. A test is described by plain structs and runs on a
// single point (materials/law/driver.hpp), driven by equal strain increments:
//
//     test                     driven by   holds constant   strain             tau
//     direct simple shear      gamma_xy    sigma_yy         gamma_xy           sigma_xy
//     triaxial, plane strain   eps_yy      sigma_xx (_zz)   eps_a = -eps_yy    (sigma_xx - sigma_yy)/2
//     oedometer                eps_yy      -                eps_a              (sigma_xx - sigma_yy)/2
//     isotropic compression    eps, all    -                eps_a              (sigma_xx - sigma_yy)/2
//
// `strain` is what drives the test and what its limits and amplitudes mean. The shear strain that belongs to
// tau is gamma = gamma_xy in simple shear and eps_xx - eps_yy, that is eps_1 - eps_3, in all others, so that
// G = tau/gamma is a shear modulus in every test.
//
// y is vertical. Direct simple shear and oedometer have eps_xx = 0; triaxial tests sigma_zz = sigma_xx; all
// others eps_zz = 0, except that isotropic compression of a three-dimensional law compresses all three
// directions.
//
//     drained          what the apparatus holds constant is an effective stress, u = 0
//     undrained        it is a total stress, sigma' - u; pore water of stiffness K_w/n: u = -K_w/n tr(eps)
//     constant volume  tr(eps) = 0; u is by how much the effective stress that a drained test would hold
//     constant has
//                      fallen
//
// Stresses are tension positive, u is compression positive and r_u = u over the initial effective stress that
// the apparatus holds constant (vertical in an oedometer and isotropic compression).

#include "base/words.hpp"
#include "materials/law/driver.hpp"
#include "materials/soiltest/path/history.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tremolo::soiltest {

enum class Kind {
  direct_simple_shear,
  triaxial_compression, ///< axisymmetric; only laws with the trait three_dimensional
  triaxial_extension,
  plane_strain_compression,
  plane_strain_extension,
  oedometer,
  isotropic_compression,
  path ///< prescribed strains and stresses; loading is a Path
};
constexpr auto words(Kind) {
  return word_table<Kind>({{Kind::direct_simple_shear, "direct_simple_shear"},
                           {Kind::triaxial_compression, "triaxial_compression"},
                           {Kind::triaxial_extension, "triaxial_extension"},
                           {Kind::plane_strain_compression, "plane_strain_compression"},
                           {Kind::plane_strain_extension, "plane_strain_extension"},
                           {Kind::oedometer, "oedometer"},
                           {Kind::isotropic_compression, "isotropic_compression"},
                           {Kind::path, "path"}});
}

enum class Drainage { drained, undrained, constant_volume };
constexpr auto words(Drainage) {
  return word_table<Drainage>({{Drainage::drained, "drained"},
                               {Drainage::undrained, "undrained"},
                               {Drainage::constant_volume, "constant_volume"}});
}

/// State before loading; strains are counted from here.
struct InitialState {
  double vertical_stress = 0.0; ///< effective, Pa, compression positive
  double k0 = 1.0;              ///< horizontal over vertical effective stress
  double shear_bias = 0.0;      ///< alpha = tau_0 / vertical_stress; only direct simple shear and paths
  /// Whether the law starts from a stress that contains tau_0, as the reference curves do; else tau_0 is
  /// applied by drained simple shear from tau = 0 before the test, and strains are counted from its end.
  bool bias_in_initial_stress = false;
};

/// Loading to a strain, positive in the sense of the test: gamma_xy, or eps_a (compression or extension).
struct Monotonic {
  double strain = 0.1;
};

/// Cycles by stress ratio: reversals exactly at tau = tau_0 +- stress_ratio * vertical_stress, compression or
/// positive shear first (extension first in an extension test). Ends at the first of the limits.
struct StressCycles {
  double stress_ratio = 0.0;    ///< CSR
  double largest_strain = 0.06; ///< gamma_xy or eps_a, absolute
  double most_cycles = 100.0;
  std::optional<double> pore_pressure_ratio = std::nullopt; ///< largest r_u, if that shall end the test
};

/// Cycles between +-amplitude for each amplitude in turn: from zero strain to the first reversal, `cycles`
/// closed loops from there, and back to zero strain.
struct StrainCycles {
  std::vector<double> amplitudes; ///< gamma_xy or eps_a
  int cycles = 2;                 ///< of each amplitude
};

/// A row of a prescribed path.
struct PathRow {
  double step = 0.0;             ///< increments since the start; the path is straight between rows
  materials::PointStrain strain; ///< since the start
  materials::PointStress stress; ///< Pa, total if undrained; in the first row what the table has
  int line = 0;                  ///< of its table, from 1; 0 without one
};

/// Prescribed strains, or stresses of the components that are controlled by them.
struct Path {
  std::array<bool, 4> by_stress = {}; ///< xx, yy, xy, zz
  std::vector<PathRow> rows;          ///< the first is the start
};

using Loading = std::variant<Monotonic, StressCycles, StrainCycles, Path>;

/// One test. Progress of a test.
struct TestProgress {
  std::size_t increments = 0;
  double most_increments = 0.0; ///< as many as there can be
  double cycles = 0.0;
  double strain = 0.0;
};

struct SoilTest {
  Kind kind = Kind::direct_simple_shear;
  Drainage drainage = Drainage::constant_volume;
  double pore_stiffness = 0.0; ///< K_w/n, Pa; of undrained tests
  InitialState initial;
  Loading loading;
  double strain_increment = 1e-5;                 ///< of the driven component; paths bring their own
  std::size_t every = 1;                          ///< increments from one row of the history to the next
  std::function<void(const TestProgress&)> watch; ///< called after each increment, if there is one
};

/// Cycles at which something was reached for the first time; NaN if it was not, and in tests without cycles.
struct CyclesTo {
  static constexpr double never = std::numeric_limits<double>::quiet_NaN();
  double strain_1pc = never; ///< single amplitude, largest |strain|
  double strain_3pc = never;
  double strain_5pc = never;
  double double_amplitude_5pc = never; ///< largest minus smallest strain so far
  double ru_98 = never;                ///< r_u = 0.98
};

/// A closed loop of strain-controlled cycles.
struct Loop {
  double amplitude = 0.0;           ///< gamma_xy or eps_a
  int cycle = 0;                    ///< 1 for the first of its amplitude
  double shear_strain = 0.0;        ///< gamma = (gamma_max - gamma_min)/2; the amplitude in simple shear
  double modulus = 0.0;             ///< G = (tau_max - tau_min)/(2 gamma), Pa
  double damping = 0.0;             ///< loop area, int tau d gamma, / (2 pi G gamma^2)
  double pore_pressure_ratio = 0.0; ///< at its end
};

/// Why a test ended.
enum class End { completed, largest_strain, most_cycles, pore_pressure_ratio, refused };

/// Largest allowed deviation of a stress that the apparatus holds, relative to the largest stress; beyond it
/// the test ends.
inline constexpr double largest_missing_fraction = 0.05;

/// Result of a test, however the test ended.
struct Result {
  History history; ///< columns of history.hpp
  CyclesTo cycles_to;
  std::vector<Loop> loops;        ///< of StrainCycles
  double cycles = 0.0;            ///< at the end
  double peak_shear_stress = 0.0; ///< largest |tau|, Pa
  /// Largest asin((s_1 - s_3)/(s_1 + s_3)) of the principal effective stresses in the plane, rad; pi/2 where
  /// one of them is not a compression.
  double mobilised_angle = 0.0;
  double largest_strain = 0.0; ///< largest |strain|
  double largest_pore_pressure_ratio = 0.0;
  End end = End::completed;
  std::string end_reason; ///< one clause, e.g. "the strain reached 0.06"
  /// Largest deviation of a stress that the apparatus holds, Pa. Zero unless the law left no strain that
  /// gives it; the nearest was taken then, up to largest_missing_fraction of the largest stress. Beyond that,
  /// and in a path, the test is refused instead.
  double largest_missing_stress = 0.0;
  materials::Leaps
      leaps; ///< to strains that the law holds a stress at, but that are not next to the last ones
  std::size_t increments = 0;
  std::size_t updates = 0; ///< of the law
  double cpu_seconds = 0.0;
};

/// Runs a test. A law that refuses to go on, or a load that it cannot carry, ends the test with End::refused
/// and the reason; the history up to there is returned.
/// @throws std::invalid_argument for a test that makes no sense, naming what and why
Result run(const materials::Law& law, const SoilTest& test);

/// Refuses tests that make no sense, or that the law cannot do.
/// @throws std::invalid_argument naming what and why
void validate(const materials::Law& law, const SoilTest& test);

/// The word a test file uses, e.g. "direct_simple_shear", "constant_volume".
using tremolo::name;

} // namespace tremolo::soiltest
