#pragma once

// Flat ground beside a free field of its own discretisation, without processes.

#include "mpm_domain/column/periodic_column.hpp"
#include "mpm_domain/gravity/static_traction.hpp"

#include <algorithm>
#include <memory>
#include <span>
#include <utility>

namespace tremolo::test_support {

/// A flat domain at rest under its weight, and the column that all its faces take their free field from.
struct FlatGround {
  mpm_domain::PeriodicColumn column;
  mpm_domain::Domain domain;
  std::unique_ptr<mpm_domain::Stepper> stepper;

  /// @param spec  with a step; its sides carry faces
  FlatGround(const mpm_domain::Spec& spec, const materials::Elasticity& rock, mpm_domain::IncidentWave wave)
      : column(own_column(spec, rock, std::move(wave))), domain(spec) {
    replace_constraints(domain, relax_under_gravity(domain, {}, [](long, double) {}));
    for (mpm_domain::BoundaryFace& face : domain.boundary.faces())
      if (face.side == mpm_domain::Side::base) {
        face.ground.impedance_p = rock.density * rock.p_wave_speed();
        face.ground.impedance_s = rock.density * rock.s_wave_speed();
      }
    stepper = std::make_unique<mpm_domain::Stepper>(
        domain, 0.0, [this](long step, double, auto, std::span<eq6::FreeField> field) {
          if (step > 0)
            column.step();
          for (std::size_t f = 0; f < field.size(); ++f)
            field[f] = served(domain.boundary.faces()[f]);
        });
  }

  FlatGround(const FlatGround&) = delete;
  FlatGround& operator=(const FlatGround&) = delete;

private:
  static mpm_domain::PeriodicColumnSpec own_column(mpm_domain::Spec spec, const materials::Elasticity& rock,
                                                   mpm_domain::IncidentWave wave) {
    const double dt = *spec.scheme.dt;
    spec.springs.clear();
    spec.box.x_max = spec.box.x_min + spec.cell_size;
    return {std::move(spec), rock, std::move(wave), 0.0, dt};
  }

  eq6::FreeField served(const mpm_domain::BoundaryFace& face) const {
    const double y = face.side == mpm_domain::Side::base ? domain.spec.box.y_min : face.position.y;
    const auto level = std::ranges::lower_bound(column.levels(), y - 1e-6) - column.levels().begin();
    const mpm_domain::ColumnPoint& point = column.points()[static_cast<std::size_t>(level)];
    return {point.velocity, point.stress};
  }
};

} // namespace tremolo::test_support
