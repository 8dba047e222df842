#include "mpm_domain/gravity/gravity_stage.hpp"

#include "mpm_domain/gravity/construction.hpp"
#include "mpm_domain/gravity/relaxation.hpp"
#include "mpm_domain/particles/fill.hpp"
#include "mpm_domain/tiles/cell_means.hpp"
#include "mpm_domain/transfer/gather.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace tremolo::mpm_domain {

namespace {

/// Excess pressures are means of cells, and so is the stress that pore pressure ratios are taken over.
void keep_vertical_stress(Domain& domain) {
  const CellFinder finder = domain.mesh ? CellFinder(*domain.mesh) : CellFinder(domain.tiles, 0);
  const auto over_wet = [&](const auto& act) {
    for (Particles& set : domain.sets)
      for (std::size_t k = 0; set.traits.wet && k < set.size(); ++k)
        act(set, k, finder.at(set.x[k], set.y[k]).node);
  };
  clear_cells(domain);
  over_wet([&](const Particles& set, std::size_t k, std::size_t cell) {
    domain.grid.cell_weight[cell] += set.volume[k];
    domain.grid.cell_change[cell] += set.volume[k] * set.syy[k];
  });
  join_images_of_cells(domain);
  over_wet([&](Particles& set, std::size_t k, std::size_t cell) {
    set.vertical_at_rest[k] = mean_of_cell(domain.grid, cell);
  });
}

void add_cut(std::vector<CutStress>& cut, const std::string& soil, Vector at) {
  auto of = std::ranges::find(cut, soil, &CutStress::soil);
  if (of == cut.end())
    of = cut.insert(of, {soil, 0, at, at});
  ++of->particles;
  of->low = {std::min(of->low.x, at.x), std::min(of->low.y, at.y)};
  of->high = {std::max(of->high.x, at.x), std::max(of->high.y, at.y)};
}

/// The laws' memory begins with the stress under gravity, and with it the stiffness that the dashpots match.
/// @returns the soils whose law could not hold that stress
std::vector<CutStress> begin_history(Domain& domain) {
  std::vector<CutStress> cut;
  for (Particles& set : domain.sets) {
    const std::vector<double> before[] = {set.sxx, set.syy, set.sxy};
    materials::initialise(set.law, set.points(0, set.size()));
    for (std::size_t k = 0; k < set.size(); ++k) {
      const double change = std::abs(set.sxx[k] - before[0][k]) + std::abs(set.syy[k] - before[1][k]) +
                            std::abs(set.sxy[k] - before[2][k]);
      if (change > 1e-3 * (std::abs(before[0][k]) + std::abs(before[1][k])))
        add_cut(cut, set.soil, {set.x[k], set.y[k]});
    }
  }
  keep_vertical_stress(domain);
  domain.boundary.match(domain);
  return cut;
}

/// Bodies that move at least a hundredth as fast as the fastest: one that slides goes on under the damping,
/// while others only answer to what it does to the soil.
std::vector<std::size_t> moving_bodies(const Domain& domain) {
  std::vector<double> speeds;
  for (std::size_t b = 0; b < domain.contact.bodies().size(); ++b)
    speeds.push_back(domain.contact.speed(domain, b));
  const double fastest = std::ranges::max(speeds);
  std::vector<std::size_t> moving;
  for (std::size_t b = 0; b < speeds.size(); ++b)
    if (speeds[b] >= 0.01 * fastest)
      moving.push_back(b);
  return moving;
}

/// Relaxes once more with structures that may slide and part from the soil, so that the shaking begins
/// without a kick. If that finds no rest, the bonded state stays.
/// @param course  in which they have been bonded, and which ended at `rest`
/// @returns the bodies that move on
std::vector<std::size_t> release(Domain& domain, Relaxation& relaxation, const Course& course,
                                 const Relaxed& rest, const GravityProgress& progress) {
  constexpr long least =
      1000; // steps that friction may take to find its share, and as often those of the bonds
  const long steps = std::max(least, 4 * (rest.step - course.first));
  Course released = course;
  released.bonded = false;
  released.ramp = 0.0;
  released.first = rest.step;
  released.time = static_cast<double>(steps) * relaxation.step();
  const std::vector<Particles> bonded = domain.sets;
  std::vector<std::size_t> moving;
  if (!(relaxation.run(released, progress).residual < course.residual)) {
    moving = moving_bodies(domain);
    domain.sets = bonded;
    relaxation.find_forces();
  }
  domain.contact.end_rest();
  return moving;
}

/// The excess pressure that an undrained stage has left is gone.
void drain(Domain& domain) {
  for (Particles& set : domain.sets)
    if (set.traits.wet)
      set.pore_pressure = set.pressure_at_rest;
}

/// What a stage did not find, and what that may mean.
std::string not_at_rest(const std::string& what, const Relaxed& relaxed, double time, double residual,
                        const std::string& why) {
  return fmt::format("{}: residual {:.3g} after {:.3g} s of relaxation, wanted {:.3g}; {}", what,
                     relaxed.residual, time, residual, why);
}

/// The static stages of a run, one after the other.
class StaticStages {
public:
  StaticStages(Domain& end, std::span<const StaticStage> stages, const StageProgress& progress,
               const StageShown& ended)
      : end_(end), stages_(stages), progress_(progress), ended_(ended) {
    begin_model(0);
  }

