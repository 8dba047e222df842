// Transfer functions against stored spectra: three layers at several angles and damping models (made with 120
// digits and by a second method), and the closed forms of one and two Kelvin-Voigt layers,
// 1 / cos(k H) within, 1 / (cos k H + i alpha sin k H) outcrop.

#include "tests/support/layered_reference.hpp"
#include "tests/support/reference_table.hpp"
#include "wavefield/layers/transfer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace {

using namespace tremolo::wavefield;
using tremolo::testing::radians;
using Complex = std::complex<double>;

struct SpectrumRows {
  std::vector<double> frequency;
  std::vector<Complex> ux, uy;
};

/// Rows kind,theta_deg,model,freq_Hz,Re_ux,Im_ux,Re_uy,Im_uy by their first three columns.
std::map<std::tuple<std::string, double, std::string>, SpectrumRows>
read_spectra(const std::filesystem::path& file) {
  std::map<std::tuple<std::string, double, std::string>, SpectrumRows> spectra;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line[0] == '#' || line.starts_with("kind")) {
      continue;
    }
    std::istringstream cells(line);
    std::array<std::string, 8> cell;
    for (std::string& text : cell) {
      std::getline(cells, text, ',');
    }
    SpectrumRows& rows = spectra[{cell[0], std::stod(cell[1]), cell[2]}];
    rows.frequency.push_back(std::stod(cell[3]));
    rows.ux.emplace_back(std::stod(cell[4]), std::stod(cell[5]));
    rows.uy.emplace_back(std::stod(cell[6]), std::stod(cell[7]));
  }
  return spectra;
}

DampingModel model_named(const std::string& text) {
  for (const DampingModel model : {DampingModel::none, DampingModel::hysteretic, DampingModel::shake,
                                   DampingModel::kelvin_voigt, DampingModel::kjartansson}) {
    if (name(model) == text) {
      return model;
    }
  }
  throw std::invalid_argument("no damping model " + text);
}

TEST(SurfaceSpectra, OfThreeLayersAreReproduced) {
  const auto file = tremolo::testing::reference_folder() / "waves" / "layered3_tf_surface.csv";
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << "no reference data at " << file;
  }
  const auto spectra = read_spectra(file);
  ASSERT_GE(spectra.size(), 9U);
  double worst = 0.0;
  for (const auto& [key, rows] : spectra) {
    const auto& [kind, degrees, model] = key;
    const auto profile = tremolo::testing::layered3({model_named(model), 3.0});
    const auto computed = surface_transfer(profile, kind == "SV" ? WaveType::SV : WaveType::P,
                                           radians(degrees), rows.frequency);
    double peak = 0.0;
    double error = 0.0;
    for (std::size_t i = 0; i < computed.size(); ++i) {
      peak = std::max({peak, std::abs(rows.ux[i]), std::abs(rows.uy[i])});
      error = std::max({error, std::abs(computed[i].surface.ux - rows.ux[i]),
                        std::abs(computed[i].surface.uy - rows.uy[i])});
    }
    EXPECT_LT(error / peak, 1e-9) << kind << " " << degrees << " " << model;
    worst = std::max(worst, error / peak);
  }
  std::printf("layered3_tf_surface.csv, %zu spectra: %.1e of the peak\n", spectra.size(), worst);
}

/// Damping ratio at 1 Hz of a Kelvin-Voigt viscosity (Pa s).
double ratio_at_1_hz(double viscosity, double shear) {
  return viscosity * std::numbers::pi / shear;
}

void expect_columns(const char* name, const LayeredHalfSpace& profile) {
  const auto file = tremolo::testing::reference_folder() / "waves" / name;
  if (!std::filesystem::exists(file)) {
    GTEST_SKIP() << "no reference data at " << file;
  }
  const auto rows = tremolo::testing::read_table(file);
  std::vector<double> frequencies;
  for (const auto& row : rows) {
    frequencies.push_back(row[0]);
  }
  const auto computed = surface_transfer(profile, WaveType::SV, 0.0, frequencies);
  double error = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Complex within(rows[i][1], rows[i][2]);
    const Complex outcrop(rows[i][3], rows[i][4]);
    error = std::max({error, std::abs(computed[i].to_within - within) / std::max(1.0, std::abs(within)),
                      std::abs(computed[i].to_outcrop - outcrop)});
  }
  EXPECT_LT(error, 1e-9);
  std::printf("%s: %.1e\n", name, error);
}

TEST(SurfaceSpectra, OfOneKelvinVoigtLayerAreTheClosedForm) {
  const double viscosity = 0.02 * 1800.0 * 200.0 * 200.0 / (std::numbers::pi * (200.0 / 120.0));
  expect_columns("tf_uniform_kv.csv",
                 {.layers = {{.thickness = 30.0,
                              .density = 1800.0,
                              .vs = 200.0,
                              .vp = 400.0,
                              .damping = ratio_at_1_hz(viscosity, 1800.0 * 200.0 * 200.0)}},
                  .half_space = {2200.0, 800.0, 1600.0},
                  .damping = {DampingModel::kelvin_voigt, 1.0}});
}

TEST(SurfaceSpectra, OfTwoKelvinVoigtLayersAreTheClosedForm) {
  expect_columns("tf_twolayer_kv.csv", {.layers = {{.thickness = 8.0,
                                                    .density = 1700.0,
                                                    .vs = 150.0,
                                                    .vp = 300.0,
                                                    .damping = ratio_at_1_hz(1.2e5, 1700.0 * 150.0 * 150.0)},
                                                   {.thickness = 22.0,
                                                    .density = 1900.0,
                                                    .vs = 300.0,
                                                    .vp = 600.0,
                                                    .damping = ratio_at_1_hz(3e5, 1900.0 * 300.0 * 300.0)}},
                                        .half_space = {2200.0, 800.0, 1600.0},
                                        .damping = {DampingModel::kelvin_voigt, 1.0}});
}

} // namespace
