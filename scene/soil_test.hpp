#pragma once

// A checked soil test or calibration: what its file says, in SI units. The keys, their ranges and defaults
// stand in keys_soil_test.cpp; docs/soil-test-file.md is generated from there.

#include "materials/soiltest/cyclic/cyclic_strength.hpp"
#include "materials/soiltest/soil_test.hpp"
#include "scene/case.hpp"
#include "scene/soils/curve_strength.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::scene {

/// [target] of a calibration.
struct StrengthWanted {
  double stress_ratio = 0.0;
  std::optional<CurveStrength> curve; ///< where the stress ratio is that of Idriss & Boulanger
  double cycles = 15.0;
  soiltest::Criterion criterion = soiltest::Criterion::strain_3pc;
  double guess = 0.0; ///< of contraction_rate; what [soil] says
  double least = 0.0;
  double most = 0.0;
  std::string place; ///< of [target]: "test.toml:12:1"
};

struct SoilTestFile {
  std::string title;
  std::filesystem::path file; ///< as given to load_soil_test()
  std::string text;           ///< the source
  std::string library;        ///< name of the library's soil, or empty
  Soil soil;
  LoadingKind kind = LoadingKind::monotonic;
  soiltest::SoilTest test;           ///< with the first stress ratio of cyclic_stress
  std::vector<double> stress_ratios; ///< of cyclic_stress
  std::filesystem::path path_table;  ///< of a path
  std::vector<double> amplitudes;    ///< of modulus_curve
  int cycles = 0;                    ///< at each of them
  std::optional<StrengthWanted> target;
  std::vector<ValueInForce> values;
};

enum class SoilTestUse { test, calibration };

/// Reads and checks a file; a test needs [loading], a calibration [target].
/// @throws CaseErrors (scene/text/errors.hpp) with every error of the file
SoilTestFile load_soil_test(const std::filesystem::path& file, SoilTestUse use);

/// Reads a soil test from text. `file` names it in messages; relative file names start from `directory`.
SoilTestFile parse_soil_test(std::string_view text, const std::filesystem::path& file,
                             const std::filesystem::path& directory, SoilTestUse use);

} // namespace tremolo::scene
