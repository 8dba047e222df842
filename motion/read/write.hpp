#pragma once

#include "motion/record.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <string_view>

namespace tremolo::motion {

/// The first two lines of a PEER file.
using Title = std::array<std::string, 2>;

/// PEER text: the title, then quantity, unit and kind, then NPTS and DT, then five samples of eight digits a
/// line. The unit is the record's; programs that expect PEER's own want g, cm/s or cm.
/// @throws std::invalid_argument for a title that would read as another line of the header
std::string peer_text(const Record& record, const Title& title);

/// A line of names with the unit, then time and value in the shortest form that reads back to the same bits.
std::string csv_text(const Record& record);

/// Whether a file with this beginning is one that write_record() wrote.
bool is_written_record(std::string_view head);

/// Writes the format given by the extension: .AT2, .VT2, .DT2 in PEER's unit of that quantity, .csv in the
/// record's unit.
/// @throws std::invalid_argument for another extension, std::runtime_error where it cannot be written
void write_record(const Record& record, const std::filesystem::path& file, const Title& title);

} // namespace tremolo::motion
