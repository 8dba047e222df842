#include "scene/keys_model.hpp"

#include "scene/keys_elastic.hpp"

namespace tremolo::scene {

namespace {

/// Of soils with a backbone.
Key backbone(std::string_view name, std::vector<std::string_view> models, std::string_view meaning,
             Range range) {
  return {.name = name,
          .unit = "1",
          .meaning = meaning,
          .otherwise = "fitted to `curve`",
          .range = range,
          .when = {"model", std::move(models)}};
}

/// Of the built-in curves.
Key darendeli(std::string_view name, std::string_view unit, std::string_view meaning,
              std::string_view fallback, Range range) {
  return {.name = name,
          .unit = unit,
          .meaning = meaning,
          .required = fallback.empty(),
          .fallback = fallback,
          .range = range,
          .when = {"curve", {"darendeli"}}};
}

Condition mohr_coulomb() {
  return {"model", {"mohr_coulomb"}};
}

Key strength(std::string_view name, std::string_view unit, std::string_view meaning, Range range,
             std::string_view fallback = {}) {
  return {.name = name,
          .unit = unit,
          .meaning = meaning,
          .required = fallback.empty(),
          .fallback = fallback,
          .range = range,
          .when = mohr_coulomb()};
}

std::vector<Key> hysteretic_keys() {
  const std::vector<std::string_view> both = {"hyperbolic", "mkz"};
  return {
      {.name = "curve",
       .type = Type::text,
       .meaning = "G/G0 and damping against shear strain, to which the backbone is fitted and which `eql` "
                  "takes as they "
                  "are: `darendeli` (2001), or the name of a table `strain,modulus_reduction,damping`, "
                  "relative to the "
                  "case file.",
       .otherwise = "the backbone given",
       .when = {"model", {"mkz"}}},
      backbone("reference_strain", both, "Shear strain of the backbone, engineering.", positive),
      backbone("beta", {"mkz"}, "Factor of the backbone.", positive),
      backbone("exponent", {"mkz"}, "Exponent of the backbone.", {.low = 0.1, .high = 1.0}),
      darendeli("plasticity_index", "%", "Plasticity index.", "", not_negative),
      darendeli("overconsolidation_ratio", "1", "Overconsolidation ratio.", "1", {.low = 1.0}),
      darendeli("mean_stress", "Pa", "Mean effective confining stress.", "", {.low = 100.0, .high = 1e8}),
      darendeli("excitation_hz", "Hz", "Frequency of loading.", "1", positive),
      darendeli("cycles", "1", "Number of cycles of loading.", "10", {.low = 1.0}),
  };
}

Table soil() {
  constexpr Range angle = {.low = 0.0, .high = 90.0, .high_open = true};
  auto keys = with_elastic_keys({
      strength("cohesion_peak", "Pa", "Cohesion before softening.", not_negative),
      strength("cohesion_residual", "Pa", "Cohesion after softening, at most the peak.", not_negative),
      strength("friction_peak_deg", "degrees", "Friction angle before softening.", angle),
      strength("friction_residual_deg", "degrees", "Friction angle after softening, at most the peak.",
               angle),
      strength("dilation_peak_deg", "degrees", "Dilation angle before softening, at most the friction angle.",
               angle, "0"),
      strength("dilation_residual_deg", "degrees", "Dilation angle after softening.", angle, "0"),
      strength(
          "softening", "1",
          "Softening coefficient eta: c and the angles decay from peak to residual with exp(-eta e), e the "
          "equivalent plastic deviatoric strain. 0 keeps the peak.",
          not_negative),
      {.name = "tension_cutoff",
       .unit = "Pa",
       .meaning = "Largest tensile stress.",
       .otherwise = "the apex c cot(phi)",
       .range = not_negative,
       .when = mohr_coulomb()},
      {.name = "reference_size",
       .unit = "m",
       .meaning = "Cell size h_ref for which `softening` holds: eta is scaled by h/h_ref, so that the work "
                  "of a shear band "
                  "does not depend on the mesh.",
       .otherwise = "no scaling",
       .range = positive,
       .when = mohr_coulomb()},
  });
  for (Key& key : hysteretic_keys())
    keys.push_back(std::move(key));
  keys.insert(keys.begin(),
              choice("model", {"linear_elastic", "mohr_coulomb", "hyperbolic", "mkz"},
                     "Constitutive law. `hyperbolic` and `mkz`: hysteretic soil by the extended Masing "
                     "rules, G/G0 = 1/(1 + beta (gamma/reference_strain)^exponent)."));
  return {.name = "soil",
          .kind = Kind::named,
          .required = true,
          .meaning = "A soil of the domain. Either `young` and `poisson`, or `vs` and `vp`.",
          .keys = std::move(keys)};
}

Table time() {
  return {
      .name = "time",
      .meaning = "Time stepping of the domain.",
      .keys = {
          {.name = "fraction",
           .unit = "1",
           .meaning = "Time step as a fraction of the critical step 0.65 h/c_p.",
           .fallback = "0.5",
           .range = {.low = 0.0, .high = 1.0, .low_open = true}},
          {.name = "dt",
           .unit = "s",
           .meaning = "A fixed time step instead of `fraction`, at most the critical step.",
           .otherwise = "from `fraction`",
           .range = positive},
          choice("transfer", {"apic", "flip", "pic_blend"},
                 "How velocity travels between particles and grid: affine particle-in-cell, FLIP, or FLIP "
                 "blended with PIC.",
                 "apic"),
          {.name = "blend_time",
           .unit = "s",
           .meaning =
               "Time constant tau of the blend: the difference to PIC decays with exp(-t/tau), whatever the "
               "time step.",
           .required = true,
           .range = positive,
           .when = {"transfer", {"pic_blend"}}},
          choice("order", {"usl", "usf", "musl"},
                 "When stress is updated in a step: last, first, or last with "
                 "remapped velocity.",
                 "musl")}};
}

Table stage() {
  return {
      .name = "stage",
      .kind = Kind::array,
      .required = true,
      .meaning = "The stages in their order: at most one of gravity, then one of shaking. Without a gravity "
                 "stage the "
                 "model is weightless.",
      .keys = {
          choice(
              "kind", {"gravity", "shaking"},
              "`gravity`: base fixed, sides on rollers, brought to rest by damped relaxation; what held the "
              "model then acts as static traction. `shaking`: the motion enters, t = 0 at its start."),
          {.name = "acceleration",
           .unit = "m/s2",
           .meaning = "Gravity, downwards.",
           .fallback = "9.81",
           .range = positive,
           .when = {"kind", {"gravity"}}},
          {.name = "residual",
           .unit = "1",
           .meaning = "Unbalanced nodal forces at rest, relative to the nodal weights (2-norms).",
           .fallback = "1e-9",
           .range = {.low = 1e-12, .high = 0.1},
           .when = {"kind", {"gravity"}}},
          {.name = "max_time_s",
           .unit = "s",
           .meaning = "Simulated time within which rest must be reached.",
           .fallback = "60",
           .range = {.low = 0.0, .high = 1e4, .low_open = true},
           .when = {"kind", {"gravity"}}},
          {.name = "duration_s",
           .unit = "s",
           .meaning = "Length of the shaking.",
           .required = true,
           .range = {.low = 0.0, .high = 1e4, .low_open = true},
           .when = {"kind", {"shaking"}}}}};
}

} // namespace

std::vector<Table> model_keys() {
  return {
      soil(),
      {.name = "region",
       .kind = Kind::array,
       .required = true,
       .meaning = "A polygon filled with one soil. Polygons may touch but not overlap.",
       .keys = {{.name = "soil", .type = Type::text, .meaning = "Name of a `[soil.NAME]`.", .required = true},
                {.name = "polygon",
                 .type = Type::polygon,
                 .unit = "m",
                 .meaning = "Corners in either sense of rotation, inside the box of the mesh.",
                 .required = true}}},
      {.name = "mesh",
       .required = true,
       .meaning = "Background grid and particles.",
       .keys = {{.name = "size", .unit = "m", .meaning = "Cell size h.", .required = true, .range = positive},
                {.name = "box",
                 .type = Type::numbers,
                 .unit = "m",
                 .meaning =
                     "The model; its left, right and lower edges are the boundaries. Its width is a multiple "
                     "of `size`, its height of the particle spacing. The grid is padded beyond it by itself.",
                 .required = true,
                 .count = 4,
                 .form = "[x_min, y_min, x_max, y_max]"},
                {.name = "particles_per_cell",
                 .type = Type::integer,
                 .unit = "1",
                 .meaning = "Particles per cell in each direction.",
                 .fallback = "2",
                 .range = {.low = 1.0, .high = 4.0}}}},
      time(),
      stage(),
  };
}

} // namespace tremolo::scene
