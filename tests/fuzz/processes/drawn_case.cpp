#include "drawn_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <stdexcept>

namespace tremolo::testing {

namespace {

using Texts = std::map<std::string_view, std::string_view>;

const Texts laws = {
    {"linear", "model = \"linear_elastic\"\nyoung = 60e6\npoisson = 0.3\n"},
    {"mohr_coulomb", "model = \"mohr_coulomb\"\nyoung = 60e6\npoisson = 0.3\ncohesion_peak = 8e3\n"
                     "cohesion_residual = 2e3\nfriction_peak_deg = 38.0\nfriction_residual_deg = 30.0\n"
                     "softening = 10.0\nreference_size = 1.0\n"},
    {"drucker_prager", "model = \"drucker_prager\"\nyoung = 60e6\npoisson = 0.3\ncohesion = 8e3\n"
                       "friction_deg = 35.0\n"},
    {"multi_yield_clay", "model = \"multi_yield_clay\"\nyoung = 60e6\npoisson = 0.45\n"
                         "undrained_strength = 60e3\n"},
    {"hyperbolic", "model = \"hyperbolic\"\nvs = 120.0\nvp = 250.0\nreference_strain = 1e-3\n"},
    {"mkz", "model = \"mkz\"\nvs = 120.0\nvp = 250.0\nreference_strain = 1e-3\nbeta = 1.0\nexponent = 0.9\n"
            "unloading = \"mrdf\"\n"},
    {"gqh", "model = \"gqh\"\nvs = 120.0\nvp = 250.0\ncurve = \"darendeli\"\nplasticity_index = 20\n"
            "mean_stress = 40e3\nshear_strength = 30e3\n"},
    {"pm4sand", "model = \"pm4sand\"\nrelative_density = 0.55\nshear_modulus_coefficient = 677.0\n"
                "contraction_rate = 0.4\n"},
    {"pdmy03", "model = \"pdmy03\"\nrelative_density = 0.57\n"},
};

constexpr std::string_view rock = "density = 2200.0\nvs = 500.0\nvp = 1000.0\n";
constexpr std::string_view own_layer = "density = 1900.0\nvs = 180.0\nvp = 400.0\n";

/// The words of a value: what depends on another choice stands behind it in one value.
bool has_word(std::string_view value, std::string_view word) {
  return fmt::format(" {} ", value).find(fmt::format(" {} ", word)) != std::string::npos;
}

std::string_view first_word(std::string_view value) {
  return value.substr(0, value.find(' '));
}

/// The base of the layers, m.
double top_of_rock(std::string_view profile) {
  if (profile == "none")
    return 0.0;
  return profile == "shallow" ? -2.0 : profile == "deep" ? -6.0 : -4.0;
}

class Text {
public:
  explicit Text(const Draw& draw) : draw_(draw) {}

  std::string ground() const;
  std::string domain() const;

private:
  std::string_view value(std::string_view factor) const { return drawn(draw_, factor); }
  bool is(std::string_view factor, std::string_view word) const { return value(factor) == word; }
  bool has(std::string_view factor, std::string_view word) const { return has_word(value(factor), word); }
  bool on_table() const { return is("base", "shaking_table"); }

  std::string motion() const;
  std::string damping() const;
  std::string soil() const;
  std::string layer(std::string_view table, double thickness, bool own) const;
  std::string profile() const;
  std::string numerics() const;
  std::string gravity() const;
  std::string mesh() const;
  std::string boundary() const;
  std::string structures() const;
  std::string region() const;

