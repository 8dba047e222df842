// Soils with a backbone: hyperbolic, mkz, gqh.

#include "materials/hysteretic/backbone/curve_fit.hpp"
#include "materials/hysteretic/backbone/loop_fit.hpp"
#include "materials/hysteretic/backbone/strength_fit.hpp"
#include "scene/choices.hpp"
#include "scene/read/read.hpp"
#include "scene/read/soil/read_soil.hpp"

#include <fmt/format.h>

#include <exception>
#include <initializer_list>
#include <optional>

namespace tremolo::scene {

namespace {

using materials::Backbone;
using materials::SoilCurves;

StrainCurves curves_of(const Backbone& backbone) {
  return {[backbone](double strain) { return backbone.secant(strain) / backbone.shear_modulus; },
          [backbone](double strain) { return materials::loop_damping(backbone, strain); }, false};
}

StrainCurves curves_of(const SoilCurves& curves) {
  return {[curves](double strain) { return curves.modulus_ratio_at(strain); },
          [curves](double strain) { return curves.damping_ratio_at(strain); }, true};
}

/// Whether all of the keys are there that the backbone needs without a curve.
bool has(const TableReader& table, std::initializer_list<const char*> keys, Findings& findings) {
  bool all = true;
  for (const char* key : keys) {
    if (!table.given(key))
      findings.add(table.path(key), fmt::format("missing '{}': without 'curve' the backbone is given", key));
    all = all && findings.sound(table.path(key));
  }
  return all;
}

/// Whether none of the keys is there that a curve stands for.
bool has_none(const TableReader& table, std::initializer_list<const char*> keys, Findings& findings) {
  for (const char* key : keys)
    if (table.given(key)) {
      findings.add(table.path(key), fmt::format("'{}' and 'curve' exclude each other: remove one", key));
      return false;
    }
  return true;
}

std::optional<Backbone> read_mkz(const TableReader& table, const SoilCurves* curve, double shear_modulus,
                                 Findings& findings) {
  if (curve != nullptr) {
    if (!has_none(table, {"beta", "exponent"}, findings))
      return std::nullopt;
    const auto fit = materials::fit_mkz(*curve, table.optional_number("reference_strain"));
    return Backbone{shear_modulus, fit.reference_strain, fit.beta, fit.exponent};
  }
  if (table.choice<SoilModel>("model") == SoilModel::hyperbolic) {
    if (!has(table, {"reference_strain"}, findings))
      return std::nullopt;
    return Backbone{shear_modulus, table.number("reference_strain")};
  }
  if (!has(table, {"reference_strain", "beta", "exponent"}, findings))
    return std::nullopt;
  return Backbone{shear_modulus, table.number("reference_strain"), table.number("beta"),
                  table.number("exponent")};
}

std::optional<Backbone> read_gqh(const TableReader& table, const SoilCurves* curve, double shear_modulus,
                                 Findings& findings) {
  need(table, "shear_strength", findings);
  if (!findings.sound(table.path("shear_strength")))
    return std::nullopt;
  Backbone backbone{shear_modulus, table.number("shear_strength") / shear_modulus};
  if (curve != nullptr) {
    if (!has_none(table, {"theta"}, findings))
      return std::nullopt;
    backbone.shape = materials::fit_quadratic_shape(*curve, backbone.reference_strain);
    return backbone;
  }
  if (!has(table, {"theta"}, findings))
    return std::nullopt;
  const auto theta = table.numbers("theta");
  backbone.shape = materials::QuadraticShape{theta[0], theta[1], theta[2], theta[3], theta[4]};
  return backbone;
}

/// Sets what unloading keeps of the damping. False, and reported, where neither numbers nor a curve say.
bool read_unloading(const TableReader& table, const SoilCurves* curve, Backbone& backbone,
                    Findings& findings) {
  if (table.choice<Unloading>("unloading") == Unloading::masing)
    return true;
  if (table.given("mrdf")) {
    const auto p = table.numbers("mrdf");
    backbone.loops = {p[0], p[1], p[2]};
    return true;
  }
  if (curve == nullptr) {
    findings.add(table.path("mrdf"), "missing 'mrdf': without 'curve' there is no damping to fit it to");
    return false;
  }
  backbone.loops = materials::fit_loop_reduction(*curve, backbone);
  return true;
}

std::optional<Backbone> read_backbone(const TableReader& table, const SoilCurves* curve, double shear_modulus,
                                      Findings& findings) {
  auto backbone = table.choice<SoilModel>("model") == SoilModel::gqh
                      ? read_gqh(table, curve, shear_modulus, findings)
                      : read_mkz(table, curve, shear_modulus, findings);
  if (!backbone || !read_unloading(table, curve, *backbone, findings))
    return std::nullopt;
  validate(*backbone);
  return backbone;
}

} // namespace

Soil read_hysteretic(const NamedTable& soil, const std::filesystem::path& directory, Findings& findings) {
  const auto& table = soil.reader;
  const bool sound = sound_numbers(table, table.choice<SoilModel>("model"), findings);
  const auto elastic = read_elasticity(table, findings);
  Soil linear{soil.name, materials::LinearElastic{elastic}, materials::LinearElastic{elastic}, {}, {}};
  if (!sound || !findings.sound(table.path()) || !(elastic.density > 0.0))
    return linear;
  const char* source = table.given("curve") ? "curve" : "model";
  try {
    std::optional<SoilCurves> curve;
    if (table.given("curve"))
      curve = read_curve(table, directory);
    const auto backbone = read_backbone(table, curve ? &*curve : nullptr, elastic.shear_modulus(), findings);
    if (!backbone)
      return linear;
    const materials::MasingShear law{elastic,         backbone->reference_strain,
                                     backbone->beta,  backbone->exponent,
                                     backbone->shape, backbone->loops};
    materials::IwanShear in_domain = materials::iwan_shear(elastic, *backbone);
    in_domain.strength = table.optional_number("shear_strength");
    Soil read{soil.name, in_domain, law, {}, curve ? curves_of(*curve) : curves_of(*backbone)};
    read.given_strength = in_domain.strength;
    return read;
  } catch (const std::exception& error) {
    findings.add(table.path(source), error.what());
    return linear;
  }
}

} // namespace tremolo::scene
