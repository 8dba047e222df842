// The rules of the time step, each with a case that keeps it and one that breaks it, and the message.

#include "../structure_case.hpp"
#include "rule_cases.hpp"

#include <gmock/gmock.h>

namespace tremolo::scene::testing {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(Rules, TimeStepIsStableWithUsl) {
  const auto usl = [](const std::string& step) {
    return errors_of(plus("[time]\norder = \"usl\"\n" + step + "\n"));
  };
  EXPECT_THAT(usl("fraction = 0.85"), IsEmpty());
  EXPECT_THAT(
      usl("fraction = 0.9"),
      ElementsAre("case.toml:33:12: [time] 'fraction' = 0.9 is not stable with order = \"usl\"; allowed: "
                  "at most 0.85"));
  EXPECT_THAT(usl("dt = 3.18e-3"), IsEmpty()); // 0.85 of 3.74777e-3 s
  EXPECT_THAT(
      usl("dt = 3.19e-3"),
      ElementsAre("case.toml:33:6: [time] 'dt' = 0.00319 is not stable with order = \"usl\"; allowed: at "
                  "most 0.85 of the critical step, 0.0031856 s"));
}

TEST(Rules, StepsCanBeCounted) {
  EXPECT_THAT(errors_of(plus("[time]\nfraction = 1e-300\n")),
              ElementsAre(HasSubstr(
                  "case.toml:32:12: [time] steps of 3.75e-303 s make 5.34e+302 for the 2 s of the run, "
                  "must be at most 1e+09")));
  EXPECT_THAT(errors_of(plus("[time]\ndt = 1e-12\n")), ElementsAre(HasSubstr("must be at most 1e+09")));
}

TEST(Rules, TimeStepIsStable) {
  // c_p = sqrt(E (1-nu)/((1+nu)(1-2nu) rho)) = 173.44 m/s, h = 1 m: 0.65 h/c_p = 3.74777e-3 s.
  EXPECT_THAT(errors_of(plus("[time]\ndt = 3.74e-3\n")), IsEmpty());
  EXPECT_THAT(errors_of(plus("[time]\ndt = 3.75e-3\n")),
              ElementsAre("case.toml:32:6: [time] 'dt' = 0.00375 exceeds the critical step 0.65 h/c_p = "
                          "0.00374777 s of this mesh "
                          "and its fastest soil"));
}

TEST(Rules, DispersionSuitsCase) {
  const auto reduced = [](const std::string& more, const std::string& old = "", const std::string& now = "") {
    const std::string text = with("size = 1.0", "size = 1.0\ndispersion = \"reduced\"", plus(more));
    return errors_of(old.empty() ? text : with(old, now, text));
  };
  const std::string start = "'dispersion' = \"reduced\" ";
  EXPECT_THAT(reduced(""), IsEmpty());
  for (const std::string few : {"2", "3", "4"})
    EXPECT_THAT(reduced("", "dispersion", "particles_per_cell = " + few + "\ndispersion"), IsEmpty());
  EXPECT_THAT(reduced("", "form = \"total\"", "form = \"total\", absorber = \"matched_layer\""), IsEmpty());
  EXPECT_THAT(reduced("", "left = { model = \"wave\" }", "left = { model = \"mpm\" }"),
              Contains(HasSubstr(start + "needs a free field other than \"mpm\"")));
  EXPECT_THAT(reduced("", "model = \"linear_elastic\"",
                      "model = \"mohr_coulomb\"\ncohesion_peak = 4e3\ncohesion_residual = 4e3\nsoftening = "
                      "0.0\nfriction_peak_deg = 30.0\nfriction_residual_deg = 30.0"),
              ElementsAre(HasSubstr("slopes that yield, as soil 'sand' may, fail seconds early")));
}

TEST(Rules, FlipHasSurfaceAlongGrid) {
  const std::string flip = "[time]\ntransfer = \"flip\"\n";
  const std::string whole = "[20.0, -10.0], [20.0, 0.0], [0.0, 0.0]]";
  const auto cut = [](const std::string& corners) {
    return "[20.0, -10.0], [20.0, 0.0], [12.0, 0.0], " + corners + ", [8.0, 0.0], [0.0, 0.0]]";
  };
  EXPECT_THAT(errors_of(plus(flip)), IsEmpty());
  EXPECT_THAT(errors_of(with(whole, cut("[12.0, -2.0], [8.0, -2.0]"), plus(flip))), IsEmpty());
  for (const std::string corners : {"[10.0, -3.0]", "[12.0, -2.5], [8.0, -2.5]"}) {
    EXPECT_THAT(
        errors_of(with(whole, cut(corners), plus(flip))),
        ElementsAre(::testing::HasSubstr("[time] 'transfer' = \"flip\" with a free surface off the lines")));
    EXPECT_THAT(errors_of(with(whole, cut(corners))), IsEmpty());
  }
}

} // namespace
} // namespace tremolo::scene::testing
