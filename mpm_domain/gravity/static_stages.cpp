#include "mpm_domain/gravity/static_stages.hpp"

#include "mpm_domain/gravity/construction/construction.hpp"
#include "mpm_domain/particles/fill/rest_stress.hpp"
#include "mpm_domain/ranks/communicator.hpp"
#include "mpm_domain/ranks/passed_state.hpp"
#include "mpm_domain/tiles/totals.hpp"
#include "mpm_domain/transfer/scatter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace tremolo::mpm_domain {

namespace {

/// The quantities of particles as they are at some time. Who they are, and where they stand in their sets,
/// stays.
class KeptQuantities {
public:
  explicit KeptQuantities(const std::vector<Particles>& sets) {
    for (const Particles& set : sets)
      of_sets_.push_back({static_cast<const ParticleFields&>(set), set.state});
  }
  void give_back(std::vector<Particles>& sets) const {
    for (std::size_t s = 0; s < sets.size(); ++s) {
      static_cast<ParticleFields&>(sets[s]) = of_sets_[s].fields;
      sets[s].state = of_sets_[s].state;
    }
  }

private:
  struct OfSet {
    ParticleFields fields;
    std::vector<double> state;
  };
  std::vector<OfSet> of_sets_;
};

/// Bodies that move at least a hundredth as fast as the fastest: one that slides goes on under the damping,
/// while others only answer to what it does to the soil.
std::vector<std::size_t> moving_bodies(const Domain& domain) {
  std::vector<double> speeds;
  for (std::size_t b = 0; b < domain.contact.bodies().size(); ++b)
    speeds.push_back(domain.contact.speed(domain, b));
  const double fastest = speeds.empty() ? 0.0 : std::ranges::max(speeds);
  std::vector<std::size_t> moving;
  for (std::size_t b = 0; b < speeds.size(); ++b)
    if (speeds[b] >= 0.01 * fastest)
      moving.push_back(b);
  return moving;
}

/// Relaxes once more with structures that may slide and part from the soil, so that the shaking begins
/// without a kick. If that finds no rest, the bonded state stays.
/// @param course  in which they have been bonded, and which ended at `rest`
/// @returns the bodies that move on; none: all rests
std::optional<std::vector<std::size_t>> release(Domain& domain, Relaxation& relaxation, const Course& course,
                                                const Relaxed& rest, const GravityProgress& progress) {
  constexpr long least =
      1000; // steps that friction may take to find its share, and as often those of the bonds
  const long steps = std::max(least, 4 * (rest.step - course.first));
  Course released = course;
  released.bonded = false;
  released.ramp = 0.0;
  released.first = rest.step;
  released.time = static_cast<double>(steps) * relaxation.step();
  const KeptQuantities bonded(domain.sets);
  const Linings bonded_linings = domain.linings;
  const Props bonded_props = domain.props;
  std::optional<std::vector<std::size_t>> moving;
  if (!(relaxation.run(released, progress).residual < course.residual)) {
    moving.emplace();
    if (domain.has_structures_here())
      moving = moving_bodies(domain);
    bonded.give_back(domain.sets);
    domain.linings = bonded_linings;
    domain.props = bonded_props;
    relaxation.find_forces();
  }
  if (domain.has_structures_here()) {
    domain.contact.end_rest();
    domain.linings.end_rest();
  }
  return moving;
}

/// The excess pressure that an undrained stage has left is gone in all soils but those that are undrained.
void drain(Domain& domain, const UndrainedSoils& undrained) {
  for (Particles& set : domain.sets)
    if (set.traits.wet && !undrained.include(set.soil))
      set.pore_pressure = set.pressure_at_rest;
}

/// Moves the particles of an elastic body, which have kept their positions, by their displacement.
void displace(Particles& set) {
  for (std::size_t k = 0; k < set.size(); ++k) {
    const Vector way{set.x[k] - set.x_initial[k], set.y[k] - set.y_initial[k]};
    set.x[k] += way.x;
    set.y[k] += way.y;
    set.x_initial[k] += way.x;
    set.y_initial[k] += way.y;
  }
}

/// Lets the surfaces of elastic bodies follow their particles, on the rank that has these.
void follow_elastic_bodies(Domain& domain) {
  if (domain.has_structures_here())
    domain.contact.follow_particles(domain);
}

/// Counts the particles of all ranks.
std::size_t count_particles(const Domain& domain) {
  std::int64_t count = static_cast<std::int64_t>(domain.particle_count());
  if (domain.share)
    domain.share->ranks->add({&count, 1});
  return static_cast<std::size_t>(count);
}

Course course_of(const StageSettings& settings) {
  return {.undrained = settings.undrained,
          .ramp = settings.ramp,
          .time = settings.ramp + settings.max_time,
          .residual = settings.residual};
}

} // namespace

