#pragma once

// Choices that a case makes by a word. Each enumeration is followed by its words; the key tables, readers,
// messages and reports take them from there.

#include "base/words.hpp"
#include "mpm_domain/spec/numerics.hpp"
#include "mpm_domain/spec/structure.hpp"

#include <array>
#include <cstddef>
#include <string_view>

namespace tremolo::scene {

// The domain's own choices, under their own names.
using mpm_domain::ContactNormals;
using mpm_domain::Dilatation;
using mpm_domain::Dispersion;
using mpm_domain::ParticleBoxes;
using mpm_domain::Side;
using mpm_domain::Sides;
using mpm_domain::StepOrder;
using mpm_domain::Transfer;

enum class Wave { sv, p };
constexpr auto words(Wave) {
  return word_table<Wave>({{Wave::sv, "SV"}, {Wave::p, "P"}});
}

/// Dependence of the damping ratios of layers and half-space on frequency.
enum class DampingModel { none, rayleigh, kelvin_voigt, hysteretic, shake, kjartansson, constant };
constexpr auto words(DampingModel) {
  return word_table<DampingModel>({{DampingModel::none, "none"},
                                   {DampingModel::rayleigh, "rayleigh"},
                                   {DampingModel::kelvin_voigt, "kelvin_voigt"},
                                   {DampingModel::hysteretic, "hysteretic"},
                                   {DampingModel::shake, "shake"},
                                   {DampingModel::kjartansson, "kjartansson"},
                                   {DampingModel::constant, "constant"}});
}

enum class OdeMethod { adams, bdf, erk, imex };
constexpr auto words(OdeMethod) {
  return word_table<OdeMethod>({{OdeMethod::adams, "adams"},
                                {OdeMethod::bdf, "bdf"},
                                {OdeMethod::erk, "erk"},
                                {OdeMethod::imex, "imex"}});
}

enum class SourceModel {
  wave,          ///< plane waves in layers, frequency domain
  fe,            ///< finite-element column
  ode,           ///< column by the method of lines, SUNDIALS
  eql,           ///< equivalent-linear layers
  mpm,           ///< a domain of one periodic column
  recording,     ///< a free field recorded earlier
  external,      ///< a program of the user
  shaking_table, ///< a rigid base that moves as prescribed
};
constexpr auto words(SourceModel) {
  return word_table<SourceModel>({{SourceModel::wave, "wave"},
                                  {SourceModel::fe, "fe"},
                                  {SourceModel::ode, "ode"},
                                  {SourceModel::eql, "eql"},
                                  {SourceModel::mpm, "mpm"},
                                  {SourceModel::recording, "recording"},
                                  {SourceModel::external, "external"},
                                  {SourceModel::shaking_table, "shaking_table"}});
}

enum class BaseForm {
  total, ///< free-field velocity and stress of the whole (incident and reflected) field: exact at any angle
  incident, ///< the incident wave alone: Eqs. (4) and (5) of the method, dashpots take up the reflected waves
  /// the total fields under the surfaces of both sides, blended linearly from one side to the other; only
  /// where these differ
  blended
};
constexpr auto words(BaseForm) {
  return word_table<BaseForm>(
      {{BaseForm::total, "total"}, {BaseForm::incident, "incident"}, {BaseForm::blended, "blended"}});
}

/// What absorbs waves that leave the model.
enum class Absorber {
  dashpots,     ///< of Eq. (6)
  matched_layer ///< a perfectly matched layer behind the faces
};
constexpr auto words(Absorber) {
  return word_table<Absorber>({{Absorber::dashpots, "dashpots"}, {Absorber::matched_layer, "matched_layer"}});
}

/// Behaviour of the pore water in a static stage.
enum class StageDrainage {
  drained,  ///< the grains take all of the change
  undrained ///< it moves with the grains
};
constexpr auto words(StageDrainage) {
  return word_table<StageDrainage>(
      {{StageDrainage::drained, "drained"}, {StageDrainage::undrained, "undrained"}});
}

enum class ExchangeMode { window, lockstep };
constexpr auto words(ExchangeMode) {
  return word_table<ExchangeMode>({{ExchangeMode::window, "window"}, {ExchangeMode::lockstep, "lockstep"}});
}

/// What happens to a run that can no longer be recorded.
enum class OnFullDisk { stop, go_on };
constexpr auto words(OnFullDisk) {
  return word_table<OnFullDisk>({{OnFullDisk::stop, "stop"}, {OnFullDisk::go_on, "go_on"}});
}

/// Who starts a process on another machine.
enum class StartBy {
  ssh,   ///< `tremolo run`, through ssh
  slurm, ///< `tremolo run`, as a step of its Slurm job (srun)
  join   ///< the user, with `tremolo join`
};
constexpr auto words(StartBy) {
  return word_table<StartBy>({{StartBy::ssh, "ssh"}, {StartBy::slurm, "slurm"}, {StartBy::join, "join"}});
}

enum class StartRanksBy {
  ssh,  ///< mpirun, through ssh to each machine
  slurm ///< mpirun, on the nodes of the Slurm job that it runs in
};
constexpr auto words(StartRanksBy) {
  return word_table<StartRanksBy>({{StartRanksBy::ssh, "ssh"}, {StartRanksBy::slurm, "slurm"}});
}

enum class OutputField {
  displacement,
  velocity,
  acceleration,
  stress,
  state,
  pore_pressure,
  excess_pore_pressure,
  pore_pressure_ratio,
  darcy_velocity,
};

/// The properties of a field that frames may hold.
struct OutputFieldRow {
  OutputField field;
  std::string_view name;
  std::string_view unit;
  std::size_t
      components; ///< of a particle; 0: as many as the laws have state variables, with units of their own
  bool of_water;  ///< of pore water, which the case must have
};

/// The entries are in the order of OutputField.
inline constexpr std::array output_fields{
    OutputFieldRow{OutputField::displacement, "displacement", "m", 2, false},
    OutputFieldRow{OutputField::velocity, "velocity", "m/s", 2, false},
    OutputFieldRow{OutputField::acceleration, "acceleration", "m/s2", 2, false},
    OutputFieldRow{OutputField::stress, "stress", "Pa", 4, false},
    OutputFieldRow{OutputField::state, "state", "", 0, false},
    OutputFieldRow{OutputField::pore_pressure, "pore_pressure", "Pa", 1, true},
    OutputFieldRow{OutputField::excess_pore_pressure, "excess_pore_pressure", "Pa", 1, true},
    OutputFieldRow{OutputField::pore_pressure_ratio, "pore_pressure_ratio", "1", 1, true},
    OutputFieldRow{OutputField::darcy_velocity, "darcy_velocity", "m/s", 2, true},
};
constexpr const OutputFieldRow& row(OutputField field) {
  return output_fields[static_cast<std::size_t>(field)];
}
constexpr auto words(OutputField) {
  std::array<Word<OutputField>, output_fields.size()> words{};
  for (std::size_t k = 0; k < words.size(); ++k)
    words[k] = {output_fields[k].field, output_fields[k].name};
  return words;
}

/// A soil's `model`; `hyperbolic`, `mkz` and `gqh` are three ways to give one law.
enum class SoilModel {
  linear_elastic,
  mohr_coulomb,
  drucker_prager,
  multi_yield_clay,
  hyperbolic,
  mkz,
  gqh,
  pm4sand,
  pdmy03
};
constexpr auto words(SoilModel) {
  return word_table<SoilModel>({{SoilModel::linear_elastic, "linear_elastic"},
                                {SoilModel::mohr_coulomb, "mohr_coulomb"},
                                {SoilModel::drucker_prager, "drucker_prager"},
                                {SoilModel::multi_yield_clay, "multi_yield_clay"},
                                {SoilModel::hyperbolic, "hyperbolic"},
                                {SoilModel::mkz, "mkz"},
                                {SoilModel::gqh, "gqh"},
                                {SoilModel::pm4sand, "pm4sand"},
                                {SoilModel::pdmy03, "pdmy03"}});
}

/// Behaviour of hysteretic soil after a reversal.
enum class Unloading { masing, mrdf };
constexpr auto words(Unloading) {
  return word_table<Unloading>({{Unloading::masing, "masing"}, {Unloading::mrdf, "mrdf"}});
}

/// Sites for which Toro (1995) gives the statistics of Vs.
enum class ToroClass {
  geomatrix_ab, ///< rock and shallow soil
  geomatrix_cd, ///< deep soil
  usgs_ab,      ///< Vs30 above 360 m/s
  usgs_cd,      ///< below 360 m/s
  usgs_a,       ///< above 750 m/s
  usgs_b,       ///< 360 to 750 m/s
  usgs_c,       ///< 180 to 360 m/s
  usgs_d        ///< below 180 m/s
};
constexpr auto words(ToroClass) {
  return word_table<ToroClass>({{ToroClass::geomatrix_ab, "geomatrix_ab"},
                                {ToroClass::geomatrix_cd, "geomatrix_cd"},
                                {ToroClass::usgs_ab, "usgs_ab"},
                                {ToroClass::usgs_cd, "usgs_cd"},
                                {ToroClass::usgs_a, "usgs_a"},
                                {ToroClass::usgs_b, "usgs_b"},
                                {ToroClass::usgs_c, "usgs_c"},
                                {ToroClass::usgs_d, "usgs_d"}});
}

/// Kind of loading in a soil test.
enum class LoadingKind { monotonic, cyclic_stress, cyclic_strain, modulus_curve, path };
constexpr auto words(LoadingKind) {
  return word_table<LoadingKind>({{LoadingKind::monotonic, "monotonic"},
                                  {LoadingKind::cyclic_stress, "cyclic_stress"},
                                  {LoadingKind::cyclic_strain, "cyclic_strain"},
                                  {LoadingKind::modulus_curve, "modulus_curve"},
                                  {LoadingKind::path, "path"}});
}

/// The word of a choice, e.g. "kelvin_voigt".
using tremolo::name;

} // namespace tremolo::scene
