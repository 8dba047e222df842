#include "base/text/paragraph.hpp"

namespace tremolo {

std::string wrapped(std::string paragraph) {
  constexpr std::size_t most = 120;
  for (std::size_t begin = 0; paragraph.size() - begin > most;) {
    const std::size_t space = paragraph.rfind(' ', begin + most);
    if (space == std::string::npos || space <= begin)
      break;
    paragraph[space] = '\n';
    begin = space + 1;
  }
  return paragraph;
}

} // namespace tremolo