StaticStage::StaticStage() = default;
StaticStage::StaticStage(const StaticStage& other) = default;
StaticStage::StaticStage(StaticStage&& other) noexcept = default;
StaticStage& StaticStage::operator=(const StaticStage& other) = default;
StaticStage& StaticStage::operator=(StaticStage&& other) noexcept = default;
StaticStage::~StaticStage() = default;

StaticStages::StaticStages(Domain& end, const GravitySettings& gravity, std::span<const StaticStage> then,
                           StageProgress progress)
    : end_(end), gravity_(gravity), stages_(then.begin(), then.end()), progress_(std::move(progress)),
      ranks_(end.ranks()) {
  if (!(end.spec.gravity > 0.0))
    throw std::invalid_argument(
        fmt::format("a gravity stage needs gravity > 0; it is {:.6g} m/s2", end.spec.gravity));
  begin_model(0);
}

void StaticStages::next() {
  if (over_ == 0)
    gravity();
  else
    std::visit(
        [this](const auto& stage) {
          go(stage);
          disturbed_ = stage.undrained.any;
        },
        stages_[over_ - 1]);
  end_stage();
}

void StaticStages::show(const std::function<void(Domain& model)>& act) {
  const KeptQuantities kept(model_->sets);
  const Contact contact = model_->contact;
  for (std::size_t b = 0; b < contact.bodies().size(); ++b)
    if (const auto structure = std::ranges::find(ways_, contact.bodies()[b].name(), &StructureWay::name);
        structure != ways_.end())
      model_->contact.displace(b, structure->way, structure->turn);
  for (Particles& set : model_->sets)
    if (set.body)
      displace(set);
  follow_elastic_bodies(*model_);
  act(*model_);
  kept.give_back(model_->sets);
  model_->contact = contact;
}

Reactions StaticStages::finish() {
  Reactions reactions = std::move(reactions_);
  reactions.slipping_bodies = slipping_.value_or(std::vector<std::size_t>{});
  reactions.slipping = slipping_.has_value();
  reactions.cut = begin_history(*model_);
  reactions.particles = count_particles(*model_);
  follow_elastic_bodies(*model_); // their surfaces turn with the last stage, too
  reactions.ways = ways_;
  return reactions;
}

void StaticStages::gravity() {
  set_rest_stress(model_->sets_of_soil(), model_->spec, {}, ranks_);
  begin_relaxation();
  act_with_loads(0);
  model_->props.place_jacks(nullptr);
  model_->props.grow(1.0);
  const Course course{.bonded = true,
                      .time = gravity_.max_time,
                      .residual = gravity_.residual,
                      .skin = gravity_.skin,
                      .falling = gravity_.falling};
  const Relaxed rest = run(course, "the gravity stage did not come to rest",
                           "the slope may not be stable under its weight, which tremolo safety finds out");
  end_bonds(course, rest);
}

void StaticStages::go(const LoadSettings& load) {
  begin_relaxation();
  relaxation_->count_way();
  act_with_loads(over_ - 1);
  if (disturbed_) {
    drain(*model_, load.undrained);
    relaxation_->hold(lacking_forces(*model_, *model_, forces_, relaxation_->forces()));
  }
  Course course = course_of(load);
  course.grow = [&](double share) { scale(load, share); };
  course.bonded = model_->contact.any() || model_->linings.any();
  const Relaxed loaded =
      run(course, fmt::format("the ground did not come to rest under the load {}", description(load)),
          "it may not carry the load");
  end_bonds(course, loaded);
}

