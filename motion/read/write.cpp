#include "motion/read/write.hpp"

#include "base/text/text_file.hpp"
#include "motion/formats/formats.hpp"
#include "motion/read/stated.hpp"
#include "motion/read/text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tremolo::motion {

namespace {

void require_plain(const std::string& line) {
  if (line.find_first_of("\n\r") != std::string::npos || peer_header(line) ||
      upper(line).find("UNITS") != std::string::npos)
    throw std::invalid_argument(fmt::format(
        "'{}' cannot be a title: one line that speaks neither of UNITS nor of NPTS and DT", shown(line)));
}

/// The step with four decimals, as in PEER's files, if that is exact.
std::string step_text(double dt) {
  const std::string four = fmt::format("{:7.4f}", dt);
  return number(words(four).front()) == dt ? four : fmt::format("{}", dt);
}

} // namespace

std::string peer_text(const Record& record, const Title& title) {
  require_sound(record);
  for (const std::string& line : title)
    require_plain(line);
  std::string text = fmt::format("{}\n{}\n{} TIME SERIES IN UNITS OF {}{}\nNPTS= {:6d}, DT= {} SEC\n",
                                 title[0], title[1], upper(name(record.quantity())), upper(name(record.unit)),
                                 record.kind ? fmt::format(", {}", upper(name(*record.kind))) : "",
                                 record.samples.size(), step_text(record.dt));
  constexpr std::size_t columns = 5;
  for (std::size_t i = 0; i < record.samples.size(); ++i) {
    text += fmt::format(" {:14.7E}", record.samples[i]);
    if ((i + 1) % columns == 0 || i + 1 == record.samples.size())
      text += '\n';
  }
  return text;
}

std::string csv_text(const Record& record) {
  require_sound(record);
  std::string text = fmt::format("time (s),{} ({}){}\n", name(record.quantity()), name(record.unit),
                                 record.kind ? fmt::format(" {}", name(*record.kind)) : "");
  for (std::size_t i = 0; i < record.samples.size(); ++i)
    text += fmt::format("{},{}\n", static_cast<double>(i) * record.dt, record.samples[i]);
  return text;
}

bool is_written_record(std::string_view head) {
  constexpr std::string_view heading = "time (s),";
  if (head.starts_with(heading)) {
    const auto quantities = {Quantity::acceleration, Quantity::velocity, Quantity::displacement};
    return std::ranges::any_of(quantities, [&](Quantity quantity) {
      return head.substr(heading.size()).starts_with(fmt::format("{} (", name(quantity)));
    });
  }
  const std::size_t first = head.find('\n');
  const std::size_t second = first == std::string_view::npos ? first : head.find('\n', first + 1);
  if (second == std::string_view::npos)
    return false;
  const std::string title = upper(std::string(head.substr(0, second)));
  return title.find("TREMOLO") != std::string::npos || title.substr(first + 1).starts_with("SEED ");
}

void write_record(const Record& record, const std::filesystem::path& file, const Title& title) {
  const auto quantity = stated_by_name(file).quantity;
  if (!quantity && upper(file.extension().string()) != ".CSV")
    throw std::invalid_argument(
        fmt::format("{}: a motion is written as .AT2, .VT2, .DT2 or .csv", file.string()));
  write_text_file(file,
                  quantity ? peer_text(with_unit(record, peer_unit(*quantity)), title) : csv_text(record));
}

} // namespace tremolo::motion
