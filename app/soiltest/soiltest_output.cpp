#include "app/soiltest/soiltest_output.hpp"

#include "app/output_place.hpp"
#include "app/soiltest/soiltest_lines.hpp"
#include "base/text/text_file.hpp"
#include "materials/soiltest/notes.hpp"
#include "scene/soils/soil_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tremolo::app {
namespace {

using results::Table;

constexpr const char* soiltest_content = "soil test";

std::string number_of(std::size_t index) {
  return fmt::format("{:03}", index);
}

Table about(const scene::SoilTestFile& file) {
  const auto& initial = file.test.initial;
  const auto word = [](std::string_view name, std::string_view text) {
    return Table::Column{std::string(name), "1", std::vector<std::string>{std::string(text)}};
  };
  const auto value = [](std::string_view name, std::string_view unit, double number) {
    return Table::Column{std::string(name), std::string(unit), std::vector<double>{number}};
  };
  return {{word("title", file.title), word("law", scene::model_in_force("soil", file.values)),
           word("library", file.library), word("kind", soiltest::name(file.test.kind)),
           word("drainage", soiltest::name(file.test.drainage)), word("loading", scene::name(file.kind)),
           value("vertical_stress", "Pa", initial.vertical_stress), value("k0", "1", initial.k0),
           value("shear_bias", "1", initial.shear_bias),
           word("stress_path", materials::traits(file.soil.law).in_plane ? "in_plane" : "in_space"),
           word("test_file", file.text)}};
}

Table parameters(const scene::SoilTestFile& file) {
  std::vector<std::string> names;
  std::vector<double> values;
  std::vector<std::string> units;
  std::vector<std::string> meanings;
  std::vector<std::string> origins;
  for (const auto& one : scene::parameters_in_force(file.soil, "soil", file.values)) {
    names.push_back(one.name);
    values.push_back(one.value);
    units.push_back(one.unit);
    meanings.push_back(one.meaning);
    origins.push_back(one.origin);
  }
  return {{{"name", "1", names},
           {"value", "1", values},
           {"unit", "1", units},
           {"meaning", "1", meanings},
           {"origin", "1", origins}}};
}

/// The first columns of every history.
constexpr std::array first_columns = {"step",     "cycle",  "eps_xx", "eps_yy", "eps_zz",
                                      "gamma_xy", "sig_xx", "sig_yy", "sig_zz", "sig_xy"};

/// The columns of the engine with those that the reference curves have in front, and the law's p and q.
Table history(const materials::Law& law, const soiltest::History& recorded) {
  Table table;
  std::vector<std::string> placed;
  const auto add = [&](std::string name, std::string unit, std::vector<double> values) {
    placed.push_back(name);
    table.columns.push_back({std::move(name), std::move(unit), std::move(values)});
  };
  for (const char* name : first_columns)
    add(name, std::string_view(name).starts_with("sig") ? "Pa" : "1",
        recorded.has(name) ? recorded.column(name) : std::vector<double>(recorded.rows(), 0.0));
  auto [p, q] = invariants(law, recorded);
  add("p", "Pa", std::move(p));
  add("q", "Pa", std::move(q));
  for (const soiltest::Column& column : recorded.columns)
    if (std::ranges::find(placed, column.name) == placed.end())
      add(column.name, column.unit, column.values);
  return table;
}

/// A column of numbers, one a specimen.
template <class Value>
Table::Column column(const SoilTestRun& run, const char* name, const char* unit, Value value) {
  std::vector<double> values;
  for (const Specimen& specimen : run.specimens)
    values.push_back(static_cast<double>(value(specimen)));
  return {name, unit, std::move(values)};
}

std::vector<Table::Column> cycles_columns(const SoilTestRun& run) {
  return {column(run, "cycles_1pc", "1", [](const Specimen& s) { return s.result.cycles_to.strain_1pc; }),
          column(run, "cycles_3pc", "1", [](const Specimen& s) { return s.result.cycles_to.strain_3pc; }),
          column(run, "cycles_5pc", "1", [](const Specimen& s) { return s.result.cycles_to.strain_5pc; }),
          column(run, "cycles_ru98", "1", [](const Specimen& s) { return s.result.cycles_to.ru_98; })};
}

Table summary(const scene::SoilTestFile& file, const SoilTestRun& run) {
  std::vector<std::string> tests;
  for (std::size_t i = 0; i < run.specimens.size(); ++i)
    tests.push_back(number_of(i));
  Table table{{{"test", "1", tests},
               column(run, "stress_ratio", "1", [](const Specimen& s) { return s.stress_ratio; }),
               column(run, "strain_amplitude", "1", [](const Specimen& s) { return s.amplitude; })}};
  for (auto& one : cycles_columns(run))
    table.columns.push_back(std::move(one));
  const auto peak_q = [&file](const Specimen& specimen) {
    return std::ranges::max(invariants(file.soil.law, specimen.result.history).q);
  };
  const bool has_ratio = soiltest::has_pore_pressure_ratio(file.soil.law, file.test);
  table.columns.push_back(column(run, "largest_ru", "1", [has_ratio](const Specimen& s) {
    return has_ratio ? s.result.largest_pore_pressure_ratio : std::numeric_limits<double>::quiet_NaN();
  }));
  table.columns.push_back(column(run, "largest_missing_stress", "Pa",
                                 [](const Specimen& s) { return s.result.largest_missing_stress; }));
  table.columns.push_back(column(run, "peak_q", "Pa", peak_q));
  table.columns.push_back(column(run, "steps", "1", [](const Specimen& s) { return s.result.increments; }));
  table.columns.push_back(
      column(run, "seconds", "s", [](const Specimen& s) { return s.result.cpu_seconds; }));
  return table;
}

double largest_p(const scene::SoilTestFile& file, const SoilTestRun& run) {
  double largest = 0.0;
  for (const Specimen& specimen : run.specimens)
    largest = std::max(largest, std::ranges::max(invariants(file.soil.law, specimen.result.history).p));
  return largest;
}

Table strength_curve(const SoilTestRun& run) {
  Table table{{column(run, "stress_ratio", "1", [](const Specimen& s) { return s.stress_ratio; })}};
  for (auto& one : cycles_columns(run))
    table.columns.push_back(std::move(one));
  return table;
}

Table strength_target(double relative_density) {
  const double blows = soiltest::blow_count(relative_density);
  std::vector<double> cycles;
  std::vector<double> ratios;
  constexpr int intervals = 20; // from 1 to 100 cycles, equal in the logarithm
  for (int i = 0; i <= intervals; ++i) {
    cycles.push_back(std::pow(100.0, static_cast<double>(i) / intervals));
    ratios.push_back(soiltest::idriss_boulanger_strength(blows, cycles.back()));
  }
  return {{{"cycles", "1", cycles}, {"stress_ratio", "1", ratios}}};
}

Table modulus_curve(const SoilTestRun& run) {
  std::vector<double> amplitude;
  std::vector<double> shear_strain;
  std::vector<double> modulus;
  std::vector<double> ratio;
  std::vector<double> damping;
  for (const soiltest::ModulusPoint& point : run.curve) {
    amplitude.push_back(point.amplitude);
    shear_strain.push_back(point.shear_strain);
    modulus.push_back(point.modulus);
    ratio.push_back(point.modulus_ratio);
    damping.push_back(point.damping);
  }
  return {{{"strain_amplitude", "1", amplitude},
           {"shear_strain", "1", shear_strain},
           {"shear_modulus", "Pa", modulus},
           {"modulus_ratio", "1", ratio},
           {"damping", "1", damping}}};
}

Table loops(const std::vector<soiltest::Loop>& closed) {
  const auto values = [&](auto member) {
    std::vector<double> column;
    for (const soiltest::Loop& loop : closed)
      column.push_back(static_cast<double>(loop.*member));
    return column;
  };
  using soiltest::Loop;
  return {{{"strain_amplitude", "1", values(&Loop::amplitude)},
           {"cycle", "1", values(&Loop::cycle)},
           {"shear_strain", "1", values(&Loop::shear_strain)},
           {"shear_modulus", "Pa", values(&Loop::modulus)},
           {"damping", "1", values(&Loop::damping)},
           {"ru", "1", values(&Loop::pore_pressure_ratio)}}};
}

std::string heading(const Table& table) {
  std::string names;
  for (const Table::Column& column : table.columns)
    names += (&column == &table.columns.front() ? "" : ",") + column.name;
  return names + "\n";
}

void write_csv(const std::filesystem::path& out, const Table& table) {
  TextFile file(out);
  file.add(heading(table));
  const auto rows = std::get<std::vector<double>>(table.columns.front().values).size();
  for (std::size_t i = 0; i < rows; ++i) {
    for (const Table::Column& column : table.columns)
      file.add(fmt::format("{}{}", &column == &table.columns.front() ? "" : ",",
                           std::get<std::vector<double>>(column.values)[i]));
    file.add("\n");
  }
  file.close();
}

std::size_t specimens(const scene::SoilTestFile& file) {
  return std::max({std::size_t{1}, file.stress_ratios.size(), file.amplitudes.size()});
}

} // namespace

