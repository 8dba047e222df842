// Keys of soils are those of the laws' own tables.

#include "materials/elastic/elastic_parameters.hpp"
#include "materials/law/law.hpp"
#include "scene/keys/soil/keys_law.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>
#include <string>

namespace tremolo::scene::testing {
namespace {

using ::testing::HasSubstr;

const Key& soil_key(std::string_view name) {
  return *table_spec(case_keys(), "soil").find(name);
}

bool applies(const Key& key, std::string_view model) {
  return key.when.key.empty() || std::ranges::find(key.when.values, model) != key.when.values.end();
}

TEST(LawKeys, AreEveryNumberOfEveryModelInItsUnit) {
  for (const auto& [model, word] : words(SoilModel{}))
    for (const materials::Parameter& parameter : parameters_of(model)) {
      ASSERT_NE(table_spec(case_keys(), "soil").find(parameter.name), nullptr) << parameter.name;
      const Key& key = soil_key(parameter.name);
      EXPECT_EQ(key.unit, parameter.unit) << parameter.name;
      EXPECT_TRUE(applies(key, word)) << word << " " << parameter.name;
      EXPECT_LE(key.range.low, parameter.range.low) << parameter.name;
      EXPECT_GE(key.range.high, parameter.range.high) << parameter.name;
      EXPECT_FALSE(key.required && !parameter.needed()) << word << " " << parameter.name;
    }
}

TEST(LawKeys, ApplyOnlyToModelsThatTakeThem) {
  for (const auto& [model, word] : words(SoilModel{})) {
    std::set<std::string_view> taken;
    for (const materials::Parameter& parameter : parameters_of(model))
      taken.insert(parameter.name);
    for (const Key& key : law_keys())
      EXPECT_EQ(applies(key, word), taken.contains(key.name)) << word << " " << key.name;
  }
}

TEST(LawKeys, SayWhereModelsDiffer) {
  const Key& friction = soil_key("friction_deg");
  EXPECT_FALSE(friction.required);
  EXPECT_EQ(friction.range.text(), "in [0, 89]");
  EXPECT_THAT(std::string(friction.meaning), HasSubstr("`pdmy03`: in [1, 65]."));
  EXPECT_THAT(std::string(friction.otherwise), HasSubstr("needed by `drucker_prager`"));
  EXPECT_THAT(std::string(soil_key("atmospheric_pressure").otherwise),
              HasSubstr("`pm4sand`: 101.3e3; `pdmy03`: 101e3"));
  EXPECT_EQ(soil_key("density").otherwise,
            "`pdmy03`: of the recommended set of `relative_density`; needed by others");
  EXPECT_EQ(soil_key("poisson").otherwise, "`pm4sand`: 0.3; others: `vs` and `vp`");
  EXPECT_EQ(soil_key("surfaces").meaning, "Number of nested yield surfaces. `multi_yield_clay`: in [4, 60]; "
                                          "a multiple of 4. `pdmy03`: in [3, 40].");
  EXPECT_TRUE(soil_key("undrained_strength").required);
  EXPECT_EQ(soil_key("n_b").meaning, "Bounding surface M_b = M exp(-n_b xi_R).");
}

/// What a report calls a number is what a file does.
TEST(LawKeys, AreTheNamesOfReports) {
  const materials::Elasticity elastic = {1700.0, 40e6, 0.28};
  const auto reported = [](const materials::Law& law) {
    std::set<std::string> names;
    for (const auto& value : materials::parameters(law))
      names.insert(std::string(value.name));
    return names;
  };
  const auto all_there = [&](SoilModel model, const materials::Law& law) {
    const auto names = reported(law);
    const std::set<std::string_view> not_reported = {"vs", "vp", "reference_size", "relative_density"};
    for (const materials::Parameter& parameter : parameters_of(model))
      EXPECT_TRUE(not_reported.contains(parameter.name) || names.contains(std::string(parameter.name)))
          << name(model) << " " << parameter.name;
  };
  all_there(SoilModel::linear_elastic, materials::LinearElastic{elastic});
  all_there(SoilModel::mohr_coulomb, materials::MohrCoulomb{.elastic = elastic, .friction_peak = 0.5});
  all_there(SoilModel::drucker_prager, materials::DruckerPrager{.elastic = elastic, .friction = 0.5});
  all_there(SoilModel::multi_yield_clay, materials::multi_yield_clay(elastic, 40e3));
  all_there(SoilModel::pm4sand,
            materials::pm4sand({.density = 1900.0, .relative_density = 0.5, .G_o = 600.0, .h_po = 0.4}));
  all_there(SoilModel::pdmy03, materials::pdmy03({.relative_density = 0.57}));
}

/// Laws that files give by their fields are found by the model's name.
TEST(LawKeys, FieldsAreThoseOfTheLawOfTheName) {
  materials::Law law = materials::law_of_fields("mohr_coulomb").value();
  const auto fields = materials::fields(law);
  ASSERT_EQ(fields.size(), 7U);
  *fields[0].value = 5e3;
  EXPECT_EQ(std::get<materials::MohrCoulomb>(law).cohesion_peak, 5e3);
  EXPECT_TRUE(materials::law_of_fields("linear_elastic").has_value());
  EXPECT_FALSE(materials::law_of_fields("pm4sand").has_value());
  EXPECT_FALSE(materials::law_of_fields("no_such_law").has_value());
}

} // namespace
} // namespace tremolo::scene::testing