  void gravity(const GravitySettings& settings) {
    set_rest_stress(model_->sets_of_soil(), model_->spec);
    relaxation_.emplace(*model_);
    act_with_loads(0);
    const Course course{
        .bonded = true, .time = settings.max_time, .residual = settings.residual, .skin = settings.skin};
    const Relaxed rest = run(course, "the gravity stage did not come to rest",
                             "the slope may not be stable under its weight, which tremolo safety finds out");
    end_bonds(course, rest);
    show();
  }

  void next() {
    ++stage_;
    std::visit([this](const auto& stage) { go(stage); }, stages_[stage_ - 1]);
    disturbed_ = settings_of(stages_[stage_ - 1]).undrained;
    show();
  }

  Reactions finish() {
    Reactions reactions = relaxation_->reactions();
    relaxation_->finish();
    reactions.slipping_bodies = slipping_;
    reactions.slipping = !slipping_.empty();
    reactions.cut = begin_history(*model_);
    reactions.ways = structure_ways();
    return reactions;
  }

private:
  static const StageSettings& settings_of(const StaticStage& stage) {
    return std::visit([](const auto& one) -> const StageSettings& { return one; }, stage);
  }

  void show() {
    if (ended_)
      relaxation_->show([this] { ended_(stage_, *model_); });
  }

  /// Ways of the structures of the present model, those in models before it included.
  std::vector<StructureWay> structure_ways() const {
    std::vector<StructureWay> ways = relaxation_->structure_ways();
    for (StructureWay& structure : ways)
      if (const auto found = std::ranges::find(ways_before_, structure.name, &StructureWay::name);
          found != ways_before_.end()) {
        structure.way = {structure.way.x + found->way.x, structure.way.y + found->way.y};
        structure.turn += found->turn;
      }
    return ways;
  }

  /// Makes the model of the stages from the given one on, up to the next construction.
  void begin_model(std::size_t first) {
    std::size_t loads = 0;
    for (std::size_t s = 0; s < stages_.size(); ++s) {
      if (s >= first)
        if (const auto* next = std::get_if<ConstructionSettings>(&stages_[s])) {
          Spec spec = end_.spec;
          spec.regions = next->regions;
          spec.structures = next->structures;
          spec.water = next->water;
          spec.loads.resize(loads);
          own_ = std::make_shared<Domain>(spec);
          model_ = own_.get();
          return;
        }
      loads += std::holds_alternative<LoadSettings>(stages_[s]) ? 1 : 0;
    }
    own_ = nullptr;
    model_ = &end_;
  }

  /// Lets the loads of the stages before one act, and those after it not.
  void act_with_loads(std::size_t stage) {
    for (std::size_t s = 0; s < stages_.size(); ++s)
      if (const auto* load = std::get_if<LoadSettings>(&stages_[s]);
          load != nullptr && load->load < model_->spec.loads.size())
        model_->loads.scale(load->load, s < stage ? 1.0 : 0.0);
    model_->loads.follow(*model_);
  }

  Relaxed run(const Course& course, const std::string& what, const std::string& why) {
    const Relaxed relaxed =
        relaxation_->run(course, [this](long step, double residual) { progress_(stage_, step, residual); });
    if (!(relaxed.residual < course.residual))
      throw NotAtRest(not_at_rest(what, relaxed, course.time, course.residual, why), stage_, own_);
    return relaxed;
  }

