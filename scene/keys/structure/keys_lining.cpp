#include "scene/keys/structure/keys_structure.hpp"

#include "scene/keys/soil/keys_elastic.hpp"

namespace tremolo::scene {

namespace {

/// The section of the beam: of a plate, or as stiffnesses.
std::vector<Key> beam_keys() {
  return {{.name = "young",
           .unit = "Pa",
           .meaning = "Young's modulus of a plate of this thickness; together with `poisson` and `density`.",
           .otherwise = "`axial_stiffness`, `bending_stiffness` and `mass`",
           .range = above_zero},
          {.name = "poisson",
           .unit = "1",
           .meaning = "Poisson's ratio of the plate, which bends in plane strain.",
           .otherwise = "with `young`",
           .range = {.low = -1.0, .high = 0.5, .low_open = true, .high_open = true}},
          {.name = "density",
           .unit = "kg/m3",
           .meaning = "Mass of the plate by volume.",
           .otherwise = "with `young`",
           .range = above_zero},
          {.name = "axial_stiffness",
           .unit = "N/m",
           .meaning = "EA per metre out of plane, of any section; together with `bending_stiffness` and "
                      "`mass`. Such a lining does not shear.",
           .otherwise = "`young`, `poisson` and `density`",
           .range = above_zero},
          {.name = "bending_stiffness",
           .unit = "N m",
           .meaning = "EI per metre out of plane.",
           .otherwise = "with `axial_stiffness`",
           .range = above_zero},
          {.name = "mass",
           .unit = "kg/m2",
           .meaning = "Mass by area of the lining.",
           .otherwise = "with `axial_stiffness`",
           .range = above_zero}};
}

} // namespace

std::vector<Table> lining_keys() {
  Table lining{
      .name = "lining",
      .kind = Kind::array,
      .meaning = "A tunnel's lining or a box culvert: a closed beam that keeps a cavity in the soil open and "
                 "deforms with it, see docs/linings.md. It replaces the soil of the regions that it covers, "
                 "and what is within is empty.",
      .keys = {{.name = "name", .type = Type::text, .meaning = "Its name in results.", .required = true},
               {.name = "polygon",
                .type = Type::polygon,
                .unit = "m",
                .meaning = "Corners of its outer face, which the soil touches, in either sense of rotation: "
                           "four of a box culvert. It lies in soil on all sides, at least two cells inside "
                           "the sides and the base of the mesh's box.",
                .otherwise = "`circle`"},
               {.name = "thickness",
                .unit = "m",
                .meaning = "From the outer to the inner face. The axis of the beam lies half of it behind "
                           "the outer face.",
                .required = true,
                .range = above_zero}}};
  for (const Key& key : beam_keys())
    lining.keys.push_back(key);
  lining.keys.push_back({.name = "hinges",
                         .type = Type::points,
                         .unit = "m",
                         .meaning = "Points on the lining where no moment passes, such as joints between "
                                    "segments.",
                         .otherwise = "none"});
  lining.keys.push_back({.name = "friction",
                         .unit = "1",
                         .meaning = "Coefficient of friction of its outer face against all soils; 0: full "
                                    "slip.",
                         .required = true,
                         .range = from_zero});
  lining.keys.push_back({.name = "adhesion",
                         .unit = "Pa",
                         .meaning = "Shear stress that its outer face bears besides friction.",
                         .fallback = "0",
                         .range = from_zero});
  return {std::move(lining),
          circle_table("lining.circle",
                       "The outer face as a circle, `circle = { centre = [x, y], radius = r }` instead of "
                       "`polygon`: a polygon of 64 corners with the same area."),
          against_table("lining.against",
                        "A soil against which the lining has a friction or an adhesion of its own, as in "
                        "`against = [{ soil = \"clay\", friction = 0.3, adhesion = 5e3 }]`.")};
}

} // namespace tremolo::scene
