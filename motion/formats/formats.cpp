#include "motion/formats/formats.hpp"

#include <algorithm>
#include <array>

namespace tremolo::motion {

namespace {

bool is_peer_by_name(const Head& head) {
  return stated_by_name(head.file).quantity.has_value();
}

bool is_knet(const Head& head) {
  return begins(head.line(1), "ORIGIN TIME") && head.holds("SCALE FACTOR");
}

/// "2 CORRECTED ACCELEROGRAM", "3 VELOCITY", ...; the line of the station begins with "station".
bool is_smc(const Head& head) {
  const auto first = trimmed(head.line(1));
  return first.size() > 2 && first[0] >= '1' && first[0] <= '4' && first[1] == ' ' &&
         begins(head.line(6), "STATION") && begins(head.line(2), "*");
}

bool is_cosmos(const Head& head) {
  return says(head.line(1), "(FORMAT V") && says(head.line(1), "TEXT LINES");
}

bool is_geonet(const Head& head) {
  return begins(head.line(1), "CORRECTED ACCELEROGRAM") && begins(head.line(2), "SITE ");
}

bool is_geonet_raw(const Head& head) {
  return begins(head.line(1), "UNCORRECTED ACCELEROGRAM") && begins(head.line(2), "SITE ");
}

bool is_spectra(const Head& head) {
  return begins(head.line(1), "RESPONSE AND FOURIER AMPLITUDE SPECTRA");
}

bool is_usc(const Head& head) {
  return begins(head.line(1), "CORRECTED ACCELEROGRAM") && head.holds("USC#");
}

bool is_csmip(const Head& head) {
  return (begins(head.line(1), "CORRECTED ACCELEROGRAM") ||
          begins(head.line(1), "UNCORRECTED ACCELEROGRAM")) &&
         head.holds("EQUALLY SPACED AT");
}

bool is_csmip_pairs(const Head& head) {
  return begins(head.line(1), "UNCORRECTED ACCELEROGRAM DATA") && head.holds("SEC AND G/10");
}

bool is_bhrc(const Head& head) {
  return begins(head.line(1), "* VOL1DS FILE");
}

bool is_dyna(const Head& head) {
  return head.holds("SAMPLING_INTERVAL_S:") && head.holds("NDATA:");
}

bool is_unam(const Head& head) {
  return head.holds("ARCHIVO ESTANDAR DE ACELERACION");
}

bool is_cwb(const Head& head) {
  return head.holds("#SAMPLERATE(HZ):") && head.holds("#DATASEQUENCE:");
}

bool is_nsmn(const Head& head) {
  return begins(head.line(1), "STRONG GROUND MOTION RECORDS OF TURK");
}

bool is_csv(const Head& head) {
  return upper(head.file.extension().string()) == ".CSV";
}

bool is_peer(const Head& head) {
  return std::ranges::any_of(head.lines,
                             [](const std::string& line) { return peer_header(line).has_value(); });
}

/// The first line of numbers alone is a count and a step.
bool is_count_and_step(const Head& head) {
  for (const std::string& line : head.lines) {
    const auto all = words(line);
    if (!all.empty() && std::ranges::all_of(all, [](auto word) { return number(word).has_value(); }))
      return count_and_step(line).has_value();
  }
  return false;
}

bool is_any(const Head&) {
  return true;
}

constexpr std::array all = {
    Format{.name = "PEER", .recognises = is_peer_by_name, .read = read_peer, .peer_units = true},
    Format{.name = "K-NET, KiK-net", .recognises = is_knet, .read = read_knet},
    Format{.name = "SMC", .recognises = is_smc, .read = read_smc},
    Format{.name = "COSMOS", .recognises = is_cosmos, .read = read_cosmos},
    Format{.name = "GeoNet V2A", .recognises = is_geonet, .read = read_geonet},
    Format{.name = "GeoNet V1A",
           .recognises = is_geonet_raw,
           .read = nullptr,
           .instead = "an uncorrected accelerogram; take the corrected one, V2A, of the same record"},
    Format{.name = "CSMIP volume 3",
           .recognises = is_spectra,
           .read = nullptr,
           .instead = "response spectra, not a motion; take volume 2 (.V2) of the same record"},
    Format{.name = "USC volume 2", .recognises = is_usc, .read = read_csmip},
    Format{.name = "CSMIP", .recognises = is_csmip, .read = read_csmip},
    Format{.name = "CSMIP volume 1", .recognises = is_csmip_pairs, .read = read_csmip_pairs},
    Format{.name = "BHRC volume 1", .recognises = is_bhrc, .read = read_bhrc},
    Format{.name = "ESM, DYNA", .recognises = is_dyna, .read = read_dyna},
    Format{.name = "UNAM", .recognises = is_unam, .read = read_unam},
    Format{.name = "CWB", .recognises = is_cwb, .read = read_cwb},
    Format{.name = "NSMN", .recognises = is_nsmn, .read = read_nsmn},
    Format{.name = "table", .recognises = is_csv, .read = read_table, .columns = true},
    Format{.name = "PEER", .recognises = is_peer, .read = read_peer, .peer_units = true},
    Format{.name = "count and step", .recognises = is_count_and_step, .read = read_count_and_step},
    Format{.name = "table", .recognises = is_any, .read = read_table, .columns = true},
};

} // namespace

bool Head::holds(std::string_view capitals) const {
  return std::ranges::any_of(lines, [&](const std::string& text) { return says(text, capitals); });
}

std::span<const Format> formats() {
  return all;
}

} // namespace tremolo::motion
