#include "motion/formats/formats.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tremolo::motion {

namespace {

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
  if (!more.strange.empty())
    known.strange = more.strange;
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

std::vector<Trace> read_peer(Lines& lines, const ReadAs&) {
  Trace trace;
  std::optional<PeerHeader> header;
  while (!header && lines.next()) {
    add(trace.stated, stated_in_peer(lines.text()));
    header = peer_header(lines.text());
  }
  if (!header)
    lines.refuse("no header line with NPTS and DT");
  check(*header, lines);
  trace.dt = header->dt;
  trace.line = lines.number();
  read_samples(lines, static_cast<std::size_t>(header->count), trace.samples);
  return {std::move(trace)};
}

} // namespace tremolo::motion
