#include "scene/plan/step/step_cost.hpp"

#include "materials/cost/update_cost.hpp"
#include "mesh/polygon_measures.hpp"
#include "scene/plan/output/output_size.hpp"
#include "scene/soils/domain_soils.hpp"

#include <algorithm>
#include <cmath>

namespace tremolo::scene::cost {

double law_ns(const Case& scene, materials::Response response) {
  double whole = 0.0;
  double sum = 0.0;
  for (const Region& region : scene.regions) {
    const auto soils = soils_of(region);
    const double area = std::abs(mesh::signed_double_area(region.polygon)) /
                        std::max<double>(1.0, static_cast<double>(soils.size()));
    for (const std::size_t s : soils) {
      const materials::Law& law = scene.soils[s].law;
      whole += area;
      if (materials::traits(law).response == response)
        sum += area * materials::update_cost_ns(law);
    }
  }
  return whole > 0.0 ? sum / whole : 0.0;
}

double boundary_ns(const Case& scene) {
  constexpr double face_ns = 1100.0;
  return face_ns * static_cast<double>(most_faces(scene));
}

} // namespace tremolo::scene::cost
