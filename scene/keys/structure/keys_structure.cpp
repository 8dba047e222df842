#include "scene/keys/structure/keys_structure.hpp"

#include "scene/keys/soil/keys_elastic.hpp"

namespace tremolo::scene {

Table circle_table(std::string_view name, std::string_view meaning) {
  return {
      .name = name,
      .meaning = meaning,
      .keys = {
          {.name = "centre",
           .type = Type::numbers,
           .unit = "m",
           .meaning = "Its centre.",
           .required = true,
           .count = 2,
           .form = "[x, y]"},
          {.name = "radius", .unit = "m", .meaning = "Its radius.", .required = true, .range = above_zero}}};
}

Table against_table(std::string_view name, std::string_view meaning) {
  return {
      .name = name,
      .kind = Kind::array,
      .meaning = meaning,
      .keys = {{.name = "soil", .type = Type::text, .meaning = "Name of a `[soil.NAME]`.", .required = true},
               {.name = "friction",
                .unit = "1",
                .meaning = "Coefficient of friction against this soil.",
                .otherwise = "that of the whole surface",
                .range = from_zero},
               {.name = "adhesion",
                .unit = "Pa",
                .meaning = "Adhesion to this soil.",
                .otherwise = "that of the whole surface",
                .range = from_zero}}};
}

std::vector<Table> structure_keys() {
  return {
      {.name = "structure",
       .kind = Kind::array,
       .meaning = "A body that stands in or on the soil, see docs/structures.md. It replaces the soil of the "
                  "regions that it covers. Structures may touch but not overlap.",
       .keys = {{.name = "name", .type = Type::text, .meaning = "Its name in results.", .required = true},
                {.name = "polygon",
                 .type = Type::polygon,
                 .unit = "m",
                 .meaning = "Corners of its outline in either sense of rotation. It lies at least two cells "
                            "inside the sides and the base of the mesh's box, and may rise above its top.",
                 .otherwise = "`circle`"},
                {.name = "hole",
                 .type = Type::polygon,
                 .unit = "m",
                 .meaning = "Corners of its empty inside, as of a tunnel.",
                 .otherwise = "`hole_circle`, or solid"},
                {.name = "density",
                 .unit = "kg/m3",
                 .meaning = "Mass by volume of what lies between outline and hole: of a building with rooms, "
                            "the mean of all of it.",
                 .required = true,
                 .range = above_zero},
                {.name = "rigid",
                 .type = Type::boolean,
                 .meaning = "`true`: it keeps its shape, and moves by three degrees of freedom.",
                 .otherwise = "`young` and `poisson`"},
                {.name = "young",
                 .unit = "Pa",
                 .meaning =
                     "Young's modulus of an elastic structure; together with `poisson`. For a building "
                     "with rooms, that of a solid block with the building's natural period.",
                 .otherwise = "`rigid`",
                 .range = above_zero},
                {.name = "poisson",
                 .unit = "1",
                 .meaning = "Poisson's ratio of an elastic structure; together with `young`.",
                 .otherwise = "`rigid`",
                 .range = {.low = -1.0, .high = 0.5, .low_open = true, .high_open = true}},
                {.name = "friction",
                 .unit = "1",
                 .meaning =
                     "Coefficient of friction of its surface, the tangent of the angle of friction, "
                     "against all soils and other structures; of two structures the smaller one counts. "
                     "It acts with effective stress.",
                 .required = true,
                 .range = from_zero},
                {.name = "adhesion",
                 .unit = "Pa",
                 .meaning = "Shear stress that its surface bears besides friction.",
                 .fallback = "0",
                 .range = from_zero}}},
      circle_table("structure.circle",
                   "The outline as a circle, `circle = { centre = [x, y], radius = r }` instead "
                   "of `polygon`: a polygon of 64 corners with the same area."),
      circle_table("structure.hole_circle", "The empty inside as a circle, likewise instead of `hole`."),
      against_table("structure.against",
                    "A soil against which the structure has a friction or an adhesion of its own, as in "
                    "`against = [{ soil = \"clay\", friction = 0.3, adhesion = 5e3 }]`."),
  };
}

} // namespace tremolo::scene
