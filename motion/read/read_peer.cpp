#include "motion/read/read_formats.hpp"
#include "motion/read/stated.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tremolo::motion {

namespace {

constexpr const char* decimal_commas =
    "decimal commas: numbers are written with a point, 0.123 instead of 0,123";

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Whether a comma stands in front of a digit, and no number of the line has a point: "DT= 0,02", "DT= ,02".
bool splits_a_number(std::string_view header) {
  bool found = false;
  for (std::size_t i = 0; i + 1 < header.size(); ++i)
    found = found || (header[i] == ',' && is_digit(header[i + 1]));
  return found && header.find('.') == std::string_view::npos;
}

void check(const PeerHeader& header, const Lines& lines) {
  if (splits_a_number(lines.text()))
    lines.refuse(decimal_commas);
  if (!(header.count >= 2.0 && header.count <= most_samples) || header.count != std::floor(header.count))
    lines.refuse(fmt::format("NPTS = {}, must be a whole number from 2 to {:g}", header.count, most_samples));
  if (!(header.dt > 0.0))
    lines.refuse(fmt::format("DT = {} s, must be > 0", header.dt));
}

/// Takes over what the line says and the lines before did not.
void add(Stated& known, const Stated& more) {
  if (more.quantity)
    known.quantity = more.quantity;
  if (more.unit)
    known.unit = more.unit;
  if (more.kind)
    known.kind = more.kind;
  if (!more.strange_unit.empty())
    known.strange_unit = more.strange_unit;
}

/// Whether each comma stands in front of a digit, and no number has a point: "0,123 -,045".
bool has_decimal_commas(std::string_view line) {
  bool found = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '.')
      return false;
    if (line[i] != ',')
      continue;
    if (i + 1 == line.size() || !is_digit(line[i + 1]))
      return false;
    found = true;
  }
  return found;
}

void read_samples(Lines& lines, std::size_t count, std::vector<double>& samples) {
  while (lines.next()) {
    if (has_decimal_commas(lines.text()))
      lines.refuse(decimal_commas);
    for (const auto word : words(lines.text())) {
      const auto value = number(word);
      if (!value)
        lines.refuse(fmt::format("'{}' is not a finite number", shown(word)));
      if (samples.size() == count)
        lines.refuse(fmt::format("the header says NPTS = {} but there are more samples", count));
      samples.push_back(*value);
    }
  }
  if (samples.size() != count)
    lines.refuse(fmt::format("the header says NPTS = {} but there are {} samples", count, samples.size()));
}

} // namespace

std::optional<PeerHeader> peer_header(std::string_view line) {
  const auto all = words(line);
  std::optional<double> count;
  std::optional<double> dt;
  std::vector<double> leading;
  std::vector<char> order;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::string word = upper(all[i]);
    const bool is_count = word == "NPTS" || word == "NPTS.";
    const bool is_dt = word == "DT" || word == "DT.";
    if (is_count || is_dt) {
      order.push_back(is_count ? 'n' : 'd');
      if (i + 1 < all.size())
        if (const auto value = number(all[i + 1]))
          (is_count ? count : dt) = value;
    } else if (const auto value = number(all[i]); value && order.empty()) {
      leading.push_back(*value);
    }
  }
  if (order.size() != 2)
    return std::nullopt;
  if (!count && !dt && leading.size() == 2) {
    count = leading[order[0] == 'n' ? 0 : 1];
    dt = leading[order[0] == 'n' ? 1 : 0];
  }
  if (!count || !dt)
    return std::nullopt;
  return PeerHeader{*count, *dt};
}

Record read_peer(Lines& lines, const ReadAs& as) {
  Stated by_header;
  std::optional<PeerHeader> header;
  while (!header && lines.next()) {
    add(by_header, stated_in_peer(lines.text()));
    header = peer_header(lines.text());
  }
  if (!header)
    lines.refuse("no header line with NPTS and DT");
  check(*header, lines);
  Record record{.dt = header->dt};
  settle(record, stated_by_name(lines.file()), by_header, as, true,
         fmt::format("{}:{}", lines.file().string(), lines.number()));
  read_samples(lines, static_cast<std::size_t>(header->count), record.samples);
  return record;
}

} // namespace tremolo::motion
