// What a study of site responses says: its models, counts as axes, the colours of its pictures, and what is
// refused.

#include "tests/unit/scene/random/joined.hpp"
#include "scene/study.hpp"

#include "scene/text/errors.hpp"
#include "tests/support/flat_case.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <string>
#include <string_view>
#include <vector>

namespace tremolo::scene {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using tremolo::testing::join;

constexpr std::string_view site = "case = \"case.toml\"\n[column]\nmodels = [\"eql\", \"wave\"]\n[axes]\n"
                                  "random_profile.realisation = { count = 3 }\n";

class Studies : public ::testing::Test {
protected:
  Study read(std::string_view text) {
    folder_.write("case.toml", testing::flat_case);
    return load_study(folder_.write("study.toml", text));
  }

  std::string error_of(std::string_view text) {
    try {
      read(text);
    } catch (const CaseErrors& errors) {
      EXPECT_EQ(1U, errors.errors().size());
      return errors.errors().front().message();
    }
    return "none";
  }

private:
  testing::TemporaryFolder folder_;
};

TEST_F(Studies, NameTheModelsOfSiteResponses) {
  EXPECT_THAT(read(site).models, ElementsAre(SourceModel::eql, SourceModel::wave));
  EXPECT_TRUE(read("case = \"case.toml\"\n[axes]\nmesh.size = [1, 2]\n").models.empty());
}

TEST_F(Studies, CountFromOne) {
  std::vector<std::string> values;
  const Study study = read(site);
  for (const AxisValue& value : study.axes.front().values)
    values.push_back(value.toml);
  EXPECT_THAT(values, ElementsAre("1", "2", "3"));
}

TEST_F(Studies, ColourModelsAndNeverRealisations) {
  EXPECT_EQ("model", read(site).colour);
  const auto one = testing::with(", \"wave\"", "", std::string(site));
  EXPECT_EQ("", read(one).colour);
  EXPECT_EQ("motion.scale", read(join({one, "motion.scale = [1, 2]\n"})).colour);
  EXPECT_EQ("motion.scale",
            read(join({site, "motion.scale = [1, 2]\n[measures]\ncolour = \"motion.scale\"\n"})).colour);
}

TEST_F(Studies, RefuseWhatIsNone) {
  EXPECT_THAT(error_of(testing::with("\"wave\"", "\"waves\"", std::string(site))),
              HasSubstr("study.toml:3:18: [column]"));
  EXPECT_THAT(error_of(testing::with("\"wave\"", "\"recording\"", std::string(site))),
              HasSubstr("recording"));
  EXPECT_THAT(error_of(testing::with("models = [\"eql\", \"wave\"]\n", "", std::string(site))),
              HasSubstr("missing 'models'"));
  EXPECT_THAT(error_of(testing::with("count = 3", "count = 0", std::string(site))),
              HasSubstr("'count' = 0 is out of range, must be in [1, 10000]"));
  EXPECT_THAT(error_of(testing::with("count = 3", "count = 3, to = 4", std::string(site))),
              HasSubstr("unknown key 'to'"));
}

TEST_F(Studies, RefuseMeasuresOfADomain) {
  EXPECT_THAT(error_of(join({site, "[measures]\nfailure_strain = 0.2\n"})),
              HasSubstr("study.toml:7:18: [measures] 'failure_strain' belongs to runs of a domain"));
  EXPECT_THAT(
      error_of(join({site, "[measures.spectral_ratio]\nof = \"a\"\nover = \"b\"\nperiods = [1.0]\n"})),
      HasSubstr("[measures.spectral_ratio] belongs to runs of a domain"));
}

} // namespace
} // namespace tremolo::scene