void StaticStages::go(const ConstructionSettings& construction) {
  const std::shared_ptr<Domain> owner = std::move(own_);
  const Domain& before = *model_;
  begin_model(over_);
  carry_over(before, *model_);
  model_->props.carry_over(before.props);
  model_->props.place_jacks(&before.props);
  begin_relaxation();
  relaxation_->count_way();
  drain(*model_, construction.undrained);
  act_with_loads(over_ - 1);
  relaxation_->hold(lacking_forces(before, *model_, forces_, relaxation_->forces()));
  Course course = course_of(construction);
  course.bonded = true;
  const std::vector<RigidLoad> weights = weights_before(before, *model_, of_going_);
  course.grow = [&](double share) {
    for (std::size_t b = 0; b < weights.size(); ++b)
      model_->contact.weigh(*model_, b, share, weights[b]);
    model_->linings.grow_water(share);
    model_->props.grow(share);
  };
  const Relaxed rest = run(
      course, "the ground did not come to rest in a construction stage",
      "it may not stand without what was removed, carry what was placed, or bear the change of the water");
  end_bonds(course, rest);
}

void StaticStages::end_stage() {
  reactions_ = relaxation_->reactions();
  forces_ = over_ < stages_.size() ? relaxation_->forces() : std::vector<Vector>{};
  ++over_;
  of_going_.assign(model_->contact.bodies().size(), {});
  for (const std::size_t structure :
       model_->has_structures_here() ? structures_that_go() : std::vector<std::size_t>{})
    model_->contact.add_forces_of(structure, relaxation_->kick(), forces_, of_going_);
  ways_ = ways();
  model_->props.lock();
  relaxation_->finish();
  relaxation_.reset();
  if (ranks_ == nullptr)
    return;
  model_->share->times.restart(model_->tiles.count()); // steps of the shaking cost something else
  follow_first();
}

/// Every rank has what the first one has found of structures.
void StaticStages::follow_first() {
  PassedState of_first;
  save_result(of_first);
  const bool slips = slipping_.has_value();
  std::vector<std::uint64_t> slipping;
  if (slips)
    slipping.assign(slipping_->begin(), slipping_->end());
  of_first.write("slipping", slipping);
  of_first.follow_first(*ranks_);
  restore_result(of_first);
  if (slips)
    read_integers(of_first, "slipping", *slipping_);
}

/// The model of the stages from one of stages_ on, up to the next construction; nothing: it is that of the
/// end.
std::optional<Spec> StaticStages::spec_from(std::size_t first) const {
  std::size_t on_surface = 0;
  std::size_t on_structures = 0;
  for (std::size_t s = 0; s < stages_.size(); ++s) {
    const auto* const next = std::get_if<ConstructionSettings>(&stages_[s]);
    if (next != nullptr && s >= first) {
      Spec spec = end_.spec;
      spec.regions = next->regions;
      spec.structures = next->structures;
      spec.sections.clear(); // of the structures of the shaking
      spec.props = next->props;
      spec.water = next->water;
      spec.loads.resize(on_surface);
      spec.structure_loads.resize(on_structures);
      return spec;
    }
    if (const auto* const load = std::get_if<LoadSettings>(&stages_[s]))
      ++(load->on_structure ? on_structures : on_surface);
  }
  return std::nullopt;
}

void StaticStages::begin_model(std::size_t first) {
  const std::optional<Spec> spec = spec_from(first);
  own_ = spec ? std::make_shared<Domain>(*spec, ranks_) : nullptr;
  model_ = own_ ? own_.get() : &end_;
}

void StaticStages::begin_relaxation() {
  slipping_.reset();
  find_reach(*model_); // surfaces of elastic bodies turn with them
  relaxation_.emplace(*model_);
}

/// Lets the loads of the stages before one of stages_ act, and those after it not.
void StaticStages::act_with_loads(std::size_t stage) {
  const Spec& spec = model_->spec;
  for (std::size_t s = 0; s < stages_.size(); ++s)
    if (const auto* load = std::get_if<LoadSettings>(&stages_[s]);
        load != nullptr &&
        load->load < (load->on_structure ? spec.structure_loads.size() : spec.loads.size()))
      scale(*load, s < stage ? 1.0 : 0.0);
  follow_loads();
  weigh_structures();
}

