#pragma once

// The processing that `tremolo motion` offers, always in the order of this list: rotation, baseline, taper,
// band-pass, resampling, scaling or matching, time shift, kind.

#include "motion/mend/process.hpp"
#include "motion/mend/spectral_match.hpp"
#include "motion/read/read.hpp"

#include <optional>
#include <vector>

namespace tremolo::app {

struct MotionSteps {
  std::string other;                ///< file of the component perpendicular to the first
  std::string other_component;      ///< component or column of that file
  std::optional<double> rotate_deg; ///< from the first component towards the other
  std::optional<int> baseline;      ///< degree
  motion::BaselineFit fit = motion::BaselineFit::velocity;
  double taper = 0.0;       ///< s, at each end
  std::vector<double> band; ///< low and high corner, Hz; 0 is open
  int order = 4;
  std::optional<double> step; ///< s
  std::optional<double> scale;
  std::optional<double> pga; ///< m/s2
  std::string target;        ///< file of a response spectrum
  double target_damping = 0.05;
  double shift = 0.0; ///< s
  std::optional<motion::MotionKind> kind;
};

/// Misfit of a motion to its target spectrum.
struct Matched {
  double before = 0.0; ///< largest misfit of the scaled motion
  double after = 0.0;  ///< largest misfit
  int steps = 0;
};

struct Processed {
  motion::Record record;
  std::optional<Matched> matched;
};

/// @throws std::invalid_argument where a step does not suit the motion
Processed processed(motion::Record record, const MotionSteps& steps, const motion::ReadAs& as);

} // namespace tremolo::app
