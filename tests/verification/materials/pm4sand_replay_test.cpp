// PM4Sand driven with the strain paths of an independent implementation at constant volume or along given
// paths: stresses within 1.5 per cent of sigma'_v as long as p > 2 p_min (closer where the paths are simple;
// below, every implementation has a treatment of its own). The cyclic paths hold to 3.5 per cent strain,
// through 10 to 25 cycles.

#include "tests/support/pm4sand_soil.hpp"

#include <gtest/gtest.h>

namespace tremolo::materials::test {
namespace {

struct Replay {
  const char* file;
  int density;
  double bound; ///< of the difference of stress over sigma'_v
};

class Pm4Replay : public ::testing::TestWithParam<Replay> {};

TEST_P(Pm4Replay, FollowsTheStressOfTheReference) {
  const Replay& test = GetParam();
  const Pm4Reference reference(std::string("pm4_") + test.file);
  if (reference.empty()) {
    GTEST_SKIP() << "no reference data in " << testing::reference_folder();
  }
  const Pm4Sand law = report_sand(test.density);
  PointTest point(law, reference.stress(0));
  const double p_min = std::max(pressure(reference.stress(0)), law.p_A) / 200.0;
  const double sv = -reference.syy[0];
  double worst = 0.0;
  std::size_t compared = 1;
  for (; compared < reference.size() && pressure(reference.stress(compared)) >= 2.0 * p_min; ++compared) {
    replay_row(point, reference, compared);
    worst = std::max(worst, reference.difference(compared, point.stress()));
  }
  EXPECT_LE(worst, test.bound * sv);
  EXPECT_EQ(compared, reference.size()); // these paths stay above 2 p_min
  RecordProperty("worst_over_sv", std::to_string(worst / sv));
}

std::string file_name(const ::testing::TestParamInfo<Replay>& test) {
  return test.param.file;
}

INSTANTIATE_TEST_SUITE_P(Cyclic, Pm4Replay,
                         ::testing::Values(Replay{"dr35_ucdss_csr0090_k05_s101", 35, 0.003},
                                           Replay{"dr55_ucdss_csr0147_k05_s101", 55, 0.003},
                                           Replay{"dr75_ucdss_csr0312_k05_s101", 75, 0.003},
                                           Replay{"dr55_ucdss_csr0160_k10_s100", 55, 0.003},
                                           Replay{"dr55_ucdss_bias01_csr0147_s101", 55, 0.003},
                                           Replay{"dr55_ucdss_strainctl_s100", 55, 0.003}),
                         file_name);

INSTANTIATE_TEST_SUITE_P(Monotonic, Pm4Replay,
                         ::testing::Values(Replay{"dr55_first400steps_mono_dss_u", 55, 0.001},
                                           Replay{"dr55_mono_dss_u_p25_k05", 55, 0.015},
                                           Replay{"dr55_mono_dss_u_p100_k05", 55, 0.015},
                                           Replay{"dr55_mono_dss_u_p400_k05", 55, 0.015},
                                           Replay{"dr55_mono_psc_u_p25_k10", 55, 0.015},
                                           Replay{"dr55_mono_psc_u_p100_k10", 55, 0.015},
                                           Replay{"dr55_mono_psc_u_p400_k10", 55, 0.015}),
                         file_name);

INSTANTIATE_TEST_SUITE_P(Path, Pm4Replay, ::testing::Values(Replay{"dr55_path_nonprop", 55, 0.015}),
                         file_name);

/// After 3 per cent strain the shear stress is taken off, and the soil reconsolidates to sigma'_v with the
/// reduced stiffness after shaking.
TEST(Pm4PostShake, ReconsolidatesAsTheReference) {
  const Pm4Reference reference("pm4_dr55_postshake_s101");
  if (reference.empty()) {
    GTEST_SKIP() << "no reference data in " << testing::reference_folder();
  }
  const Pm4Sand law = report_sand(55);
  PointTest shaken(law, reference.stress(0));
  std::size_t row = 1;
  for (; reference.eyy[row] == 0.0; ++row) {
    replay_row(shaken, reference, row);
  }
  PointTest settling(after_shaking(Law(law)), reference.stress(0));
  settling.set(shaken.now());
  PointTest stiff(law, reference.stress(0));
  stiff.set(shaken.now());
  const double sv = -reference.syy[0];
  double worst = 0.0;
  for (; row < reference.size(); ++row) {
    replay_row(settling, reference, row);
    replay_row(stiff, reference, row);
    worst = std::max(worst, reference.difference(row, settling.stress()));
  }
  EXPECT_LE(worst, 0.015 * sv);
  EXPECT_LT(stiff.stress().yy, 2.0 * settling.stress().yy); // without the option it would settle far less
  RecordProperty("worst_over_sv", std::to_string(worst / sv));
}

/// Expansion to zero effective stress, shearing there, and recompression. The reference forgets the expansion
/// and sets the shear stress to the positive side; trends are compared, not values.
TEST(Pm4LowPressure, FollowsTheTrendsOfTheReference) {
  const Pm4Reference reference("pm4_dr55_path_lowp");
  if (reference.empty()) {
    GTEST_SKIP() << "no reference data in " << testing::reference_folder();
  }
  const Pm4Sand law = report_sand(55);
  PointTest point(law, reference.stress(0));
  std::vector<PointStress> at(reference.size());
  for (std::size_t row = 1; row < reference.size(); ++row) {
    replay_row(point, reference, row);
    at[row] = point.stress();
  }
  const double p_min = law.p_A / 200.0;
  EXPECT_NEAR(pressure(at[600]), 0.2 * p_min, 1e-9 * p_min);       // pulled apart
  EXPECT_GT(at[1200].xy, 0.0);                                     // the sign of the shear strain, 1 per cent
  EXPECT_LT(at[2200].xy, 0.0);                                     // and of its reversal
  EXPECT_LT(pressure(at[1200]), pressure(reference.stress(1200))); // dilation first closes the gap
  EXPECT_NEAR(at[2200].xy / pressure(at[2200]), reference.sxy[2200] / pressure(reference.stress(2200)), 0.01);
  const std::size_t end = reference.size() - 1;
  EXPECT_NEAR(pressure(at[end]), pressure(reference.stress(end)), 0.05 * pressure(reference.stress(end)));
  EXPECT_NEAR(at[end].xy, reference.sxy[end], 0.05 * reference.sxy[end]);
}

} // namespace
} // namespace tremolo::materials::test
