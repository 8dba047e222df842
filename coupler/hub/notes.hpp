#pragma once

// Messages to the user during a run. Texts from other processes are made printable. Strangers may say
// anything as often as they like: of one connection five notes in a row are shown, of all twenty at once and
// then one a second.

#include "coupler/mapping/timing.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <utility>

namespace tremolo::coupler {

class Notes {
public:
  explicit Notes(std::function<void(const std::string&)> note, Clock::time_point now = Clock::now())
      : note_(std::move(note)), last_(now) {}

  /// About the run itself.
  void show(const std::string& text);

  /// About somebody who is no participant.
  /// @param connection routing id of theirs
  void show_of_stranger(const std::string& connection, const std::string& text,
                        Clock::time_point now = Clock::now());

private:
  static constexpr double most_at_once = 20.0;
  static constexpr int most_in_a_row = 5;
  static constexpr double each_second = 1.0;

  std::function<void(const std::string&)> note_;
  double allowance_ = most_at_once; ///< notes that may be shown now
  Clock::time_point last_;
  std::string connection_; ///< of the last stranger
  int in_a_row_ = 0;       ///< notes about it, shown or not
  std::size_t left_out_ = 0;
};

} // namespace tremolo::coupler
