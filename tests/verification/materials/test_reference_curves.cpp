// Curves of an independent implementation (sub-stepped, lagged plastic strain), read from $TREMOLO_REFERENCE.

#include "soils.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace tremolo::materials::test {
namespace {

/// A row: strains, and stresses in Pa.
struct Row {
  PointStrain strain;
  PointStress stress;
  double plastic_strain = 0.0;
};

std::filesystem::path reference_folder() {
  const char* set = std::getenv("TREMOLO_REFERENCE");
  return set != nullptr ? std::filesystem::path(set)
                        : std::filesystem::path(TREMOLO_SOURCE_DIR) / "../shared/reference";
}

/// Columns eps_xx, eps_yy, gamma_xy, sig_xx, sig_yy, sig_zz, sig_xy (kPa), eqps, region.
std::vector<Row> read(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  std::vector<Row> rows;
  while (std::getline(in, line)) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream fields(line);
    Row row;
    fields >> row.strain.xx >> row.strain.yy >> row.strain.xy >> row.stress.xx >> row.stress.yy >>
        row.stress.zz >> row.stress.xy >> row.plastic_strain;
    row.stress = {row.stress.xx * kPa, row.stress.yy * kPa, row.stress.zz * kPa, row.stress.xy * kPa};
    rows.push_back(row);
  }
  return rows;
}

class ReferenceCurve : public testing::Test {
protected:
  /// Rows of a file, or a skipped test where it is absent.
  std::vector<Row> rows(const std::string& name) const {
    const std::filesystem::path file = reference_folder() / "materials" / name;
    return std::filesystem::exists(file) ? read(file) : std::vector<Row>();
  }
};

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

TEST_F(ReferenceCurve, SimpleShearWithoutSoftening) {
  const std::vector<Row> friction = rows("mc_perfect45_dss_d_s100_k05.csv");
  const std::vector<Row> dilation = rows("mc_perfect30psi10_dss_d_s100_k05.csv");
  if (friction.empty() || dilation.empty()) {
    GTEST_SKIP() << "no reference data in " << reference_folder();
  }
  EXPECT_LT(worst_shear_stress(without_softening(slope_soil()), friction, 10), 0.05 * kPa);
  EXPECT_LT(worst_shear_stress(perfect_soil(30.0, 10.0, 10.0), dilation, 10), 0.05 * kPa);
}

TEST_F(ReferenceCurve, SimpleShearWithSoftening) {
  const std::vector<Row> curve = rows("mc_seed_dss_d_s100_k05.csv");
  if (curve.empty()) {
    GTEST_SKIP() << "no reference data in " << reference_folder();
  }
  EXPECT_LT(worst_shear_stress(slope_soil(), curve, 4), 0.1 * kPa);
}

TEST_F(ReferenceCurve, CompressionWithSoftening) {
  const std::vector<Row> curve = rows("mc_seed_psc_d_s50.csv");
  if (curve.empty()) {
    GTEST_SKIP() << "no reference data in " << reference_folder();
  }
  PointTest point(slope_soil(), curve.front().stress);
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const double shortening = curve[i].strain.yy - curve[i - 1].strain.yy;
    point.apply({Control::stress(curve.front().stress.xx), Control::strain(shortening)});
    EXPECT_NEAR(point.stress().yy, curve[i].stress.yy, 2e-3 * std::abs(curve[i].stress.yy)) << "row " << i;
  }
}

TEST_F(ReferenceCurve, StrainPathThroughTheApex) {
  const std::vector<Row> path = rows("mc_seed_path_apex_s10.csv");
  if (path.empty()) {
    GTEST_SKIP() << "no reference data in " << reference_folder();
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
