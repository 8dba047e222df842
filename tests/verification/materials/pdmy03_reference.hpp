#pragma once

// Reference curves of PDMY03 by OpenSees (PressureDependMultiYield03 driven at a point), in Pa.

#include "materials/law/driver.hpp"
#include "tests/support/reference_curve.hpp"

#include <string>
#include <vector>

namespace tremolo::materials::test {

/// A row: increments so far, strain, stress.
struct Pdmy03Row {
  int step = 0;
  PointStrain strain;
  PointStress stress;
};

/// The rows of $TREMOLO_REFERENCE/materials/pdmy03_<name>.csv; none where it is absent.
inline std::vector<Pdmy03Row> pdmy03_rows(const std::string& name) {
  const testing::ReferenceCurve curve("pdmy03_" + name + ".csv");
  if (curve.empty()) {
    return {};
  }
  const auto step = curve.column("step");
  const auto exx = curve.column("eps_xx");
  const auto eyy = curve.column("eps_yy");
  const auto gxy = curve.column("gamma_xy");
  const auto sxx = curve.column("sig_xx");
  const auto syy = curve.column("sig_yy");
  const auto szz = curve.column("sig_zz");
  const auto sxy = curve.column("sig_xy");
  std::vector<Pdmy03Row> rows;
  constexpr double kilo = 1e3;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    rows.push_back({static_cast<int>(step[i]),
                    {exx[i], eyy[i], gxy[i]},
                    {kilo * sxx[i], kilo * syy[i], kilo * szz[i], kilo * sxy[i]}});
  }
  return rows;
}

/// The sand of a file: its name begins with the relative density, e.g. "dr57_".
inline Pdmy03 pdmy03_of(const std::string& name) {
  return pdmy03({.relative_density = std::stod(name.substr(2, 2)) / 100.0});
}

/// Largest difference of a stress component, Pa.
inline double difference(const PointStress& a, const PointStress& b) {
  double largest = 0.0;
  for (const double d : {a.xx - b.xx, a.yy - b.yy, a.zz - b.zz, a.xy - b.xy}) {
    largest = std::max(largest, std::abs(d));
  }
  return largest;
}

} // namespace tremolo::materials::test