/// Brings the loads on the surface to where the soil is, on the rank that has it.
void StaticStages::follow_loads() {
  if (model_->has_structures_here())
    model_->loads.follow(*model_);
}

void StaticStages::weigh_structures() {
  for (std::size_t b = 0; b < model_->contact.bodies().size(); ++b)
    model_->contact.weigh(*model_, b, 1.0);
}

/// Lets a load act with a share of its size.
void StaticStages::scale(const LoadSettings& load, double share) {
  if (!load.on_structure) {
    model_->loads.scale(load.load, share);
    follow_loads();
    return;
  }
  model_->contact.structure_loads().scale(load.load, share);
  weigh_structures();
}

/// "from x = 3 to 5 m" or "on the structure 'tower'"
std::string StaticStages::description(const LoadSettings& load) const {
  const Spec& spec = model_->spec;
  if (load.on_structure)
    return fmt::format("on the structure '{}'", spec.structure_loads[load.load].structure);
  return fmt::format("from x = {:.6g} to {:.6g} m", spec.loads[load.load].x_min, spec.loads[load.load].x_max);
}

Relaxed StaticStages::run(const Course& course, const std::string& what, const std::string& why) {
  const Relaxed relaxed =
      relaxation_->run(course, [this](long step, double residual) { progress_(over_, step, residual); });
  if (relaxed.residual < course.residual)
    return relaxed;
  throw NotAtRest(fmt::format("{}: residual {:.3g} after {:.3g} s of relaxation, wanted {:.3g}; {}", what,
                              relaxed.residual,
                              static_cast<double>(relaxed.step - course.first) * relaxation_->step(),
                              course.residual, why),
                  over_, own_);
}

void StaticStages::end_bonds(const Course& course, const Relaxed& rest) {
  if (model_->contact.any() || model_->linings.any())
    slipping_ = release(*model_, *relaxation_, course, rest,
                        [this](long step, double residual) { progress_(over_, step, residual); });
}

/// Structures of the present model that the next stage removes.
std::vector<std::size_t> StaticStages::structures_that_go() const {
  if (are_over() || !std::holds_alternative<ConstructionSettings>(stages_[over_ - 1]))
    return {};
  const std::optional<Spec> next = spec_from(over_);
  return removed_structures(*model_, next ? next->structures : end_.spec.structures);
}

/// Ways of the structures of the present model, those in the stages before the present one included.
std::vector<StructureWay> StaticStages::ways() const {
  std::vector<StructureWay> ways = relaxation_->structure_ways();
  for (StructureWay& structure : ways)
    if (const auto found = std::ranges::find(ways_, structure.name, &StructureWay::name);
        found != ways_.end()) {
      structure.way += found->way;
      structure.turn += found->turn;
    }
  return ways;
}

/// The structures that have a way after the stages that are over, with none.
std::vector<StructureWay> StaticStages::no_ways() const {
  std::vector<StructureWay> ways;
  for (std::size_t b = 0; over_ > 1 && b < model_->contact.bodies().size(); ++b)
    if (!model_->contact.is_elastic(b))
      ways.push_back({model_->contact.bodies()[b].name(), {}});
  return ways;
}

void StaticStages::take_forces(const std::vector<double>& numbers) {
  forces_.clear();
  for (std::size_t n = 0; n < numbers.size(); n += 2)
    forces_.push_back({numbers[n], numbers[n + 1]});
}

void StaticStages::take_loads(const std::vector<double>& numbers) {
  of_going_.clear();
  for (std::size_t n = 0; n < numbers.size(); n += 3)
    of_going_.push_back({{numbers[n], numbers[n + 1]}, numbers[n + 2]});
}

void StaticStages::take_ways(const std::vector<double>& numbers) {
  for (std::size_t s = 0; s < ways_.size(); ++s) {
    const double* const of_structure = numbers.data() + numbers_of_way * s;
    ways_[s].way = {of_structure[0], of_structure[1]};
    ways_[s].turn = of_structure[2];
  }
}

} // namespace tremolo::mpm_domain
