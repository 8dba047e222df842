#include "motion/read/read.hpp"
#include "tests/support/hdf5_motion.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tremolo::motion {
namespace {

using testing::Hdf5Motion;

class Hdf5 : public ::testing::Test {
protected:
  Record read(const Hdf5Motion& motion, const ReadAs& as = {}) {
    testing::write_hdf5(file_, motion);
    return read_record(file_, as);
  }

  std::string error_of(const Hdf5Motion& motion) {
    try {
      read(motion);
    } catch (const RecordError& error) {
      return std::string(error.what()).substr(file_.string().size());
    }
    return "";
  }

  testing::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "motion.h5";
};

TEST_F(Hdf5, SamplesAndAttributes) {
  const auto record =
      read({.samples = {1.0, -2.0, 3.0}, .dt = 0.005, .texts = {{"unit", "cm/s"}, {"kind", "incident"}}});
  EXPECT_EQ(record.samples, (std::vector{1.0, -2.0, 3.0}));
  EXPECT_EQ(record.dt, 0.005);
  EXPECT_EQ(record.unit, Unit::cm_s);
  EXPECT_EQ(record.kind, MotionKind::incident);
}

TEST_F(Hdf5, TextsOfFixedAndVariableLength) {
  Hdf5Motion motion{.samples = {1.0, 2.0}, .dt = 0.1, .texts = {{"unit", "g"}}};
  motion.variable_length = true;
  EXPECT_EQ(read(motion).unit, Unit::g);
  motion.variable_length = false;
  EXPECT_EQ(read(motion).unit, Unit::g);
}

TEST_F(Hdf5, UnitMayBeSaidByTheCaller) {
  const Hdf5Motion motion{.samples = {1.0, 2.0}, .dt = 0.1, .texts = {{"quantity", "velocity"}}};
  EXPECT_EQ(read(motion, {.unit = Unit::m_s}).unit, Unit::m_s);
  EXPECT_EQ(error_of(motion), ": the header does not name the unit of the velocity: say which (--unit)");
}

TEST_F(Hdf5, SaysWhatIsWrong) {
  Hdf5Motion motion{.samples = {1.0, 2.0}, .dt = 0.1, .texts = {{"unit", "g"}}};
  motion.name = "record";
  EXPECT_EQ(error_of(motion), ": has no dataset 'motion'");
  motion.name = "motion";
  motion.dt.reset();
  EXPECT_EQ(error_of(motion), ": dataset 'motion' has no attribute 'dt', the time step in s");
  motion.dt = -1.0;
  EXPECT_EQ(error_of(motion), ": dt = -1 s, must be > 0");
  motion.dt = 0.1;
  motion.samples[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_of(motion), ": sample 1 is nan, must be finite");
  motion.samples = {1.0};
  EXPECT_EQ(error_of(motion), ": 1 samples, must be from 2 to 2e+07");
  motion.samples = {1.0, 2.0};
  motion.texts = {{"unit", "furlong"}};
  EXPECT_EQ(error_of(motion), ": attribute 'unit' of 'motion' is 'furlong', which is not known");
  motion.texts = {{"unit", "g"}, {"quantity", "velocity"}};
  EXPECT_EQ(error_of(motion), ": unit 'g' is not one of velocity");
}

} // namespace
} // namespace tremolo::motion
