#include "coupler/hub/notes.hpp"

#include "base/text/printable.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>

namespace tremolo::coupler {

void Notes::show(const std::string& text) {
  note_(printable(text));
}

void Notes::show_of_stranger(const std::string& connection, const std::string& text, Clock::time_point now) {
  const double elapsed = std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  allowance_ = std::min(most_at_once, allowance_ + each_second * elapsed);
  in_a_row_ = connection == connection_ ? in_a_row_ + 1 : 1;
  connection_ = connection;
  if (allowance_ < 1.0 || in_a_row_ > most_in_a_row) {
    ++left_out_;
    return;
  }
  allowance_ -= 1.0;
  if (const auto count = std::exchange(left_out_, 0); count > 0)
    note_(fmt::format("{} notes about strangers were left out", count));
  show(text);
}

} // namespace tremolo::coupler
