#pragma once

#include "mpm_domain/boundary/support.hpp"

#include <memory>
#include <span>
#include <vector>

namespace tremolo::mpm_domain {

/// All supports behind the faces of a domain.
class FaceSupports {
public:
  FaceSupports() = default;
  /// Puts what the spec wants behind the faces of a domain at rest, which learn what stands there.
  /// @throws std::invalid_argument where it cannot stand there
  FaceSupports(const Ground& ground, std::span<BoundaryFace> faces);

  std::span<const std::unique_ptr<Support>> all() const { return all_; }
  /// The one of a kind; null where there is none.
  template <class Kind>
  const Kind* find() const {
    for (const auto& support : all_)
      if (const auto* const kind = dynamic_cast<const Kind*>(support.get()))
        return kind;
    return nullptr;
  }

  /// Whether all are (Support::is_by_face).
  bool are_by_face() const;
  void follow_sort(const Ground& ground);
  /// One of them goes on to the time of an exchange.
  void exchange(Support& support, const Exchange& at) { support.exchange(at, loads_); }
  /// Loads by face at the last exchange; empty without supports.
  std::span<const SupportLoad> loads() const { return loads_; }
  /// Energy that all supports have absorbed since the last exchange, J/m.
  double work() const;

  /// State that a checkpoint stores between steps (state.hpp).
  template <class Writer>
  void save(Writer& to) const {
    for (const auto& support : all_)
      state_of(*support).save(saved_name(*support), to);
  }
  template <class Reader>
  void restore(const Reader& from) {
    for (const auto& support : all_)
      state_of(*support).restore(saved_name(*support), from);
  }

private:
  static std::string saved_name(const Support& support) { return "boundary." + support.name(); }
  static SavedNumbers state_of(Support& support) {
    SavedNumbers state;
    support.add_state(state);
    return state;
  }

  std::vector<std::unique_ptr<Support>> all_;
  std::vector<SupportLoad> loads_;
};

} // namespace tremolo::mpm_domain
