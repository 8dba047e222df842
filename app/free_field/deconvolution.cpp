// The formula stands in wavefield/layers/recorded_motion.cpp. Records are taken as accelerations, whose
// strains the equivalent-linear iteration needs.

#include "app/free_field/deconvolution.hpp"

#include "base/samples.hpp"
#include "scene/plan/layers.hpp"
#include "wavefield/incident_motion.hpp"
#include "wavefield/process/field_from_case.hpp"
#include "wavefield/process/ground_from_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace tremolo::app {
namespace {

using motion::MotionKind;

/// Soil amplifies more often than not: a base that shakes so much more than the ground above it is worth a
/// note.
constexpr double remarkable_peak = 1.5;

motion::Record acceleration(std::vector<double> samples, double dt, std::optional<MotionKind> kind) {
  return {.unit = motion::Unit::m_s2, .kind = kind, .dt = dt, .samples = std::move(samples)};
}

/// The ground that carries the wave, and what finding it left to say.
wavefield::LayeredHalfSpace ground_under(const scene::Case& scene, const scene::SourceProcess& source,
                                         const wavefield::RecordedMotion& record, DeconvolvedMotion& result) {
  if (source.field.model == scene::SourceModel::wave)
    return wavefield::ground_from_case(scene, scene::layers(scene, source));
  auto iterated = wavefield::equivalent_linear_from_case(scene, source, record);
  result.iteration = wavefield::summary(iterated);
  if (!iterated.converged)
    result.warnings.push_back("the equivalent-linear iteration has NOT converged: the motion is one of the "
                              "states between which it swings");
  const auto& strains = iterated.iterations.back().largest_strain;
  const auto beyond = wavefield::layers_beyond_their_curves(scene, source, strains);
  if (!beyond.empty())
    result.warnings.push_back(fmt::format(
        "the effective strain passes the end of the soil's curves in {} of {} layers, first in {}, "
        "where it is {:.3g}: the last values of the curves were taken",
        beyond.size(), strains.size(), wavefield::depth_range(iterated.profile, beyond.front()),
        scene.eql.strain_ratio * strains[beyond.front()]));
  return iterated.profile;
}

} // namespace

DeconvolvedMotion deconvolved(const scene::Case& scene, const scene::SourceProcess& source,
                              const GroundRecord& given) {
  if (scene::layers(scene, source).empty())
    throw std::invalid_argument(fmt::format(
        "{}: to deconvolve needs layers, and this ground is the [halfspace] alone: [[profile]] gives some",
        scene.file.string()));
  const auto incidence = wavefield::incidence_of(scene.motion);
  if (wavefield::is_post_critical(wavefield::ground_from_case(scene, {}).half_space, incidence))
    throw std::invalid_argument(fmt::format("{}: [motion] angle_deg = {}: beyond the critical angle of the "
                                            "half-space outcrop and incident motion "
                                            "differ in phase, and nothing is deconvolved there",
                                            scene.file.string(), scene.motion.angle_deg));
  const motion::Record whole = motion::with_unit(given.record, motion::Unit::m_s2);
  const wavefield::RecordedMotion record{
      .samples = whole.samples, .dt = whole.dt, .depth = given.depth, .cutoff = given.cutoff};
  DeconvolvedMotion result;
  const auto ground = ground_under(scene, source, record, result);
  const double factor = wavefield::outcrop_factor(ground, incidence.wave, incidence.angle_rad);
  auto deconvolution = wavefield::incident_from_record(ground, incidence.wave, incidence.angle_rad, record);
  const auto strains = wavefield::largest_strains(ground, incidence.wave, incidence.angle_rad, record);
  const auto largest = std::ranges::max_element(strains);
  result.largest_strain = *largest;
  result.where = wavefield::depth_range(ground, static_cast<std::size_t>(largest - strains.begin()));
  result.recorded = acceleration(wavefield::band_limited(record), record.dt, given.record.kind);
  result.lead = static_cast<double>(deconvolution.lead) * record.dt;
  result.amplification = factor * deconvolution.largest_amplification;
  result.amplified_hz = deconvolution.at_hz;
  result.incident = acceleration(std::move(deconvolution.incident), record.dt, MotionKind::incident);
  result.outcrop = acceleration(result.incident.samples, record.dt, MotionKind::outcrop);
  for (double& sample : result.outcrop.samples)
    sample *= factor;
  const double above = peak(result.recorded.samples);
  const double below = peak(result.outcrop.samples);
  if (below > remarkable_peak * above)
    result.warnings.push_back(fmt::format(
        "the outcrop's PGA is {:.3g} times the record's: too much for most ground; look at damping "
        "and cutoff",
        below / above));
  return result;
}

std::string deconvolution_report(const DeconvolvedMotion& motion, const GroundRecord& given) {
  const auto line = [](const char* what, const std::string& value) {
    return fmt::format("  {:<16}{}\n", what, value);
  };
  const double whole = peak(motion::with_unit(given.record, motion::Unit::m_s2).samples);
  std::string text =
      line("record", fmt::format("PGA {:.4g} m/s2, {:.4g} m/s2 below the cutoff, {:g} m below the surface",
                                 whole, peak(motion.recorded.samples), given.depth)) +
      line("outcrop", fmt::format("PGA {:.4g} m/s2", peak(motion.outcrop.samples))) +
      line("incident", fmt::format("PGA {:.4g} m/s2", peak(motion.incident.samples))) +
      line("cutoff", fmt::format("{:g} Hz: whole up to it, nothing above {:g} Hz", given.cutoff,
                                 wavefield::band_end * given.cutoff)) +
      line("amplification", fmt::format("outcrop over record at most {:.3g}, at {:.3g} Hz",
                                        motion.amplification, motion.amplified_hz)) +
      line("begins", fmt::format("{:g} s before the record", motion.lead));
  if (motion.largest_strain > 0.0) // a vertical P wave shears nothing
    text += line("largest strain", fmt::format("{:.3g} in {}", motion.largest_strain, motion.where));
  if (!motion.iteration.empty())
    text += line("eql", motion.iteration);
  return text;
}

} // namespace tremolo::app
