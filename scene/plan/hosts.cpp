#include "scene/plan/hosts.hpp"

#include <charconv>

namespace tremolo::scene {

namespace {

bool is_port(std::string_view text) {
  int port = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
  return text == "*" ||
         (error == std::errc{} && end == text.data() + text.size() && port >= 1 && port <= 65535);
}

bool is_address(std::string_view text) {
  constexpr std::string_view of_names = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-_";
  if (text.size() > 2 && text.front() == '[' && text.back() == ']')
    return text.substr(1, text.size() - 2).find_first_not_of("0123456789abcdefABCDEF:.") ==
           std::string_view::npos;
  return text == "*" || (!text.empty() && text.find_first_not_of(of_names) == std::string_view::npos);
}

} // namespace

const Host* host_of(const Case& scene, const SourceProcess& source) {
  for (const Served& served : source.serves)
    if (const auto found = scene.hosts.sides.find(served.side); found != scene.hosts.sides.end())
      return &found->second;
  return nullptr;
}

bool is_tcp_endpoint(std::string_view text) {
  constexpr std::string_view scheme = "tcp://";
  const auto colon = text.rfind(':');
  return text.starts_with(scheme) && colon != std::string_view::npos && colon > scheme.size() &&
         is_address(text.substr(scheme.size(), colon - scheme.size())) && is_port(text.substr(colon + 1));
}

} // namespace tremolo::scene
