// libFuzzer on the frame decoder: reads no byte outside its input (with the sanitizers), and takes nothing
// but the frame that encode() would have made of the same header and values.
//
//     frame_fuzzer [-max_total_time=60] tests/fuzz/coupler/corpus

#include "coupler/wire/frame.hpp"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>

namespace {

using namespace tremolo::coupler;

/// What the frames of the corpus were made for (frame_fuzz_test.cpp).
constexpr ExpectedFrame expected{.session = 77, .sender = 1, .step = 128, .count = 20, .most_steps = 64};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span(data, size));
  const auto decoded = decode(bytes, expected);
  if (const auto* frame = std::get_if<Frame>(&decoded)) {
    const auto again = encode(frame->header, frame->values());
    if (again.size() != bytes.size() || std::memcmp(again.data(), bytes.data(), again.size()) != 0)
      std::abort();
  }
  claimed_origin(bytes);
  return 0;
}
