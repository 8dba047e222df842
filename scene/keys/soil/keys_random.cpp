#include "scene/keys/soil/keys_random.hpp"

#include "scene/choices.hpp"
#include "scene/keys/soil/keys_elastic.hpp"

namespace tremolo::scene {

namespace {

/// A parameter of Toro's model; a class of sites has all of them.
Key parameter(std::string_view name, std::string_view unit, std::string_view meaning, Range range) {
  return {.name = name,
          .unit = unit,
          .meaning = meaning,
          .otherwise = "that of the `site_class`; needed without one",
          .range = range};
}

Key stream(std::string_view name, std::string_view meaning) {
  return {.name = name,
          .type = Type::integer,
          .unit = "1",
          .meaning = meaning,
          .fallback = "1",
          .range = {.low = 0.0, .high = 1e9}};
}

constexpr Range share = {.low = 0.0, .high = 1.0};

} // namespace

Table random_profile_keys() {
  auto site_class =
      choice("site_class", all_words<ToroClass>(),
             "Whose parameters hold where none is given. `geomatrix_ab`: rock and shallow soil; "
             "`geomatrix_cd`: deep soil; `usgs_a` to `usgs_d`: Vs30 above 750, 360 to 750, 180 "
             "to 360, below 180 m/s; `usgs_ab` and `usgs_cd`: above and below 360 m/s.");
  site_class.required = false;
  site_class.otherwise = "each parameter is given";
  return {
      .name = "random_profile",
      .meaning = "Vs of the layers of `[[profile]]` is one of many that the site may have (Toro 1995): times "
                 "exp(`sigma_ln` Z), Z normal, within two standard deviations, and correlated from layer to "
                 "layer; see docs/free-fields/random-profiles.md. Densities, damping, curves over strain and "
                 "strengths that are given stay, and so does the half-space.",
      .keys = {
          std::move(site_class),
          parameter("sigma_ln", "1", "Standard deviation of ln Vs.", share),
          parameter("rho_0", "1", "Correlation of layers at one place, apart from that of depth.", share),
          parameter("delta", "m", "Distance over which it falls to 1/e.", above_zero),
          parameter("rho_200", "1", "Correlation of layers at 200 m depth and below, however far apart.",
                    share),
          parameter("h_0", "m", "Depth that is added, of the correlation's growth with depth.", from_zero),
          parameter("b", "1", "Power of the correlation's growth with depth.", from_zero),
          {.name = "layer_thickness",
           .unit = "m",
           .meaning = "Thicker layers are cut into equal parts, each with a Vs of its own.",
           .fallback = "5",
           .range = above_zero},
          stream("seed", "It begins the random numbers; equal seeds give equal profiles."),
          stream("realisation", "Which of the profiles of a seed this one is."),
      }};
}

} // namespace tremolo::scene
