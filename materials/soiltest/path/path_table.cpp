#include "materials/soiltest/path/path_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <stdexcept>

namespace tremolo::soiltest {
namespace {

constexpr std::array<std::string_view, 4> strain_names = {"eps_xx", "eps_yy", "gamma_xy", "eps_zz"};

std::vector<std::string_view> cells(std::string_view line) {
  std::vector<std::string_view> found;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    std::string_view cell = line.substr(begin, end - begin);
    cell.remove_prefix(std::min(cell.find_first_not_of(" \t"), cell.size()));
    cell = cell.substr(0, cell.find_last_not_of(" \t\r") + 1);
    found.push_back(cell);
    begin = end + 1;
  }
  return found;
}

double number(std::string_view cell, int line) {
  double value = 0.0;
  const char* begin = cell.data() + (cell.starts_with('+') ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size())
    throw std::invalid_argument(fmt::format("line {} of the path: \"{}\" is not a number", line, cell));
  return value;
}

/// Positions of a path's columns.
class Columns {
public:
  Columns(std::string_view header, const Path& path) : names_(cells(header)) {
    refuse_twice();
    step_ = at("step");
    for (std::size_t i = 0; i < 4; ++i) {
      const std::string_view name = path.by_stress[i] ? stress_names[i] : strain_names[i];
      places_[i] = at(name);
      if (!places_[i] && name != "eps_zz") {
        throw std::invalid_argument(
            fmt::format("the path has no column \"{}\"; its columns are {}", name, fmt::join(names_, ", ")));
      }
    }
  }

  PathRow row(std::string_view text, int line, std::size_t index, const Path& path,
              double stress_unit) const {
    const std::vector<std::string_view> row_cells = cells(text);
    if (row_cells.size() != names_.size()) {
      throw std::invalid_argument(fmt::format("line {} of the path has {} cells, its first line names {}",
                                              line, row_cells.size(), names_.size()));
    }
    PathRow row;
    row.line = line;
    row.step = step_ ? number(row_cells[*step_], line) : static_cast<double>(index);
    double* const strains[] = {&row.strain.xx, &row.strain.yy, &row.strain.xy, &row.strain.zz};
    double* const stresses[] = {&row.stress.xx, &row.stress.yy, &row.stress.xy, &row.stress.zz};
    for (std::size_t i = 0; i < 4; ++i) {
      if (places_[i]) {
        const double value = number(row_cells[*places_[i]], line);
        (path.by_stress[i] ? *stresses[i] : *strains[i]) = path.by_stress[i] ? stress_unit * value : value;
      }
      if (const auto stress = at(stress_names[i]); stress && index == 0)
        *stresses[i] = stress_unit * number(row_cells[*stress], line);
    }
    return row;
  }

private:
  void refuse_twice() const {
    for (std::size_t i = 0; i < names_.size(); ++i) {
      if (!names_[i].empty() && at(names_[i]) != i) {
        throw std::invalid_argument(
            fmt::format("line 1 of the path names the column \"{}\" twice", names_[i]));
      }
    }
  }

  std::optional<std::size_t> at(std::string_view name) const {
    const auto found = std::find(names_.begin(), names_.end(), name);
    return found == names_.end() ? std::nullopt
                                 : std::optional(static_cast<std::size_t>(found - names_.begin()));
  }

  std::vector<std::string_view> names_;
  std::optional<std::size_t> step_;
  std::array<std::optional<std::size_t>, 4> places_;
};

} // namespace

std::string place(const PathRow& row, std::size_t index) {
  return fmt::format("row {} of the path{}", index + 1,
                     row.line > 0 ? fmt::format(" (line {})", row.line) : "");
}

Path read_path(std::istream& table, const std::vector<std::string>& by_stress, double stress_unit) {
  Path path;
  for (const std::string& name : by_stress) {
    const auto* found = std::find(stress_names.begin(), stress_names.end(), name);
    if (found == stress_names.end()) {
      throw std::invalid_argument(fmt::format("\"{}\" is no stress that can be prescribed; known: {}", name,
                                              fmt::join(stress_names, ", ")));
    }
    path.by_stress[static_cast<std::size_t>(found - stress_names.begin())] = true;
  }
  std::string header;
  if (!std::getline(table, header))
    throw std::invalid_argument("the path is empty");
  const Columns columns(header, path);
  int line = 1;
  for (std::string text; std::getline(table, text);) {
    ++line;
    if (text.find_first_not_of(" \t\r") != std::string::npos)
      path.rows.push_back(columns.row(text, line, path.rows.size(), path, stress_unit));
  }
  return path;
}

} // namespace tremolo::soiltest
