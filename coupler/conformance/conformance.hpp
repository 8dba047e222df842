#pragma once

// Does a program that was written by somebody else serve a free field as the hub and a domain need it? It is
// started three times: a whole exchange that ends with BYE; the same again, which must give the same bits,
// ended by ABORT; and one in which the hub vanishes. The exchange is marched by the domain's own
// FaceExchange.

#include "coupler/conformance/source_probe.hpp"
#include "coupler/wire/field.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace tremolo::coupler {

/// Requests that a domain would make of the source.
struct Demand {
  std::vector<ExchangedFace> faces; ///< where it reads the fields; face.source is the name of the source
  double start_time = 0.0;          ///< s
  double end_time = 0.0;            ///< s
  double least_density = 0.0;       ///< of the ground at the faces, kg/m3
  double largest_density = 0.0;
};

enum class Verdict { pass, warning, failure, skipped };

std::string_view name(Verdict verdict);

struct Check {
  std::string name;
  Verdict verdict = Verdict::skipped;
  std::string finding; ///< numbers, or what is wrong
};

/// Limits of the checks that look at numbers. Beyond the first of each pair a warning, beyond the second a
/// failure.
struct ConformanceLimits {
  double rate_defect_warning = 0.02; ///< rate_defect(): of the 2-norm
  double rate_defect_failure = 0.2;
  double start_warning = 1e-6; ///< of the first step's values to their peaks
  double start_failure = 1e-2;
  double density_warning = 0.1; ///< beyond the range of densities, relative
  double density_failure = 0.5;
};

/// All checks, in the order of the session; those that could not be reached are skipped.
/// @throws Error if the machinery of the test itself fails, e.g. its folder cannot be written
std::vector<Check> conform(const ProbeOptions& options, const Demand& demand,
                           const ConformanceLimits& limits = {});

/// Whether no check has failed.
bool conforms(const std::vector<Check>& checks);

} // namespace tremolo::coupler
