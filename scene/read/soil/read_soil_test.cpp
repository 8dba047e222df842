#include "base/text/unreadable.hpp"
#include "materials/soiltest/path/path_table.hpp"
#include "scene/read/soil/read_soil.hpp"
#include "scene/soil_test.hpp"
#include "scene/soils/soil_library.hpp"
#include "scene/text/text.hpp"

#include <fmt/format.h>

#include <array>
#include <exception>
#include <fstream>
#include <stdexcept>

namespace tremolo::scene {

namespace {

/// K0 of a test that gives none: of a deposit where there is no lateral strain, otherwise as the specimen is
/// consolidated.
double usual_k0(soiltest::Kind kind) {
  return kind == soiltest::Kind::direct_simple_shear || kind == soiltest::Kind::oedometer ? 0.5 : 1.0;
}

void read_test(Document& document, SoilTestFile& file) {
  const auto table = document.table("test");
  auto& test = file.test;
  if (table.text("kind").empty() || table.text("drainage").empty())
    return;
  test.kind = table.choice<soiltest::Kind>("kind");
  test.drainage = table.choice<soiltest::Drainage>("drainage");
  test.pore_stiffness = table.number("pore_stiffness");
  test.initial = {.vertical_stress = table.number("vertical_stress"),
                  .k0 = table.optional_number("k0").value_or(usual_k0(test.kind)),
                  .shear_bias = table.number("shear_bias"),
                  .bias_in_initial_stress = table.text("bias_applied") == "in_initial_stress"};
  test.strain_increment = table.number("strain_increment");
  test.every = static_cast<std::size_t>(table.integer("every"));
}

soiltest::Path read_path(const TableReader& table, const std::filesystem::path& name, Findings& findings) {
  if (!findings.sound(table.path("file")) || table.text("file").empty())
    return {};
  if (const auto why = why_unreadable(name); !why.empty()) {
    findings.add(table.path("file"), fmt::format("{}: {}", name.string(), why));
    return {};
  }
  std::ifstream stream(name);
  try {
    constexpr double kilopascal = 1e3;
    return soiltest::read_path(stream, table.texts("by_stress"),
                               table.text("stress_unit") == "kPa" ? kilopascal : 1.0);
  } catch (const std::invalid_argument& error) {
    findings.add(table.path("file"), fmt::format("{}: {}", name.string(), error.what()));
    return {};
  }
}

void read_loading(const TableReader& table, const std::filesystem::path& directory, Findings& findings,
                  SoilTestFile& file) {
  using enum LoadingKind;
  file.kind = table.choice<LoadingKind>("kind");
  file.cycles = table.integer("cycles");
  switch (file.kind) {
  case monotonic:
    file.test.loading = soiltest::Monotonic{table.number("strain")};
    break;
  case cyclic_stress:
    file.stress_ratios = table.numbers("stress_ratio");
    file.test.loading =
        soiltest::StressCycles{.stress_ratio = file.stress_ratios.empty() ? 0.0 : file.stress_ratios.front(),
                               .largest_strain = table.number("largest_strain"),
                               .most_cycles = table.number("most_cycles"),
                               .pore_pressure_ratio = table.optional_number("largest_pore_pressure_ratio")};
    break;
  case cyclic_strain:
    file.test.loading = soiltest::StrainCycles{table.numbers("strain_amplitude"), file.cycles};
    break;
  case modulus_curve:
    file.amplitudes = table.numbers("strain_amplitude");
    file.test.loading = soiltest::StrainCycles{file.amplitudes, file.cycles};
    break;
  case path:
    file.path_table = directory / table.text("file");
    file.test.loading = read_path(table, file.path_table, findings);
    break;
  }
  const bool free = file.test.kind == soiltest::Kind::path;
  if (free != (file.kind == path) && findings.sound("test") && findings.sound("test.kind") &&
      findings.sound(table.path("kind")))
    findings.add(table.path("kind"), "a path belongs to [test] kind = \"path\", and no other loading does");
}

/// Refuses a stress ratio that no test can look for.
void check_curve(const TableReader& table, Findings& findings, double density, const CurveStrength& curve) {
  if (!(curve.stress_ratio() >= soiltest::least_stress_ratio &&
        curve.stress_ratio() <= soiltest::largest_stress_ratio))
    findings.add(
        table.path("curve"),
        fmt::format("'curve' at 'relative_density' = {} is a cyclic stress ratio of {:.3g} (K_sigma "
                    "= {:.3g}), outside [{}, {}]: the curve is made for (N1)60 = 46 D_R^2 below 37.5, "
                    "D_R = 0.9; give 'stress_ratio'",
                    density, curve.stress_ratio(), curve.overburden_factor, soiltest::least_stress_ratio,
                    soiltest::largest_stress_ratio));
}

/// The strength of the curve, where the test is one that it holds for.
std::optional<CurveStrength> read_curve_strength(const TableReader& table, Findings& findings,
                                                 const SoilTestFile& file, double cycles) {
  const auto& initial = file.test.initial;
  const auto density = materials::relative_density(file.soil.law);
  if (!density || !(initial.vertical_stress > 0.0) || !findings.sound(table.path("cycles")))
    return std::nullopt;
  if (initial.shear_bias != 0.0) {
    findings.add(table.path("curve"),
                 fmt::format("'curve' is the strength without static shear; its change K_alpha with [test] "
                             "'shear_bias' = {} is not given by it: give 'stress_ratio'",
                             initial.shear_bias));
    return std::nullopt;
  }
  if (*density > 1.0) {
    findings.add(table.path("curve"), fmt::format("'curve' ends at a relative density of 1, below "
                                                  "'relative_density' = {}: give 'stress_ratio'",
                                                  *density));
    return std::nullopt;
  }
  const CurveStrength curve = {soiltest::idriss_boulanger_strength(soiltest::blow_count(*density), cycles),
                               overburden_factor(*density, initial.vertical_stress)};
  check_curve(table, findings, *density, curve);
  return curve;
}

/// The stress ratio that is wanted, where one of the two ways of giving it is there.
void read_wanted(const TableReader& table, Findings& findings, const SoilTestFile& file,
                 StrengthWanted& wanted) {
  const bool of_curve = table.given("curve");
  if (of_curve == table.given("stress_ratio")) {
    findings.add(table.path("curve"), of_curve
                                          ? "'curve' and 'stress_ratio' exclude each other: remove one"
                                          : "missing 'curve' or 'stress_ratio': which strength is wanted");
    return;
  }
  wanted.stress_ratio = table.number("stress_ratio");
  if (of_curve)
    wanted.curve = read_curve_strength(table, findings, file, wanted.cycles);
  if (wanted.curve)
    wanted.stress_ratio = wanted.curve->stress_ratio();
}

void read_target(const TableReader& table, Findings& findings, SoilTestFile& file) {
  const auto place = findings.place(table.path());
  StrengthWanted wanted{.cycles = table.number("cycles"),
                        .least = table.number("least"),
                        .most = table.number("most"),
                        .place = fmt::format("{}:{}:{}", findings.file(), place.line, place.column)};
  wanted.criterion = table.choice<soiltest::Criterion>("criterion");
  read_wanted(table, findings, file, wanted);
  if (!findings.sound("soil") || !findings.sound("soil.model"))
    return;
  const auto rate = materials::contraction_rate(file.soil.law);
  if (!rate) {
    findings.add("soil.model",
                 fmt::format("'contraction_rate' is a parameter of \"pm4sand\"; \"{}\" has none to fit",
                             materials::name(file.soil.law)));
    return;
  }
  wanted.guess = *rate;
  if (!(wanted.least < wanted.most))
    findings.add(table.path("least"),
                 fmt::format("'least' = {} must be below 'most' = {}", wanted.least, wanted.most));
  else if (!(wanted.guess >= wanted.least && wanted.guess <= wanted.most))
    findings.add(
        "soil.contraction_rate",
        fmt::format("'contraction_rate' = {} is the first guess, must be in [{}, {}] ('least' and 'most' of "
                    "[target])",
                    wanted.guess, wanted.least, wanted.most));
  file.target = wanted;
}

/// An error in the rows of a path; empty if there is none.
std::string path_error(const SoilTestFile& file) {
  auto test = file.test;
  test.loading = soiltest::Path{.rows = {{.step = 0.0}, {.step = 1.0}}};
  soiltest::validate(file.soil.law, test);
  try {
    soiltest::validate(file.soil.law, file.test);
    return {};
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

/// Checks that need both the law and the whole test.
void check_test(const SoilTestFile& file, SoilTestUse use, Findings& findings) {
  try {
    materials::validate(file.soil.law);
  } catch (const std::invalid_argument& error) {
    findings.add("soil", error.what());
    return;
  }
  auto test = file.test;
  if (use == SoilTestUse::calibration && file.target)
    test.loading = soiltest::StressCycles{.stress_ratio = file.target->stress_ratio};
  try {
    if (use == SoilTestUse::test && file.kind == LoadingKind::path) {
      if (const auto wrong = path_error(file); !wrong.empty())
        findings.add("loading.file", fmt::format("{}: {}", file.path_table.string(), wrong));
      return;
    }
    soiltest::validate(file.soil.law, test);
  } catch (const std::invalid_argument& error) {
    findings.add("test", error.what());
  }
}

} // namespace

SoilTestFile parse_soil_test(std::string_view text, const std::filesystem::path& name,
                             const std::filesystem::path& directory, SoilTestUse use) {
  Findings findings(name.string());
  SoilTestFile file;
  file.file = name;
  file.text = text;
  const toml::table root = parse_toml(text, findings);
  Document document(root, {soil_test_keys(), findings, file.values});
  file.title = document.table("").text("title");
  const NamedTable soil{"soil", document.table("soil")};
  file.library = soil.reader.text(library_key);
  file.soil = read_soil(soil, directory, 0.0, findings);
  read_test(document, file);
  const auto loading = document.table("loading");
  const auto target = document.table("target");
  if (document.has("loading"))
    read_loading(loading, directory, findings, file);
  else if (use == SoilTestUse::test)
    findings.add("loading", "missing table [loading]: what is done to the soil");
  if (document.has("target"))
    read_target(target, findings, file);
  else if (use == SoilTestUse::calibration)
    findings.add("target", "missing table [target]: the cyclic strength that is wanted");
  findings.throw_if_any();
  check_test(file, use, findings);
  findings.throw_if_any();
  return file;
}

SoilTestFile load_soil_test(const std::filesystem::path& file, SoilTestUse use) {
  return parse_soil_test(read_text(file), file, file.parent_path(), use);
}

} // namespace tremolo::scene
