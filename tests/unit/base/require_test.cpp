#include "base/require.hpp"

#include <gmock/gmock.h>

#include <limits>
#include <stdexcept>

namespace tremolo {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Require, NamesTheValueAndWhatIsAllowed) {
  EXPECT_NO_THROW(require(true, "the angle", 1.0, "below 2"));
  EXPECT_THAT([] { require(false, "the angle", 0.1234567, "below 0"); },
              ThrowsMessage<std::invalid_argument>("the angle is 0.123457, must be below 0"));
}

TEST(Require, PositiveRefusesZeroAndWhatIsNoNumber) {
  EXPECT_NO_THROW(require_positive("the step", 1e-300, "s"));
  for (const double value : {0.0, -1.0, nan, std::numeric_limits<double>::infinity()})
    EXPECT_THAT([value] { require_positive("the step", value, "s"); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("must be positive and finite, in s")));
}

} // namespace
} // namespace tremolo
