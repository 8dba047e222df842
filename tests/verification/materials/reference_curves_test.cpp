// Curves of an independent implementation (sub-stepped, lagged plastic strain), read from $TREMOLO_REFERENCE.

#include "soils.hpp"
#include "tests/support/reference_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace tremolo::materials::test {
namespace {

/// A row: strains, and stresses in Pa.
struct Row {
  PointStrain strain;
  PointStress stress;
};

/// Columns eps_xx, eps_yy, gamma_xy, sig_xx, sig_yy, sig_zz, sig_xy (kPa), eqps, region. No rows where the
/// file is absent.
std::vector<Row> rows(const std::string& name) {
  std::vector<Row> result;
  for (const std::vector<double>& c : testing::read_table(testing::reference_folder() / "materials" / name)) {
    result.push_back({{c[0], c[1], c[2]}, {c[3] * kPa, c[4] * kPa, c[5] * kPa, c[6] * kPa}});
  }
  return result;
}

/// Follows the rows' eps_xx and gamma_xy, with sigma_yy held, in `substeps` steps a row; the largest
/// difference of shear stress, Pa.
double worst_shear_stress(const MohrCoulomb& soil, const std::vector<Row>& rows, int substeps) {
  PointTest point(soil, rows.front().stress);
  double worst = 0.0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double shear = (rows[i].strain.xy - rows[i - 1].strain.xy) / substeps;
    for (int n = 0; n < substeps; ++n) {
      point.apply({Control::strain(0.0), Control::stress(rows.front().stress.yy), Control::strain(shear)});
    }
    worst = std::max(worst, std::abs(point.stress().xy - rows[i].stress.xy));
  }
  return worst;
}

TEST(ReferenceCurve, SimpleShearWithoutSoftening) {
  const std::vector<Row> friction = rows("mc_perfect45_dss_d_s100_k05.csv");
  const std::vector<Row> dilation = rows("mc_perfect30psi10_dss_d_s100_k05.csv");
  if (friction.empty() || dilation.empty()) {
    GTEST_SKIP() << "no reference data in " << testing::reference_folder();
  }
  EXPECT_LT(worst_shear_stress(without_softening(slope_soil()), friction, 10), 0.05 * kPa);
  EXPECT_LT(worst_shear_stress(perfect_soil(30.0, 10.0, 10.0), dilation, 10), 0.05 * kPa);
}

TEST(ReferenceCurve, SimpleShearWithSoftening) {
  const std::vector<Row> curve = rows("mc_seed_dss_d_s100_k05.csv");
  if (curve.empty()) {
    GTEST_SKIP() << "no reference data in " << testing::reference_folder();
  }
  EXPECT_LT(worst_shear_stress(slope_soil(), curve, 4), 0.1 * kPa);
}

TEST(ReferenceCurve, CompressionWithSoftening) {
  const std::vector<Row> curve = rows("mc_seed_psc_d_s50.csv");
  if (curve.empty()) {
    GTEST_SKIP() << "no reference data in " << testing::reference_folder();
  }
  PointTest point(slope_soil(), curve.front().stress);
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const double shortening = curve[i].strain.yy - curve[i - 1].strain.yy;
    point.apply({Control::stress(curve.front().stress.xx), Control::strain(shortening)});
    EXPECT_NEAR(point.stress().yy, curve[i].stress.yy, 2e-3 * std::abs(curve[i].stress.yy)) << "row " << i;
  }
}

TEST(ReferenceCurve, StrainPathThroughTheApex) {
  const std::vector<Row> path = rows("mc_seed_path_apex_s10.csv");
  if (path.empty()) {
    GTEST_SKIP() << "no reference data in " << testing::reference_folder();
  }
  PointTest point(slope_soil(), path.front().stress);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const PointStrain a = path[i - 1].strain;
    const PointStrain b = path[i].strain;
    point.apply({Control::strain(b.xx - a.xx), Control::strain(b.yy - a.yy), Control::strain(b.xy - a.xy)});
    EXPECT_NEAR(point.stress().xx, path[i].stress.xx, 0.1 * kPa) << "row " << i;
    EXPECT_NEAR(point.stress().yy, path[i].stress.yy, 0.1 * kPa) << "row " << i;
    EXPECT_NEAR(point.stress().xy, path[i].stress.xy, 0.1 * kPa) << "row " << i;
  }
}

} // namespace
} // namespace tremolo::materials::test
