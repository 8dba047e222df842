#pragma once

// Structures and linings of a case, sections through structures, and props between them.

#include "mpm_domain/spec/lining.hpp"
#include "mpm_domain/spec/prop.hpp"
#include "mpm_domain/spec/structure.hpp"
#include "scene/geometry.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tremolo::scene {

/// A closed line of [[structure]] and [[lining]].
struct Outline {
  std::string_view key; ///< of its table that gives it, "polygon" or "circle"
  Polygon corners;
};

/// Contact properties of a structure's surface against a soil.
struct SoilContact {
  double friction = 0.0; ///< mu
  double adhesion = 0.0; ///< Pa
};

/// [[structure]]: a body that stands in or on the soil.
struct Structure {
  std::string name;
  Outline outline;
  std::optional<Outline> hole;                    ///< its empty inside
  double density = 0.0;                           ///< of what lies between both, kg/m3
  std::optional<mpm_domain::Stiffness> stiffness; ///< of an elastic one; none: rigid
  double friction = 0.0;                          ///< against other structures; of two the smaller counts
  std::vector<SoilContact> against;               ///< each of Case::soils
  std::string path = {};                          ///< of its table in messages, "structure[0]"
};

/// [[section]]: cuts through an elastic structure, whose section forces are recorded.
struct Section {
  /// A line across the structure, which it cuts where it goes through it.
  struct Line {
    Point from;
    Point to;
  };
  std::string name;
  std::optional<std::size_t> structure; ///< index into Case::structures
  std::vector<Line> lines;              ///< one, or those of a ring, counter-clockwise
  std::optional<Point> centre;          ///< of the ring
  std::string path = {};                ///< of its table in messages, "section[0]"
};

/// [[prop]]: a spring between two structures, or between a structure and the ground.
struct Prop {
  struct End {
    std::string structure; ///< its name; empty: the ground
    Point position;
  };
  std::string name;
  End from;
  End to;
  double stiffness = 0.0;          ///< N/m2
  std::optional<double> prestress; ///< N/m, tension positive; none: it comes without a force
  std::optional<double> yield;     ///< N/m; none: elastic
  mpm_domain::Bears bears = mpm_domain::Bears::both;
  std::string path = {}; ///< of its table in messages, "prop[0]"
};

/// [[lining]]: a closed beam that keeps a cavity in the soil open.
struct Lining {
  std::string name;
  Outline outline;                  ///< that the soil touches
  double thickness = 0.0;           ///< m
  mpm_domain::BeamSection section;  ///< per metre out of plane
  std::vector<Point> hinges;        ///< about where; plan/lining/beam_outline.hpp has the corners
  std::vector<SoilContact> against; ///< each of Case::soils
  std::string path = {};            ///< of its table in messages, "lining[0]"
};

} // namespace tremolo::scene
