#include "mpm_domain/spec/prop.hpp"
#include "scene/keys/soil/keys_elastic.hpp"
#include "scene/keys/structure/keys_structure.hpp"

namespace tremolo::scene {

namespace {

Table end_of_prop(std::string_view name, std::string_view meaning) {
  return {.name = name,
          .meaning = meaning,
          .keys = {{.name = "structure",
                    .type = Type::text,
                    .meaning = "Name of the `[[structure]]` that it is fastened to.",
                    .otherwise = "the ground"},
                   {.name = "at",
                    .type = Type::numbers,
                    .unit = "m",
                    .meaning = "Where: in the structure or on its surface, or in soil that stays.",
                    .required = true,
                    .count = 2,
                    .form = "[x, y]"}}};
}

} // namespace

std::vector<Table> prop_keys() {
  return {{.name = "prop",
           .kind = Kind::array,
           .meaning = "A prop or an anchor: a spring between two structures, or between a structure and a "
                      "point of the ground, whose force is recorded, see docs/props.md. "
                      "Forces count per metre out of plane, tension positive.",
           .keys = {{.name = "name",
                     .type = Type::text,
                     .meaning = "Its name in results, and by which construction stages place and remove it.",
                     .required = true},
                    {.name = "stiffness",
                     .unit = "N/m2",
                     .meaning = "Force per metre of lengthening and metre out of plane: E A/(L s) of bars of "
                                "section A and length L at a spacing s.",
                     .required = true,
                     .range = above_zero},
                    {.name = "prestress",
                     .unit = "N/m",
                     .meaning = "Its force at the end of the stage in which it comes; negative in a strut.",
                     .otherwise = "it comes without a force, and bears its part of what that stage brings"},
                    {.name = "yield",
                     .unit = "N/m",
                     .meaning = "Largest force, in tension and in compression; at it the prop yields.",
                     .otherwise = "it is elastic",
                     .range = above_zero},
                    choice<mpm_domain::Bears>(
                        "bears",
                        "The forces that it can have: an anchor goes slack where its ends come closer, and a "
                        "strut that only leans falls out where they part; both take hold again.",
                        mpm_domain::Bears::both)}},
          end_of_prop("prop.from", "One end, `from = { structure = \"west\", at = [x, y] }`."),
          end_of_prop("prop.to", "The other end; `to = { at = [x, y] }` lies in the ground.")};
}

} // namespace tremolo::scene
