#include "scene/read/read.hpp"

namespace tremolo::scene {

void read_numerics(Document& document, Case& scene) {
  const auto fe = document.table("fe");
  scene.fe.element_size = fe.optional_number("element_size").value_or(0.5 * scene.mesh.size);
  scene.fe.dt = fe.optional_number("dt");

  const auto ode = document.table("ode");
  using enum OdeMethod;
  scene.ode = {ode.choice<OdeMethod>("method"), ode.number("relative_tolerance"),
               ode.number("absolute_tolerance"),
               ode.optional_number("cell_size").value_or(0.5 * scene.mesh.size)};

  const auto eql = document.table("eql");
  scene.eql = {eql.number("sublayer"), eql.number("strain_ratio"), eql.number("tolerance"),
               eql.integer("iterations"), eql.text("unconverged") == "allow"};
}

} // namespace tremolo::scene
