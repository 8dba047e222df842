#include "materials/soiltest/soil_test.hpp"

#include "materials/law/parameter_check.hpp"
#include "materials/soiltest/path/path_start.hpp"
#include "materials/soiltest/path/path_table.hpp"
#include "materials/soiltest/size.hpp"
#include "materials/soiltest/specimen.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace tremolo::soiltest {
namespace {

using materials::check_positive;
using materials::check_range;

bool has_shear(Kind kind) {
  return kind != Kind::oedometer && kind != Kind::isotropic_compression && kind != Kind::path;
}

[[noreturn]] void refuse(const std::string& why) {
  throw std::invalid_argument(why);
}

void check_loading(Kind /*kind*/, const Monotonic& loading) {
  check_range("strain", loading.strain, 1e-9, 10.0);
}

void check_loading(Kind kind, const StressCycles& loading) {
  if (!has_shear(kind))
    refuse(fmt::format("{} has no cycles by stress ratio: it does not shear", name(kind)));
  check_range("stress_ratio", loading.stress_ratio, 1e-6, 100.0);
  check_range("largest_strain", loading.largest_strain, 1e-9, 10.0);
  check_range("most_cycles", loading.most_cycles, 0.0, 1e6);
  if (loading.pore_pressure_ratio)
    check_range("pore_pressure_ratio", *loading.pore_pressure_ratio, 1e-3, 2.0);
}

void check_loading(Kind kind, const StrainCycles& loading) {
  if (!has_shear(kind))
    refuse(fmt::format("{} has no strain cycles: it does not shear", name(kind)));
  if (loading.amplitudes.empty())
    refuse("strain cycles need at least one amplitude");
  for (const double amplitude : loading.amplitudes)
    check_range("amplitude", amplitude, 1e-9, 10.0);
  check_range("cycles", loading.cycles, 1, 1e6);
}

void check_row(const PathRow& row, std::size_t index) {
  for (const double value : {row.strain.xx, row.strain.yy, row.strain.xy, row.strain.zz, row.stress.xx,
                             row.stress.yy, row.stress.xy, row.stress.zz})
    if (!std::isfinite(value))
      refuse(fmt::format("{} holds {:g}", place(row, index), value));
}

void check_loading(Kind kind, const Path& loading) {
  if (kind != Kind::path)
    refuse(fmt::format("{} takes no prescribed path; that is the kind \"path\"", name(kind)));
  if (loading.rows.size() < 2)
    refuse(fmt::format("a path needs at least 2 rows, not {}", loading.rows.size()));
  for (std::size_t i = 0; i < loading.rows.size(); ++i) {
    check_row(loading.rows[i], i);
    const double steps = i == 0 ? 1.0 : loading.rows[i].step - loading.rows[i - 1].step;
    if (!(steps >= 1.0 && steps <= 1e9 && steps == std::round(steps))) {
      refuse(fmt::format("{} is {:g} increments after the one before; must be a whole number, at least 1",
                         place(loading.rows[i], i), steps));
    }
  }
}

void check_initial(Kind kind, const InitialState& initial) {
  check_positive("vertical_stress", initial.vertical_stress);
  check_range("k0", initial.k0, 0.0, 20.0);
  check_range("shear_bias", initial.shear_bias, -10.0, 10.0);
  if (initial.shear_bias != 0.0 && kind != Kind::direct_simple_shear && kind != Kind::path) {
    refuse(fmt::format("shear_bias = {:g} needs direct simple shear or a path; in {} the bias is k0",
                       initial.shear_bias, name(kind)));
  }
}

void check_pressure(const materials::Law& law, const InitialState& initial) {
  const materials::Traits law_traits = traits(law);
  const double share = law_traits.in_plane ? (1.0 + initial.k0) / 2.0 : (1.0 + 2.0 * initial.k0) / 3.0;
  if (share * initial.vertical_stress < law_traits.least_pressure)
    refuse(fmt::format(
        "vertical_stress = {:g} Pa with k0 = {:g} is a mean stress of {:.4g} Pa, below the {:.4g} Pa at "
        "which {} holds it: must be at least {:.4g} Pa ({:g} kPa would be {:g}e3)",
        initial.vertical_stress, initial.k0, share * initial.vertical_stress, law_traits.least_pressure,
        materials::name(law), law_traits.least_pressure / share, initial.vertical_stress,
        initial.vertical_stress));
}

void check_drainage(const SoilTest& test) {
  if (test.drainage == Drainage::undrained) {
    check_positive("pore_stiffness (K_w/n) of an undrained test", test.pore_stiffness);
  } else if (test.pore_stiffness != 0.0) {
    refuse(fmt::format("pore_stiffness = {:g} Pa has no meaning in a test that is {}", test.pore_stiffness,
                       name(test.drainage)));
  }
  if (test.drainage == Drainage::constant_volume && !has_shear(test.kind)) {
    refuse(test.kind == Kind::path
               ? std::string("a path prescribes its strains itself: its drainage is drained or undrained")
               : fmt::format("{} at constant volume has no strain at all", name(test.kind)));
  }
}

} // namespace

void validate(const materials::Law& law, const SoilTest& test) {
  materials::validate(law);
  if ((test.kind == Kind::triaxial_compression || test.kind == Kind::triaxial_extension) &&
      !traits(law).three_dimensional) {
    refuse(fmt::format(
        "{} needs a law that takes out-of-plane strain; {} is one of plane strain: use plane_strain_"
        "compression or _extension",
        name(test.kind), materials::name(law)));
  }
  if (test.kind == Kind::path && !std::holds_alternative<Path>(test.loading))
    refuse("a test of the kind \"path\" needs a path as its loading");
  check_initial(test.kind, test.initial);
  check_pressure(law, test.initial);
  check_drainage(test);
  std::visit([&](const auto& loading) { check_loading(test.kind, loading); }, test.loading);
  check_range("strain_increment", test.strain_increment, 1e-9, 0.05);
  if (test.every == 0)
    refuse("every = 0 must be at least 1");
  check_size(test);
  if (const auto* path = std::get_if<Path>(&test.loading))
    check_start(*path, test.initial, specimen(law, test).stress());
}

} // namespace tremolo::soiltest
