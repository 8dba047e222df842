// Tables: a time and one or more values a line, separated by comma, semicolon or blanks. A line of names
// above says what the columns are: "time (s), acceleration (g)".

#include "motion/formats/formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace tremolo::motion {

namespace {

/// Printed times are rounded; a step may differ from the mean by this part of it.
constexpr double step_tolerance = 0.02;

/// Lines above the data that are kept.
constexpr std::size_t most_header_lines = 200;

struct HeaderLine {
  std::string text; ///< without the # of a comment
  bool comment = false;
};

/// Cells between commas, semicolons or tabs; where there are none, between two or more blanks.
std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  const bool signs = line.find_first_of(",;\t") != std::string_view::npos;
  while (true) {
    const auto end = signs ? line.find_first_of(",;\t") : line.find("  ");
    const auto cell = trimmed(line.substr(0, end));
    if (signs || !cell.empty())
      cells.push_back(cell);
    if (end == std::string_view::npos)
      return cells;
    line.remove_prefix(end + 1);
  }
}

/// Words between blanks, each with the brackets behind it: "time (s) acceleration (m / s2)".
std::vector<std::string_view> bracketed_words(std::string_view line) {
  std::vector<std::string_view> found;
  int depth = 0;
  std::size_t begin = std::string_view::npos;
  for (std::size_t i = 0; i <= line.size(); ++i) {
    const bool blank = i == line.size() || std::isspace(static_cast<unsigned char>(line[i])) != 0;
    if (!blank)
      depth += line[i] == '(' || line[i] == '[' ? 1 : line[i] == ')' || line[i] == ']' ? -1 : 0;
    if (!blank && begin == std::string_view::npos)
      begin = i;
    if (!blank || begin == std::string_view::npos || (depth > 0 && i < line.size()))
      continue;
    const std::string_view word = line.substr(begin, i - begin);
    if (!found.empty() && (word.front() == '(' || word.front() == '['))
      found.back() = line.substr(static_cast<std::size_t>(found.back().data() - line.data()),
                                 i - static_cast<std::size_t>(found.back().data() - line.data()));
    else
      found.push_back(word);
    begin = std::string_view::npos;
  }
  return found;
}

/// The names of the columns; empty where a line names none.
std::vector<std::string> names_in(std::string_view line, std::size_t columns) {
  auto cells = cells_of(line);
  if (cells.size() < columns)
    cells = bracketed_words(line);
  if (cells.size() < columns)
    return {};
  std::vector<std::string> names(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(columns));
  // Without commas, what follows the last name belongs to it: "t acceleration m/s2".
  if (line.find_first_of(",;\t") == std::string_view::npos && cells.size() > columns)
    names.back() = line.substr(static_cast<std::size_t>(cells[columns - 1].data() - line.data()));
  return names;
}

constexpr std::array<std::string_view, 4> words_of_spectra = {"FREQ", "PERIOD", "HZ", "OMEGA"};
constexpr std::array<std::string_view, 4> words_of_steps = {"STEP", "SAMPLE", "INDEX", "NUMBER"};

bool says_one_of(std::string_view name, const std::array<std::string_view, 4>& all) {
  return std::ranges::any_of(all, [&](auto word) { return says(name, word); });
}

/// A comment, or a line without separators, may as well be a title: it names the columns where the first name
/// is one that first columns have.
bool names_columns(const HeaderLine& line, const std::vector<std::string>& names) {
  if (names.empty())
    return false;
  if (!line.comment && line.text.find_first_of(",;\t") != std::string::npos)
    return true;
  return seconds_per_time(names.front()) || says_one_of(names.front(), words_of_spectra) ||
         says_one_of(names.front(), words_of_steps);
}

/// The text above the data gives the names of the columns; comments give units and factors.
struct Header {
  std::vector<std::string> names;
  Stated comment;
};

Header header_of(const std::vector<HeaderLine>& lines, std::size_t columns) {
  Header header;
  for (const HeaderLine& line : lines) {
    auto names = names_in(line.text, columns);
    if (names_columns(line, names))
      header.names = std::move(names);
    else if (Stated stated = stated_in_peer(line.text); stated.unit || !stated.strange.empty())
      header.comment = std::move(stated);
    else if (says(line.text, "SCALE") || says(line.text, "FACTOR") || says(line.text, "MULTIPL"))
      header.comment.strange = shown(trimmed(line.text));
  }
  return header;
}

/// The column of the values, from 0.
std::size_t column_of(const Lines& lines, const ReadAs& as, const Header& header, std::size_t columns) {
  if (columns < 2)
    lines.refuse(fmt::format("a time and a value are needed, found {} columns", columns));
  std::vector<std::string> names(header.names.begin() + (header.names.empty() ? 0 : 1), header.names.end());
  if (names.empty())
    names.resize(columns - 1);
  const std::string list = header.names.empty() ? fmt::format("2 to {}", columns) : listed(names, 2);
  if (as.column.empty() && columns > 2)
    lines.refuse(fmt::format("a time and a value are needed, found {} columns: say which holds the motion "
                             "(--column): {}",
                             columns, list));
  if (as.column.empty())
    return 1;
  const auto place = place_of(as.column, names, 2);
  if (!place)
    lines.refuse(
        fmt::format("'{}' is none of its columns of values, or several of them: {}", shown(as.column), list));
  return *place + 1;
}