  void end_bonds(const Course& course, const Relaxed& rest) {
    if (model_->contact.any())
      slipping_ = release(*model_, *relaxation_, course, rest,
                          [this](long step, double residual) { progress_(stage_, step, residual); });
  }

  static Course course_of(const StageSettings& settings) {
    return {.undrained = settings.undrained,
            .ramp = settings.ramp,
            .time = settings.ramp + settings.max_time,
            .residual = settings.residual};
  }

  void go(const LoadSettings& load) {
    relaxation_->count_way();
    if (disturbed_ && !load.undrained) {
      const std::vector<Vector> f0 = relaxation_->forces();
      drain(*model_);
      relaxation_->hold(lacking_forces(*model_, *model_, f0, relaxation_->forces()));
    }
    Course course = course_of(load);
    course.grow = [&](double share) {
      model_->loads.scale(load.load, share);
      model_->loads.follow(*model_);
    };
    course.bonded = model_->contact.any();
    const SurfaceLoad& line = model_->spec.loads[load.load];
    const Relaxed loaded =
        run(course,
            fmt::format("the ground did not come to rest under the load from x = {:.6g} to {:.6g} m",
                        line.x_min, line.x_max),
            "it may not carry the load");
    end_bonds(course, loaded);
  }

  void go(const ConstructionSettings& construction) {
    std::vector<Vector> f0 = relaxation_->forces();
    const std::shared_ptr<Domain> owner = std::move(own_);
    const Domain& before = *model_;
    ways_before_ = structure_ways();
    begin_model(stage_);
    for (const std::size_t removed : removed_structures(before, *model_))
      relaxation_->add_contact_forces(removed, f0);
    relaxation_->finish();
    carry_over(before, *model_);
    relaxation_.emplace(*model_);
    relaxation_->count_way();
    if (!construction.undrained)
      drain(*model_);
    act_with_loads(stage_ - 1);
    relaxation_->hold(lacking_forces(before, *model_, f0, relaxation_->forces()));
    Course course = course_of(construction);
    course.bonded = true;
    const std::vector<RigidLoad> weights = weights_before(before, *model_);
    course.grow = [&](double share) {
      for (std::size_t b = 0; b < weights.size(); ++b)
        model_->contact.weigh(*model_, b, share, weights[b]);
    };
    const Relaxed rest = run(
        course, "the ground did not come to rest in a construction stage",
        "it may not stand without what was removed, carry what was placed, or bear the change of the water");
    end_bonds(course, rest);
  }

  Domain& end_;
  std::span<const StaticStage> stages_;
  const StageProgress& progress_;
  const StageShown& ended_;
  std::shared_ptr<Domain> own_; ///< the present model; null: it is that of the end
  Domain* model_ = nullptr;
  std::optional<Relaxation> relaxation_; ///< of the present model
  std::size_t stage_ = 0;
  std::vector<StructureWay> ways_before_; ///< in models before the present one
  std::vector<std::size_t> slipping_;     ///< bodies of the present model
  bool disturbed_ = false;                ///< the last stage has left an excess pressure
};

} // namespace

Reactions bring_to_rest(Domain& domain, const GravitySettings& settings, std::span<const StaticStage> then,
                        const StageProgress& progress, const StageShown& ended) {
  if (!(domain.spec.gravity > 0.0))
    throw std::invalid_argument(
        fmt::format("a gravity stage needs gravity > 0; it is {:.6g} m/s2", domain.spec.gravity));
  StaticStages stages(domain, then, progress, ended);
  stages.gravity(settings);
  for (std::size_t s = 0; s < then.size(); ++s)
    stages.next();
  return stages.finish();
}

Reactions relax_under_gravity(Domain& domain, const GravitySettings& settings,
                              const GravityProgress& progress) {
  return bring_to_rest(domain, settings, {},
                       [&](std::size_t, long step, double residual) { progress(step, residual); });
}

void take_velocities_of_nodes(Domain& domain) {
  for (Particles& set : domain.sets) {
    std::ranges::fill(set.vx, 0.0);
    std::ranges::fill(set.vy, 0.0);
  }
  std::ranges::fill(domain.grid.vx_before, 0.0); // FLIP adds what nodes have gained since
  std::ranges::fill(domain.grid.vy_before, 0.0);
  gather(domain, 0.0, {.velocity = true});
}

} // namespace tremolo::mpm_domain
