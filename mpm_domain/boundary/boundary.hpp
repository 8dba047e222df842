#pragma once

// The boundary of the domain: its faces, the supports behind them, and Eq. (6),
//
//     f^b = f^vis + f^dyn + f^st,
//
// to which the supports of the faces (support.hpp) add theirs. Nobody else keeps a copy of any of this.
//
// The free field is exchanged once a step, at its first tick, and held over it.
//
// Where there is pore water, which knows one clock, sides lean with their soil (lean/leaning_sides.hpp), and
// are as high as it.

#include "mpm_domain/boundary/base/rigid_base.hpp"
#include "mpm_domain/boundary/face_forces.hpp"
#include "mpm_domain/boundary/face_soil.hpp"
#include "mpm_domain/boundary/near/passed_field.hpp"
#include "mpm_domain/boundary/supports.hpp"

#include <functional>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// Gives every face the free field of a time (s) in which the domain's velocities there are v (m/s). It is
/// called once a step. Where ranks share the domain each calls its own, and all take what the first one's has
/// given. Faces that are tied to the opposite side are left as they are. Behind the faces' own stand the
/// fields that faces have beside them (Behind::has_own_field), in the order of these faces.
using FreeFieldSource =
    std::function<void(long step, double time, std::span<const Vector> v, std::span<eq6::FreeField> field)>;

class Boundary {
public:
  std::span<const BoundaryFace> faces() const { return faces_; }
  std::span<BoundaryFace> faces() { return faces_; }
  /// Leaves the domain without faces: a free body.
  void remove_faces();

  /// Finds the faces along the edges of a model at rest, before dashpots that match the soil in its present
  /// stress, and puts what the spec wants behind them.
  /// @throws std::invalid_argument where that cannot stand there
  void match(Ground& ground);
  /// Result of a gravity stage at the faces: impedances and static tractions.
  template <class Writer>
  void save_rest(Writer& to) {
    rest_state().save("boundary.rest", to);
  }
  /// Restores that result instead of running a gravity stage.
  /// @throws std::runtime_error for the faces of another boundary
  template <class Reader>
  void restore_rest(const Ground& ground, const Reader& from) {
    rest_state().restore("boundary.rest", from);
    build_supports(ground);
  }

  /// After a sort: the grid may have grown, and particles of faces may have come to other cells.
  void follow_sort(const Ground& ground);
  /// The faces that this rank works out.
  const NearFaces& near_faces() const { return near_; }
  /// The nodes that faces may touch until the next sort, if ranks share the domain: this rank receives their
  /// sums. Where structures may touch one of them the list is the same on all ranks.
  std::span<const std::size_t> shared_nodes() const { return soil_.shared_nodes(); }

  /// The passes of a step. After a scatter: reads the soil at the faces.
  void read_soil(Ground& ground) { soil_.read(ground, faces_, motion_.kicks()); }
  /// At the first tick: finds the velocities of the faces and the free field and evaluates Eq. (6), then
  /// advances the supports one by one.
  void exchange(Step& step, const FreeFieldSource& source);
  void exchange(Step& step, Support& support);
  /// At every tick: adds the forces and dashpots of the faces that are due to the nodes.
  void apply(Step& step);
  /// After the update: the work of the boundary by its parts that counts on this rank, as
  /// BoundaryWork::numbers().
  ExactSums<BoundaryWork::count> follow_update(Step& step);
  /// Leaves the boundary's forces out of the power that the remapped velocity makes.
  void take_off_remap_power(Step& step, int clock) const { forces_.take_off_remap_power(step, clock); }

  /// Results of the last exchange, by face: v^m (m/s) and the free field.
  std::span<const Vector> velocities() const { return motion_.seen(); }
  std::span<const eq6::FreeField> free_field() const { return std::span(free_field_).first(faces_.size()); }
  /// The soil at each face if there is pore water or if ranks share the domain; else empty.
  std::span<const FaceSoil> soil() const { return soil_.all(); }
  /// The leaning sides, used where there is pore water.
  const LeaningSides& lean() const { return lean_; }
  /// W of a face's nodes in its present step; none where other ranks alone work it out.
  std::span<const FaceWeight> weights(std::size_t face) const { return motion_.weights()[face]; }
  /// Traction of the boundary on a face at the start of its last step, Pa.
  Vector traction(std::size_t face) const;

  const FaceSupports& supports() const { return supports_; }
  /// Motion of a rigid base half a step before the end of the step just made; at rest where there is none.
  BaseMotion base_motion() const;

  /// Before a checkpoint, and at the end, the first rank learns what others alone know. All ranks call it.
  void tell_first(const Ground& ground) { soil_.tell_first(ground, faces_, motion_.kicks()); }
  /// State that a checkpoint stores between steps (state.hpp).
  template <class Writer>
  void save(Writer& to) const {
    std::vector<double> levels;
    for (const BoundaryFace& face : faces_)
      levels.push_back(face.level);
    to.write("faces.level", levels);
    motion_.save(to);
    supports_.save(to);
  }
  /// Goes on from there.
  /// @throws std::invalid_argument or std::runtime_error for the state of another boundary
  template <class Reader>
  void restore(const Reader& from) {
    const std::vector<double> levels = numbers_of_size(from, "faces.level", faces_.size());
    for (std::size_t f = 0; f < faces_.size(); ++f)
      faces_[f].level = static_cast<int>(levels[f]);
    motion_.restore(from);
    supports_.restore(from);
    follow_all();
  }

private:
  SavedNumbers rest_state();
  void build_supports(const Ground& ground);
  void follow_all();
  void catch_up(const Ground& ground);
  void evaluate(std::size_t face);
  FaceLoads loads() const { return {faces_, near_, motion_, traction_, supports_.loads(), lean_}; }

  std::vector<BoundaryFace> faces_;
  FaceSupports supports_;
  SoilAtFaces soil_;
  NearFaces near_;
  FaceMotion motion_;
  FaceForces forces_;
  LeaningSides lean_;
  PassedField passed_;
  std::vector<std::size_t> followed_;      ///< faces whose Eq. (6) and supports this rank evaluates, rising
  std::vector<eq6::FreeField> free_field_; ///< of the faces, and those that some have beside it
  std::vector<eq6::Traction> traction_;    ///< Eq. (6) at the start of each face's present step, Pa
};

} // namespace tremolo::mpm_domain