  const Draw& draw_;
};

std::string Text::motion() const {
  std::string text = "[motion]\n";
  if (is("motion", "pulse"))
    text += "pulse = { shape = \"ricker\", frequency = 4.0, time = 0.3, velocity = 0.02 }\n";
  else if (is("motion", "pulse, within"))
    text +=
        "kind = \"within\"\npulse = { shape = \"ricker\", frequency = 4.0, time = 0.3, velocity = 0.02 }\n";
  else
    text += fmt::format("file = \"record.csv\"\nkind = \"{}\"\n", value("motion"));
  const auto reference = value("reference");
  const double level = reference == "deep"        ? -20.0
                       : reference == "in layers" ? -1.0
                                                  : top_of_rock(value("profile"));
  return text + fmt::format("wave = \"{}\"\nangle_deg = {}\nreference = [0.0, {}]\n", value("wave"),
                            value("angle"), level);
}

std::string Text::damping() const {
  std::string text;
  const auto model = first_word(value("damping"));
  if (model != "none")
    text += fmt::format("[damping]\nmodel = \"{}\"\n", model);
  if (has("damping", "all"))
    text += "ratio = 0.03\n";
  if (model == "rayleigh")
    text += "frequencies = [1.0, 8.0]\n";
  else if (model != "none" && !has("damping", "timeless"))
    text += "reference_hz = 3.0\n";
  return text;
}

std::string Text::soil() const {
  std::string text = "[soil.ground]\n" + std::string(laws.at(value("law")));
  const bool wet = !is("water", "none");
  if (!wet || has("water", "poreless"))
    text += "density = 1800.0\n";
  if (has("damping", "soil"))
    text += "damping = 0.04\n";
  if (is("K0", "given"))
    text += "rest_coefficient = 0.55\n";
  if (wet && !has("water", "poreless")) {
    if (!is("law", "pm4sand"))
      text += "porosity = 0.42\n";
    const auto drainage = value("water").substr(value("water").find(' ') + 1);
    text += fmt::format("permeability = 1e-4\ndrainage = \"{}\"\n", drainage);
  }
  return text;
}

std::string Text::layer(std::string_view table, double thickness, bool own) const {
  return fmt::format("[[{}]]\nthickness = {}\n{}{}", table, thickness,
                     own ? own_layer : "soil = \"ground\"\n",
                     own && has("damping", "layer") ? "damping = 0.04\n" : "");
}

std::string Text::profile() const {
  const auto what = value("profile");
  if (what == "none")
    return {};
  if (what == "two")
    return layer("profile", 2.0, false) + layer("profile", 2.0, true);
  return layer("profile", -top_of_rock(what), what == "own");
}

std::string Text::numerics() const {
  std::string text = "[fe]\nelement_size = 0.5\n";
  for (const std::string_view step : {"1e-4", "0.5"})
    if (has("left", step))
      text += fmt::format("dt = {}\n", step);
  text += "[ode]\ncell_size = 0.5\n";
  for (const std::string_view method : {"adams", "bdf", "imex"})
    if (has("left", method))
      text += fmt::format("method = \"{}\"\n", method);
  return text;
}

std::string Text::gravity() const {
  return is("gravity", "none") ? "" : "[[stage]]\nkind = \"gravity\"\nresidual = 1e-6\n";
}

std::string Text::ground() const {
  std::string text = "title = \"drawn\"\n" + motion();
  if (!on_table())
    text += fmt::format("[surface]\nlevel = 0.0\n[halfspace]\n{}{}", rock,
                        has("damping", "half-space") ? "damping = 0.01\n" : "");
  text += damping();
  if (!is("water", "none"))
    text += fmt::format("[water]\nlevel = {}\n", first_word(value("water")));
  return text + soil() + (on_table() ? "" : profile()) + numerics() + gravity();
}

std::string Text::mesh() const {
  const auto levels = value("levels");
  std::string text = fmt::format(
      "[mesh]\nsize = 1.0\nbox = [0.0, -4.0, 8.0, 0.0]\nparticles_per_cell = {}\nlayer_cells = 4\n"
      "particle_boxes = \"{}\"\ndilatation = \"{}\"\ndispersion = \"{}\"\ncontact_normals = \"{}\"\n",
      value("particles"), value("boxes"), value("dilatation"), value("dispersion"), value("normals"));
  const auto refine = [](std::string_view box, int level) {
    return fmt::format("[[refine]]\nbox = [{}]\nlevel = {}\n", box, level);
  };
  if (levels == "surface")
    text += refine("0.1, -1.9, 7.9, -0.1", 1);
  else if (levels == "left")
    text += refine("0.1, -3.9, 0.9, -0.1", 1);
  else if (levels == "two")
    text += refine("2.1, -1.9, 5.9, 1.9", 2);
  return text + fmt::format("[time]\ntransfer = \"{}\"\norder = \"{}\"\nsubcycle = {}\n{}", value("transfer"),
                            value("order"), value("subcycle"), value("step") == "own" ? "" : "dt = 1e-4\n");
}

std::string Text::boundary() const {
  const auto absorber = value("absorber");
  const std::string at_sides =
      absorber == "matched sides" || absorber == "matched" ? "absorber = \"matched_layer\"\n" : "";
  const std::string at_base =
      absorber == "matched base" || absorber == "matched" ? "absorber = \"matched_layer\"\n" : "";
  const auto as_left = [&](std::string_view model) {
    return first_word(model == "as left" ? value("left") : model);
  };
  const auto springs = value("springs");
  const bool everywhere = springs == "none" || springs == "stiff";
  const std::string_view at_face = springs == "own"      ? ""
                                   : springs == "none"   ? "spring = false\n"
                                   : springs == "centre" ? "spring_centre = [4.0, -1.0]\n"
                                                         : "spring = [2.0, 1.0]\n";
  std::string text = fmt::format("[boundary]\nsides = \"{}\"\n", value("sides"));
  if (is("sides", "free_field")) {
    text += fmt::format("[boundary.left]\nmodel = \"{}\"\n{}{}", first_word(value("left")), at_sides,
                        everywhere ? at_face : "");
    if (is("profile", "left's own"))
      text += layer("boundary.left.profile", 1.5, false) + layer("boundary.left.profile", 2.5, true);
    text += fmt::format("[boundary.right]\nmodel = \"{}\"\n{}{}{}", as_left(value("right")), at_sides,
                        everywhere ? at_face : "", is("surface", "lower right") ? "surface = -1.0\n" : "");
  }
  text += fmt::format("[boundary.base]\nmodel = \"{}\"\n", as_left(value("base")));
  if (!on_table())
    text += fmt::format("form = \"{}\"\n{}{}", value("form"), at_base, at_face);
  return text;
}

std::string Text::region() const {
  const bool lower = is("surface", "lower right");
  return fmt::format("[[region]]\nsoil = \"ground\"\npolygon = [[0.0, -4.0], [8.0, -4.0], {}[0.0, 0.0]]\n",
                     lower ? "[8.0, -1.0], [6.0, -1.0], [4.0, 0.0], " : "[8.0, 0.0], ");
}

std::string Text::structures() const {
  const auto what = value("structure");
  if (what == "none")
    return {};
  const bool buried = what == "buried";
  const std::string_view outline = buried ? "[[3.0, -2.0], [5.0, -2.0], [5.0, 0.0], [3.0, 0.0]]"
                                          : "[[3.0, 0.0], [5.0, 0.0], [5.0, 2.0], [3.0, 2.0]]";
  return fmt::format("[[structure]]\nname = \"block\"\npolygon = {}\ndensity = 1000.0\nfriction = 0.5\n{}",
                     outline, what == "elastic" ? "young = 1e7\npoisson = 0.2\n" : "rigid = true\n");
}

std::string Text::domain() const {
  return mesh() + boundary() + region() + structures() + "[[stage]]\nkind = \"shaking\"\nduration_s = 0.4\n";
}

} // namespace

const std::vector<Factor>& factors() {
  static const std::vector<Factor> all = {
      {"left", {"wave", "fe", "fe 1e-4", "fe 0.5", "ode", "ode adams", "ode bdf", "ode imex", "eql", "mpm"}},
      {"right", {"as left", "wave", "fe", "ode", "eql", "mpm"}},
      {"base", {"as left", "wave", "fe", "ode", "eql", "mpm", "shaking_table"}},
      {"form", {"blended", "total", "incident"}},
      {"sides", {"free_field", "periodic", "periodic_springs", "container"}},
      {"absorber", {"dashpots", "matched sides", "matched base", "matched"}},
      {"springs", {"own", "none", "stiff", "stiff base", "centre"}},
      {"damping",
       {"none", "none soil", "none layer", "rayleigh all", "rayleigh soil", "rayleigh half-space",
        "kelvin_voigt soil", "kelvin_voigt layer", "kelvin_voigt soil timeless", "hysteretic all",
        "hysteretic soil timeless", "shake half-space", "shake layer timeless", "kjartansson soil",
        "constant all", "constant soil"}},
      {"motion", {"pulse", "pulse, within", "incident", "outcrop", "within"}},
      {"wave", {"SV", "P"}},
      {"angle", {"0.0", "10.0", "25.0", "50.0"}},
      {"reference", {"top of rock", "deep", "in layers"}},
      {"profile", {"one", "none", "two", "own", "deep", "shallow", "left's own"}},
      {"law",
       {"linear", "mohr_coulomb", "drucker_prager", "multi_yield_clay", "hyperbolic", "mkz", "gqh", "pm4sand",
        "pdmy03"}},
      {"K0", {"elastic", "given"}},
      {"water",
       {"none", "0.0 coupled", "-2.0 coupled", "-1.3 undrained", "0.0 drained", "1.0 coupled",
        "-50.0 coupled", "-1.3 drained", "0.0 undrained", "0.0 poreless"}},
      {"gravity", {"9.81", "none"}},
      {"levels", {"none", "surface", "left", "two"}},
      {"subcycle", {"false", "true"}},
      {"transfer", {"apic", "flip"}},
      {"order", {"musl", "usl"}},
      {"particles", {"2", "1", "3", "4"}},
      {"boxes", {"fixed", "deforming"}},
      {"dilatation", {"cell", "particle"}},
      {"dispersion", {"plain", "reduced"}},
      {"normals", {"automatic", "gradient", "polygon"}},
      {"structure", {"none", "block", "buried", "elastic"}},
      {"surface", {"level", "lower right"}},
      {"step", {"own", "1e-4"}},
  };
  return all;
}

std::string_view drawn(const Draw& draw, std::string_view factor) {
  const auto& all = factors();
  const auto found = std::ranges::find(all, factor, &Factor::name);
  if (found == all.end())
    throw std::logic_error(fmt::format("no factor '{}'", factor));
  return found->values[draw[static_cast<std::size_t>(found - all.begin())]];
}

std::string described(const Draw& draw) {
  std::string text;
  for (std::size_t f = 0; f < draw.size(); ++f)
    if (draw[f] != 0)
      text +=
          fmt::format("{}{} {}", text.empty() ? "" : ", ", factors()[f].name, factors()[f].values[draw[f]]);
  return text.empty() ? "the plain case" : text;
}

std::string case_text(const Draw& draw) {
  const Text text(draw);
  return text.ground() + text.domain();
}

std::string column_text(const Draw& draw) {
  return Text(draw).ground();
}

void write_record(const std::filesystem::path& folder) {
  std::ofstream file(folder / "record.csv");
  file << "time (s), acceleration (m/s2)\n";
  for (int i = 0; i <= 50; ++i) {
    const double t = 0.01 * i;
    const double window = std::pow(std::sin(2.0 * std::numbers::pi * t), 2);
    file << fmt::format("{:.2f}, {:.6f}\n", t, window * std::sin(12.0 * std::numbers::pi * (t - 0.25)));
  }
}

} // namespace tremolo::testing