std::vector<results::NamedTable> soiltest_tables(const scene::SoilTestFile& file, const SoilTestRun& run) {
  std::vector<results::NamedTable> tables = {{"/about", about(file)}, {"/parameters", parameters(file)}};
  for (std::size_t i = 0; i < run.specimens.size(); ++i) {
    const soiltest::Result& result = run.specimens[i].result;
    const std::string test = "/tests/" + number_of(i);
    tables.push_back({test + "/history", history(file.soil.law, result.history)});
    if (!result.loops.empty())
      tables.push_back({test + "/loops", loops(result.loops)});
  }
  tables.push_back({"/summary", summary(file, run)});
  for (const StressLine& line : stress_lines(file.soil.law, largest_p(file, run)))
    tables.push_back({"/lines/" + line.name, {{{"p", "Pa", line.p}, {"q", "Pa", line.q}}}});
  if (file.stress_ratios.size() > 1) {
    tables.push_back({"/strength_curve", strength_curve(run)});
    if (const auto density = materials::relative_density(file.soil.law))
      tables.push_back({"/strength_target", strength_target(*density)});
  }
  if (!run.curve.empty())
    tables.push_back({"/modulus_curve", modulus_curve(run)});
  return tables;
}

void check_output(const std::filesystem::path& out, const scene::SoilTestFile& file, bool plot) {
  if (out.extension() != ".h5" && out.extension() != ".csv")
    throw std::runtime_error(fmt::format("--out {}: must end with .h5 or .csv", out.string()));
  if (out.extension() == ".csv" && specimens(file) > 1)
    throw std::runtime_error(
        fmt::format("--out {}: .csv takes the history of one test, but {} asks for {}; use .h5", out.string(),
                    file.file.string(), specimens(file)));
  const bool table = out.extension() == ".csv";
  require_writable(out, {file.file},
                   table ? begins_with(fmt::format("{},", fmt::join(first_columns, ",")))
                         : has_content(soiltest_content));
  if (plot)
    require_writable(std::filesystem::path(out).replace_extension(".png"), {file.file}, is_picture_of_tremolo,
                     "--plot");
}

void write_soiltest(const std::filesystem::path& out, const scene::SoilTestFile& file,
                    const SoilTestRun& run) {
  if (out.extension() == ".csv")
    write_csv(out, history(file.soil.law, run.specimens.front().result.history));
  else
    results::write_tables(out, soiltest_content, soiltest_tables(file, run));
}

} // namespace tremolo::app
