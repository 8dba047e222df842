#include "scene/keys/structure/keys_structure.hpp"

#include "scene/keys/soil/keys_elastic.hpp"

namespace tremolo::scene {

namespace {

Key end_of_cut(std::string_view name, std::string_view meaning) {
  return {.name = name,
          .type = Type::numbers,
          .unit = "m",
          .meaning = meaning,
          .otherwise = "`ring`",
          .count = 2,
          .form = "[x, y]"};
}

} // namespace

std::vector<Table> section_keys() {
  return {
      {.name = "section",
       .kind = Kind::array,
       .meaning = "A cut through an elastic structure, or a ring of cuts, whose axial force, shear force and "
                  "moment are recorded, see docs/structures.md. It moves and turns with the structure.",
       .keys = {{.name = "name", .type = Type::text, .meaning = "Its name in results.", .required = true},
                {.name = "structure",
                 .type = Type::text,
                 .meaning = "Name of the elastic `[[structure]]` that it cuts.",
                 .required = true},
                end_of_cut("from",
                           "One end of a line across the structure, on its surface or outside of it."),
                end_of_cut("to", "The other end; a moment is positive where it stretches this side.")}},
      {.name = "section.ring",
       .meaning = "Cuts all around a hole, for diagrams: `ring = { centre = [x, y], inner = a, outer = b, "
                  "count = n }` instead of `from` and `to`. They go outwards, the first one in the direction "
                  "of x, the others counter-clockwise.",
       .keys = {{.name = "centre",
                 .type = Type::numbers,
                 .unit = "m",
                 .meaning = "Where the lines of all cuts meet.",
                 .required = true,
                 .count = 2,
                 .form = "[x, y]"},
                {.name = "inner",
                 .unit = "m",
                 .meaning = "Radius at which the lines begin, in the hole or on its edge.",
                 .required = true,
                 .range = from_zero},
                {.name = "outer",
                 .unit = "m",
                 .meaning = "Radius at which they end, on the outline or outside of it.",
                 .required = true,
                 .range = above_zero},
                {.name = "count",
                 .type = Type::integer,
                 .unit = "1",
                 .meaning = "Number of cuts.",
                 .fallback = "36",
                 .range = {.low = 3.0, .high = 360.0}}}}};
}

} // namespace tremolo::scene
