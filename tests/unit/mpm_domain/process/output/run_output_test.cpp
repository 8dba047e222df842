// Fields of one's own are written in every frame, though the output does not know of them.

#include "mpm_domain/process/output/run_output.hpp"

#include "results/run_file.hpp"
#include "tests/support/box_run.hpp"
#include "tests/support/quiet_ground.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/unit/scene/case_text.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tremolo::mpm_domain {
namespace {

TEST(RunOutput, WritesAFieldOfOnesOwnInEveryFrame) {
  const scene::Case scene = scene::parse(scene::testing::flat_case, "flat.toml", ".");
  Spec spec = test_support::elastic_box(20.0, 10.0, 1.0);
  spec.more_fields = {{.name = "tag", .unit = "kPa", .meaning = "set by the test", .on_cut = OnCut::copied}};
  Domain domain(spec);
  Particles& p = domain.sets.front();
  std::vector<double> by_id;
  p.index_of.for_all([&](std::uint32_t k) {
    by_id.push_back(p.more.front()[k] = 3.0 + 0.5 * static_cast<double>(p.id[k]));
  });

  const testing::TemporaryFolder folder;
  const std::vector<std::string> sources(domain.boundary.faces().size(), "wave");
  const Snapshot picture(domain);
  RunOutput output(folder / "", scene, "{}", domain, domain.sets, picture, sources);
  Stepper stepper(domain, 0.0, test_support::quiet_ground());
  stepper.step();
  output.after_step(stepper);
  stepper.step();
  output.write_last(stepper);
  output.finish(stepper, 0.0, 0.0);

  const results::RunReader run(folder / "run.h5");
  ASSERT_EQ(run.frame_times().size(), 2U);
  for (std::size_t frame = 0; frame < 2; ++frame) {
    const results::FieldData tags = run.frame_field(frame, "tag");
    EXPECT_EQ(tags.unit, "kPa");
    EXPECT_EQ(tags.components, 1U);
    EXPECT_EQ(tags.values, by_id);
  }
}

} // namespace
} // namespace tremolo::mpm_domain
