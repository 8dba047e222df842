#pragma once

// A motion as a record: samples of one quantity at equal steps, in one unit, and the word that says what it
// is the motion of. Nothing is converted on the side: a unit changes by converted(), a quantity by
// with_unit(), the word by as_kind(), and each refuses what cannot be done.
//
//        surface of the bare rock          surface of the soil
//     ------------ o outcrop = 2 x incident   -------------
//                 / \                          soil
//        rock    /   \                      ----- w within: incident + everything that comes back down
//               i incident                     rock

#include "base/words.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::motion {

/// Standard gravity, the g of PEER records and of this library, m/s2.
inline constexpr double standard_gravity = 9.80665;

enum class Quantity { acceleration, velocity, displacement };
constexpr auto words(Quantity) {
  return word_table<Quantity>({{Quantity::acceleration, "acceleration"},
                               {Quantity::velocity, "velocity"},
                               {Quantity::displacement, "displacement"}});
}

enum class Unit { g, m_s2, cm_s2, m_s, cm_s, m, cm, mm };
constexpr auto words(Unit) {
  return word_table<Unit>({{Unit::g, "g"},
                           {Unit::m_s2, "m/s2"},
                           {Unit::cm_s2, "cm/s2"},
                           {Unit::m_s, "m/s"},
                           {Unit::cm_s, "cm/s"},
                           {Unit::m, "m"},
                           {Unit::cm, "cm"},
                           {Unit::mm, "mm"}});
}

enum class MotionKind {
  incident, ///< of the upgoing wave alone
  outcrop,  ///< of the free surface of the bare half-space
  within,   ///< at depth, upgoing and downgoing waves together: what a downhole sensor records
};
constexpr auto words(MotionKind) {
  return word_table<MotionKind>(
      {{MotionKind::incident, "incident"}, {MotionKind::outcrop, "outcrop"}, {MotionKind::within, "within"}});
}

/// The word of a quantity, a unit ("m/s2") or a kind.
using tremolo::name;

/// The inverse of name() in lower or upper case; a unit in any usual spelling ("cm/s/s", "CM/SEC**2", "gal").
/// Nothing if unknown.
std::optional<Quantity> quantity_named(std::string_view text);
std::optional<Unit> unit_named(std::string_view text);
std::optional<MotionKind> kind_named(std::string_view text);

Quantity quantity_of(Unit unit);

/// The unit's value in m/s2, m/s or m.
double in_si(Unit unit);

/// A unit as a file may have it: `factor` times one of ours, "milli-g" is 1e-3 g and "mm/s2" 1e-3 m/s2.
struct ScaledUnit {
  Unit unit = Unit::m_s2;
  double factor = 1.0;

  bool operator==(const ScaledUnit&) const = default;
};

/// "g", "0.001 g".
std::string name(const ScaledUnit& unit);

double in_si(const ScaledUnit& unit);

/// m/s2, m/s or m.
Unit si_unit(Quantity quantity);

/// Statements of the file about the record; all empty if the record was not read from a file.
struct Origin {
  std::string format;              ///< "PEER", "K-NET, KiK-net"
  std::string component;           ///< as the file calls it; empty where it names none
  std::size_t components = 1;      ///< of the file
  std::string unit;                ///< "cm/s2 as the file says", "g, PEER's own", "g as given"
  std::string baseline;            ///< what was done to it before or while reading; empty where nobody says
  std::vector<std::string> doubts; ///< each worth a warning
};

/// Samples at 0, dt, 2 dt, ...
struct Record {
  Unit unit = Unit::m_s2;
  std::optional<MotionKind> kind = std::nullopt; ///< empty if nobody has stated it
  double dt = 0.0;                               ///< s
  std::vector<double> samples = {};              ///< in `unit`
  /// The unit stated by the file, if the caller of the reader overrode it.
  std::optional<ScaledUnit> overruled_unit = std::nullopt;
  Origin origin = {};

  Quantity quantity() const { return quantity_of(unit); }
};

/// An error in a file, as "file:line: text" ("file: text" if the file has no lines).
class RecordError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// @throws std::invalid_argument for fewer than two samples, dt <= 0, or values that are not finite
void require_sound(const Record& record);

/// The record's quantity in another unit.
/// @throws std::invalid_argument for the unit of another quantity
Record converted(Record record, Unit unit);

/// The motion in any unit: integrated (trapezoidal rule, from rest) or differentiated (slope of the natural
/// cubic spline) where the unit is that of another quantity.
Record with_unit(const Record& record, Unit unit);

/// Incident from outcrop or the reverse, at vertical incidence: outcrop = 2 x incident.
/// @throws std::invalid_argument where the record's kind is not known, and for `within`, which needs the
///         profile above
Record as_kind(Record record, MotionKind kind);

/// Time integral by the trapezoidal rule, zero at the first sample.
std::vector<double> integrate(std::span<const double> samples, double dt);

/// Slope of the natural cubic spline through at least three samples; of the straight line through two.
std::vector<double> differentiate(std::span<const double> samples, double dt);

} // namespace tremolo::motion
