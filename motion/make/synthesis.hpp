#pragma once

// A synthetic accelerogram with the measures of a target: modulated, filtered noise.
//
//     a(t) = s (w (h * n) - w (p + q t))
//
// n  white noise of a seeded generator
// h  amplitude of the filter of Clough & Penzien (1975), Dynamics of Structures: a soil column (frequency,
//    damping) after a high-pass (high_pass, high_pass_damping), under a cosine taper from taper_start to
//    last_frequency, above which there is nothing
// w  the gamma envelope of Saragoni & Hart (1974), Earthq. Eng. Struct. Dyn. 2, and one strong burst:
//    w^2 = x^(shape-1) exp(-x) + burst exp(-((t - burst_time)/burst_width)^2),  x = (t - start)/time
// p, q bring final velocity and displacement to zero
// s  the scale that gives the Arias intensity
//
// The filter's two frequencies, the envelope's time and the burst's strength are found by Levenberg-Marquardt
// steps on mean period, PGV, duration and PGA; those of the recipe are where the search starts.

#include "motion/measures.hpp"
#include "motion/record.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace tremolo::motion {

struct SynthesisTarget {
  double pga = 0.0;                  ///< m/s2
  double pgv = 0.0;                  ///< m/s
  double arias = 0.0;                ///< m/s
  double significant_duration = 0.0; ///< s
  double mean_period = 0.0;          ///< s
  double tolerance = 0.005;          ///< relative, of every measure
};

struct SynthesisFilter {
  double frequency = 0.0;         ///< Hz
  double damping = 0.7;           ///< of critical
  double high_pass = 0.0;         ///< Hz
  double high_pass_damping = 0.6; ///< of critical
  double taper_start = 0.0;       ///< Hz
  double last_frequency = 0.0;    ///< Hz
};

struct SynthesisEnvelope {
  double start = 0.0;       ///< s
  double shape = 1.8;       ///< of the gamma distribution of the energy, > 1
  double time = 0.0;        ///< its scale, s
  double burst_time = 0.0;  ///< s
  double burst_width = 0.4; ///< s
  double burst = 0.0;       ///< strength of the burst, in the unit of the gamma envelope's energy
};

struct SynthesisRecipe {
  std::uint32_t seed = 0; ///< the first that is tried
  int seeds = 100;        ///< that are tried
  double dt = 0.0;        ///< s
  std::size_t count = 0;
  SynthesisTarget target;
  SynthesisFilter filter;
  SynthesisEnvelope envelope;
};

struct Synthesised {
  Record record;          ///< acceleration in g, rounded to 1e-10
  SynthesisRecipe recipe; ///< with the seed, filter and envelope that were found
  Measures measures;
  int steps = 0; ///< of the search, 0 where the recipe itself meets the target
};

/// @throws std::invalid_argument for a recipe out of range, std::runtime_error naming the measure that cannot
///         be met
Synthesised synthesise(const SynthesisRecipe& recipe);

/// `count` standard normal numbers: Marsaglia's polar method on the Mersenne Twister MT19937, the stream of
/// numpy.random.RandomState(seed).standard_normal.
std::vector<double> white_noise(std::uint32_t seed, std::size_t count);

} // namespace tremolo::motion
