// The half-space of every reference file halfspace_* (closed form, Faddeeva function beyond the critical
// angle) and the layers of every file layered3_* (time series) against the Fourier synthesis: 7 points, 151
// times, seven quantities.

#include "tests/support/layered_reference.hpp"
#include "tests/support/reference_table.hpp"
#include "wavefield/layers/layered_field.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>

namespace {

using namespace tremolo::wavefield;
using tremolo::testing::layered3;
using tremolo::testing::radians;

struct ReferenceCase {
  const char* file;
  LayeredHalfSpace profile;
  WaveType wave;
  double angle_deg;
  double y_reference;
  double tolerance; ///< of the peak of the quantity's kind
};

/// The name of a case in the list of tests.
void PrintTo(const ReferenceCase& reference, std::ostream* stream) {
  *stream << reference.file;
}

LayeredHalfSpace table_1_soil() {
  const double density = 1700.0;
  const double young = 40e6;
  const double poisson = 0.28;
  const double shear = young / (2.0 * (1.0 + poisson));
  const double p_modulus = young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson));
  return {.half_space = {density, std::sqrt(shear / density), std::sqrt(p_modulus / density)}};
}

class WaveReference : public ::testing::TestWithParam<ReferenceCase> {};

TEST_P(WaveReference, IsReproduced) {
  const ReferenceCase& reference = GetParam();
  const auto file = tremolo::testing::reference_folder() / "waves" / reference.file;
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << "no reference data at " << file;
  }
  const auto rows = tremolo::testing::read_table(file);
  ASSERT_EQ(rows.size(), 7U * 151U);
  const Incidence incidence{reference.wave, radians(reference.angle_deg), 0.0, reference.y_reference};
  const LayeredField field(reference.profile, incidence, 0.0, ricker(3.0, 1.0, 0.1));
  const auto error = tremolo::testing::errors(field, rows);
  EXPECT_LT(error.displacement, reference.tolerance);
  EXPECT_LT(error.velocity, reference.tolerance);
  EXPECT_LT(error.stress, reference.tolerance);
  std::printf("%s: displacement %.1e, velocity %.1e, stress %.1e of the peak\n", reference.file,
              error.displacement, error.velocity, error.stress);
}

ReferenceCase half_space(const char* file, WaveType wave, double degrees, double tolerance) {
  return {file, table_1_soil(), wave, degrees, -40.0, tolerance};
}

ReferenceCase layers(const char* file, WaveType wave, double degrees, DampingModel model) {
  return {file, layered3({.model = model}), wave, degrees, -20.0, 1e-6};
}

INSTANTIATE_TEST_SUITE_P(
    Files, WaveReference,
    ::testing::Values(
        half_space("halfspace_SV_0deg.csv", WaveType::SV, 0.0, 1e-9),
        half_space("halfspace_SV_15deg.csv", WaveType::SV, 15.0, 1e-9),
        half_space("halfspace_SV_30deg.csv", WaveType::SV, 30.0, 1e-9),
        half_space("halfspace_SV_33.5deg.csv", WaveType::SV, 33.5, 1e-9),
        half_space("halfspace_SV_40deg.csv", WaveType::SV, 40.0, 1e-6),
        half_space("halfspace_P_30deg.csv", WaveType::P, 30.0, 1e-9),
        layers("layered3_SV_20deg_elastic.csv", WaveType::SV, 20.0, DampingModel::none),
        layers("layered3_SV_0deg_hysteretic.csv", WaveType::SV, 0.0, DampingModel::hysteretic),
        layers("layered3_SV_20deg_hysteretic.csv", WaveType::SV, 20.0, DampingModel::hysteretic),
        layers("layered3_SV_40deg_hysteretic.csv", WaveType::SV, 40.0, DampingModel::hysteretic),
        layers("layered3_P_30deg_hysteretic.csv", WaveType::P, 30.0, DampingModel::hysteretic)),
    [](const auto& parameter_info) {
      std::string name = parameter_info.param.file;
      name.resize(name.size() - 4);
      std::ranges::replace(name, '.', '_');
      return name;
    });

} // namespace
