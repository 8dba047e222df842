#pragma once

// The static stages of a run (gravity_stage.hpp), one after the other. What the next stage depends on is the
// state of the model's particles, structures and linings, how far these have gone, whether an excess pressure
// was left, and the forces on the nodes,
//
//     f0 = what soil and loads exert, and what a structure that goes next presses onto the soil,
//
// from which a construction goes on. Nothing else outlives a stage, so that a walk which is given this of
// another one goes on with the same bits. It can therefore be broken off after any stage.
//
// Ranks that share the model of the end share all others too, with the same bits. What they find of forces,
// structures and their ways, all know after each stage.

#include "mpm_domain/fields/stages_over.hpp"
#include "mpm_domain/gravity/gravity_stage.hpp"
#include "mpm_domain/gravity/relaxation.hpp"
#include "mpm_domain/state.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tremolo::mpm_domain {

class StaticStages {
public:
  /// @param end   the model after the last stage, to which all of them happen where none is a construction;
  ///              outlives this
  /// @param then  the stages after gravity
  /// @throws std::invalid_argument for a model without weight
  StaticStages(Domain& end, const GravitySettings& gravity, std::span<const StaticStage> then,
               StageProgress progress);

  /// Number of completed stages; gravity is the first.
  std::size_t over() const { return over_; }
  bool are_over() const { return over_ == stages_.size() + 1; }

  /// The next stage happens.
  /// @throws NotAtRest if it does not come to rest
  void next();

  /// The model as the last stage has left it.
  const Domain& model() const { return *model_; }

  /// Acts on it with structures where they have gone, and leaves it as it was. All ranks call it.
  void show(const std::function<void(Domain& model)>& act);

  /// After the last stage: the laws' memory begins.
  /// @returns the reactions of the constraints
  Reactions finish();

  /// Saves all that a walk goes on from after this stage (fields/saved_numbers.hpp).
  /// @param particles  of the model; where ranks share it, those that rank 0 is shown
  template <class Writer>
  void save(const AllParticles& particles, Writer& to) const {
    to.write(stages_over_name, std::vector<std::uint64_t>{over_});
    to.write("static.disturbed", std::vector<double>{disturbed_ ? 1.0 : 0.0});
    save_result(to);
    mpm_domain::save(*model_, particles, to);
  }

  /// Goes on from there, a walk through the same stages that has not begun.
  /// @throws std::runtime_error for the state of another walk
  template <class Reader>
  void restore(const Reader& from) {
    begin_model(read_count(from) - 1);
    over_ = read_count(from);
    disturbed_ = numbers_of_size(from, "static.disturbed", 1).front() != 0.0;
    mpm_domain::restore(*model_, from);
    act_with_loads(over_ - 1);
    ways_ = no_ways();
    restore_result(from);
  }

  /// Number of completed stages when a checkpoint was made.
  template <class Reader>
  static std::size_t read_count(const Reader& from) {
    return static_cast<std::size_t>(from.integers(stages_over_name).at(0));
  }
  /// Lets a checkpoint of the shaking say that all of them were.
  template <class Writer>
  static void save_count(std::size_t stages, Writer& to) {
    to.write(stages_over_name, std::vector<std::uint64_t>{stages});
  }

private:
  static constexpr std::size_t numbers_of_way = 3;

  /// What a stage has found, apart from the state of its model.
  template <class Writer>
  void save_result(Writer& to) const {
    std::vector<double> numbers;
    for (const Vector& force : forces_)
      numbers.insert(numbers.end(), {force.x, force.y});
    to.write("static.forces", numbers);
    numbers.clear();
    for (const RigidLoad& load : of_going_)
      numbers.insert(numbers.end(), {load.force.x, load.force.y, load.moment});
    to.write("static.loads", numbers);
    numbers.clear();
    for (const StructureWay& structure : ways_)
      numbers.insert(numbers.end(), {structure.way.x, structure.way.y, structure.turn});
    to.write("static.ways", numbers);
  }
  template <class Reader>
  void restore_result(const Reader& from) {
    take_forces(numbers_of_size(from, "static.forces", are_over() ? 0 : 2 * model_->grid.size()));
    take_loads(numbers_of_size(from, "static.loads", 3 * model_->contact.bodies().size()));
    take_ways(numbers_of_size(from, "static.ways", numbers_of_way * ways_.size()));
  }

  void gravity();
  void go(const LoadSettings& load);
  void go(const ConstructionSettings& construction);
  void end_stage();
  void follow_first();

  std::optional<Spec> spec_from(std::size_t first) const;
  void begin_model(std::size_t first);
  void begin_relaxation();
  void act_with_loads(std::size_t stage);
  void scale(const LoadSettings& load, double share);
  void follow_loads();
  void weigh_structures();
  std::string description(const LoadSettings& load) const;
  Relaxed run(const Course& course, const std::string& what, const std::string& why);
  void end_bonds(const Course& course, const Relaxed& rest);
  std::vector<std::size_t> structures_that_go() const;
  std::vector<StructureWay> ways() const;
  std::vector<StructureWay> no_ways() const;
  void take_forces(const std::vector<double>& numbers);
  void take_loads(const std::vector<double>& numbers);
  void take_ways(const std::vector<double>& numbers);

  Domain& end_;
  GravitySettings gravity_;
  std::vector<StaticStage> stages_; ///< after gravity
  StageProgress progress_;
  Communicator* ranks_; ///< that share the models; null: there is one process
  std::size_t over_ = 0;
  std::shared_ptr<Domain> own_; ///< the present model; null: it is that of the end
  Domain* model_ = nullptr;
  bool disturbed_ = false;     ///< the last stage has left an excess pressure
  std::vector<Vector> forces_; ///< f0, N/m; none when all stages are over
  /// Forces that removed structures exerted on the rigid ones of the present model at the end of the last
  /// stage.
  std::vector<RigidLoad> of_going_;
  std::vector<StructureWay> ways_; ///< of the rigid structures of the present model; none after gravity alone
  Reactions reactions_;            ///< of the last stage

  std::optional<Relaxation> relaxation_; ///< of the present stage
  /// Bodies that its end does not hold; none: all rests.
  std::optional<std::vector<std::size_t>> slipping_;
};

} // namespace tremolo::mpm_domain
