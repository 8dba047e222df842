#pragma once

// A motion recorded in the ground of a case taken down to its half-space: what `tremolo deconvolve` computes
// and says.

#include "motion/record.hpp"
#include "scene/case.hpp"
#include "scene/plan/plan.hpp"

#include <string>
#include <vector>

namespace tremolo::app {

/// A motion recorded in the ground, and how far its frequencies are trusted.
struct GroundRecord {
  motion::Record record; ///< of any quantity
  double depth = 0.0;    ///< m below the surface
  double cutoff = 0.0;   ///< Hz
};

/// Motions of the half-space under the ground, and what making them took.
struct DeconvolvedMotion {
  motion::Record recorded;    ///< acceleration, m/s2, without what lies above the cutoff
  motion::Record incident;    ///< acceleration, m/s2
  motion::Record outcrop;     ///< acceleration, m/s2
  double lead = 0.0;          ///< by which they begin before the record, s
  double amplification = 0.0; ///< largest outcrop over recorded motion at any frequency
  double amplified_hz = 0.0;  ///< where it is
  double largest_strain = 0.0;
  std::string where;     ///< "the soil from 2 m to 3 m below the surface"
  std::string iteration; ///< of model eql, in words
  std::vector<std::string> warnings;
};

/// Deconvolves with the layers of the source, whose model must be wave or eql.
/// @throws as equivalent_linear_from_case() and incident_from_record()
DeconvolvedMotion deconvolved(const scene::Case& scene, const scene::SourceProcess& source,
                              const GroundRecord& given);

/// PGA of record, outcrop and incident wave, cutoff, amplification, largest strain: a line each.
std::string deconvolution_report(const DeconvolvedMotion& motion, const GroundRecord& given);

} // namespace tremolo::app
