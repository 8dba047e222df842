#pragma once

// The free field at all faces of the domain at one time: the histories of the fields they take, and their
// maps. A face takes the sum of its source's fields, of which each plane wave has one. The hub uses one in
// mode lockstep, the domain in mode window; one implementation, so the modes cannot differ.

#include "coupler/mapping/mapping.hpp"
#include "coupler/wire/field.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tremolo::coupler {

/// A field of a participant in this run, as a frame names it.
struct FieldAddress {
  std::uint32_t sender = 0;
  std::uint32_t field = 0;
  friend bool operator==(const FieldAddress&, const FieldAddress&) = default;
};

class FaceExchange {
public:
  /// @param start_time,end_time of the exchange, s, on the sources' clock
  /// @throws std::invalid_argument if a face names no source, or the source does not cover it in depth or
  /// time
  FaceExchange(const std::vector<SourceDescription>& sources, std::vector<ExchangedFace> faces,
               double start_time, double end_time);

  [[nodiscard]] const std::vector<ExchangedFace>& faces() const { return faces_; }

  /// A field that faces take, and how far its steps have come.
  struct Inlet {
    FieldAddress address;
    std::string source;
    FreeFieldHistory history;
    std::uint64_t announced_credit = 0; ///< the last one sent to the source
  };
  /// Only fields that a face uses are listed; the others are never requested.
  [[nodiscard]] Inlet* find(FieldAddress address);
  [[nodiscard]] const std::vector<Inlet>& inlets() const { return inlets_; }

  /// A field's source may send its steps below this one.
  struct Credit {
    FieldAddress address;
    std::uint64_t steps = 0;
  };
  /// Forgets the steps that no face needs from this time on.
  void release_before(double time);

  /// Credits that have grown by a frame or more since the last call, to be sent to their sources.
  std::vector<Credit> new_credits();

  /// Data that the exchange still lacks at a time.
  struct Missing {
    std::string source;
    std::string field;
    std::uint64_t step = 0;
    friend bool operator==(const Missing&, const Missing&) = default;
  };
  [[nodiscard]] std::optional<Missing> missing(double time) const;

  /// Reads the free field at each face and releases the steps that are older than time.
  void read(double time, std::span<eq6::FreeField> free_field);

private:
  /// Faces that read a field at one local time, as those of a vertical side do: a point that several of them
  /// need is interpolated in time once.
  struct Station {
    std::size_t inlet = 0;
    double delay = 0.0;             ///< s
    std::vector<std::size_t> which; ///< points of the field, ascending
    std::vector<double> points;     ///< as in_time() gives them
  };
  struct Reader {
    std::size_t face = 0;
    std::size_t station = 0;
    std::size_t first = 0; ///< its first point among the station's
    FaceMap map;
  };
  void add_reader(std::size_t face, std::size_t inlet, const FaceMap& map);
  void finish_stations();

  std::vector<ExchangedFace> faces_;
  std::vector<Reader> readers_;
  std::vector<Station> stations_;
  std::vector<Inlet> inlets_;
};

} // namespace tremolo::coupler
