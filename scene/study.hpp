#pragma once

#include "base/words.hpp"
#include "scene/choices.hpp"
#include "scene/text/findings.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::scene {

/// The combinations of a study's values that are run.
enum class SweepDesign {
  product,        ///< every combination
  list,           ///< the first values of all axes, the second ones, ...
  latin_hypercube ///< samples that cover every axis evenly
};
constexpr auto words(SweepDesign) {
  return word_table<SweepDesign>({{SweepDesign::product, "product"},
                                  {SweepDesign::list, "list"},
                                  {SweepDesign::latin_hypercube, "latin_hypercube"}});
}

/// The measure of the incident motion that responses are drawn over.
enum class Intensity { pga, pgv, arias };
constexpr auto words(Intensity) {
  return word_table<Intensity>(
      {{Intensity::pga, "pga"}, {Intensity::pgv, "pgv"}, {Intensity::arias, "arias"}});
}

enum class RangeScale { linear, log };
constexpr auto words(RangeScale) {
  return word_table<RangeScale>({{RangeScale::linear, "linear"}, {RangeScale::log, "log"}});
}

/// A value of a key of the case.
struct AxisValue {
  std::string toml;  ///< as a case file writes it; names of files are absolute; empty: without the key
  std::string shown; ///< as the user writes it
  Place place{};     ///< in the study
};

/// A range of a number, in a Latin hypercube.
struct AxisRange {
  double low = 0.0;
  double high = 0.0;
  RangeScale scale = RangeScale::linear;
};

/// A key of the case, and the values that it takes.
struct Axis {
  std::string key;                 ///< "motion.angle_deg", "region[0].soil"
  std::string unit{};              ///< "" where the key has none or is not known
  Place place{};                   ///< of the key in the study
  std::vector<AxisValue> values{}; ///< empty with a range
  std::optional<AxisRange> range{};
};

/// The key whose values are records.
inline constexpr std::string_view record_key = "motion.file";
/// The key whose values are profiles of one site.
inline constexpr std::string_view realisation_key = "random_profile.realisation";
/// The name that models have as the key of an axis of site responses.
inline constexpr std::string_view model_key = "model";

/// Motions that are made for a study.
struct StudyMotions {
  std::filesystem::path recipe;
  int count = 0;
  Place place; ///< of the recipe's name in the study
};

/// Ratio of the response spectra at two monitors.
struct SpectralRatio {
  std::string of;
  std::string over;
  std::vector<double> periods; ///< s
  Place of_place;              ///< of the names in the study
  Place over_place;
};

/// The runs of `tremolo sweep`.
struct Study {
  std::filesystem::path file; ///< as given to load_study()
  std::string title;          ///< empty: that of the case
  std::filesystem::path case_file;
  std::vector<SourceModel> models; ///< of site responses, a run each; empty: runs are those of the domain
  std::vector<Axis> axes;
  SweepDesign design = SweepDesign::product;
  int samples = 0;        ///< of a Latin hypercube
  std::uint32_t seed = 1; ///< of a Latin hypercube
  std::optional<StudyMotions> motions;
  double failure_strain = 0.0;
  Intensity intensity = Intensity::pgv;
  std::string colour;            ///< key of an axis; empty: there is none to compare
  std::vector<std::string> draw; ///< measures of the pictures; empty: chosen by what varies
  std::optional<SpectralRatio> spectral_ratio;
};

/// @throws CaseErrors with every error of the study itself; whether the case takes its values is not looked
/// at
Study load_study(const std::filesystem::path& file);

} // namespace tremolo::scene