/// The time unit that the name of the first column states, s.
double time_unit(const std::string& name, const std::filesystem::path& file) {
  if (const auto unit = seconds_per_time(name))
    return *unit;
  throw RecordError(fmt::format(
      "{}:1: the first column is called '{}': {}", file.string(), shown(name),
      says_one_of(name, words_of_spectra)
          ? "a spectrum is no motion"
          : "it must be the time, 'time (s)' or 'time (ms)'; for numbers of steps write the times"));
}

double as_printed(double dt) {
  const double digits = std::pow(10.0, 8.0 - std::floor(std::log10(dt)));
  const double rounded = std::round(dt * digits) / digits;
  return std::abs(rounded - dt) <= 1e-12 * dt ? rounded : dt;
}

void require_later(const Lines& lines, double time, const std::vector<double>& times) {
  constexpr double rounding = 1e-9;
  if (times.empty()) {
    if (std::abs(time) > rounding)
      lines.refuse(fmt::format("the first time is {} s, must be 0; a spectrum is no motion", time));
  } else if (!(time > times.back())) {
    lines.refuse(fmt::format("time {} s does not come after {} s", time, times.back()));
  }
  if (static_cast<double>(times.size()) >= most_samples)
    lines.refuse(fmt::format("more than {:g} samples", most_samples));
}

/// The rows of a table, from the first on.
struct Rows {
  std::size_t columns = 0;
  std::size_t column = 0; ///< of the values
  double time_unit = 1.0; ///< s
  std::vector<double> times;
  std::vector<std::size_t> line_of;
  std::vector<double> values;

  void add(const Lines& lines) {
    const auto cells = words(lines.text());
    if (cells.size() != columns)
      lines.refuse(columns == 2 ? fmt::format("a time and a value are needed, found {} columns", cells.size())
                                : fmt::format("found {} columns, before {}", cells.size(), columns));
    const auto time = number(cells[0]);
    const auto value = number(cells[column]);
    if (!time || !value)
      lines.refuse(fmt::format("'{}' is not a finite number", shown(time ? cells[column] : cells[0])));
    require_later(lines, *time * time_unit, times);
    times.push_back(*time * time_unit);
    line_of.push_back(lines.number());
    values.push_back(*value);
  }
};

} // namespace

double common_step(const std::vector<double>& times, const std::vector<std::size_t>& line_of,
                   const std::filesystem::path& file) {
  const double dt = times.back() / static_cast<double>(times.size() - 1);
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double expected = static_cast<double>(i) * dt;
    if (std::abs(times[i] - expected) > step_tolerance * dt)
      refuse(file, line_of[i],
             fmt::format("time {} s, expected {:.6g} s: the steps must be equal, {:.6g} s on average here",
                         times[i], expected, dt));
  }
  return as_printed(dt);
}

std::vector<Trace> read_table(Lines& lines, const ReadAs& as) {
  std::vector<HeaderLine> above;
  Rows rows;
  Header header;
  while (lines.next()) {
    const std::string& line = lines.text();
    const auto cells = words(line);
    if (cells.empty())
      continue;
    const bool comment = line.starts_with('#');
    const bool begun = rows.columns > 0;
    if (comment && begun)
      continue;
    const bool named = std::ranges::any_of(above, [](const HeaderLine& one) { return !one.comment; });
    if (comment || (!begun && !named && !number(cells.front()))) {
      if (above.size() == most_header_lines)
        lines.refuse(fmt::format("no data in the first {} lines", most_header_lines));
      above.push_back({std::string(trimmed(std::string_view(line).substr(comment ? 1 : 0))), comment});
      continue;
    }
    if (!begun) {
      if (line.find(';') != std::string::npos && line.find(',') != std::string::npos)
        lines.refuse(decimal_commas);
      rows.columns = cells.size();
      header = header_of(above, rows.columns);
      rows.column = column_of(lines, as, header, rows.columns);
      if (!header.names.empty())
        rows.time_unit = time_unit(header.names.front(), lines.file());
    }
    rows.add(lines);
  }
  if (rows.times.size() < 2)
    lines.refuse(fmt::format("{} samples, at least 2 are needed", rows.times.size()));
  Trace trace;
  if (!header.names.empty()) {
    trace.component = header.names[rows.column];
    trace.stated = stated_in(trace.component);
  }
  if (!trace.stated.unit && trace.stated.strange.empty()) {
    trace.stated.unit = header.comment.unit;
    trace.stated.quantity = trace.stated.quantity ? trace.stated.quantity : header.comment.quantity;
  }
  const auto& [column_unit, comment_unit] = std::pair(trace.stated.unit, header.comment.unit);
  if (comment_unit && column_unit && *column_unit != *comment_unit)
    header.comment.strange =
        fmt::format("{} in a comment, {} in the name of the column", name(*comment_unit), name(*column_unit));
  if (!header.comment.strange.empty())
    trace.stated.strange = header.comment.strange;
  trace.dt = common_step(rows.times, rows.line_of, lines.file());
  trace.samples = std::move(rows.values);
  return {std::move(trace)};
}

} // namespace tremolo::motion
