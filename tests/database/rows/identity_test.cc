#include "database/rows/identity.h"
#include "database/rows/row_json.h"
#include "database/rows/row_store.h"
#include "meshing/errors.h"
#include "solver/laws/criterion.h"
#include "solver/problem/option_list.h"
#include "tests/support/records.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <map>

using namespace dpcontact;
using namespace dpcontact::testing_database;

namespace
{
  using IdentityTest = InDirectory;

  /// A value that the option may have, other than the one it has.
  std::string another_value(const SolverOption &option, const SolverOptions &options)
  {
    const std::string present = option.text(options);
    for (const std::string &choice : option.choices)
      if (choice != present)
        return choice;
    static const std::map<std::string, std::string> numbers = {{"sector-angle", "90"},
                                                               {"resolution", "12"},
                                                               {"level", "1"},
                                                               {"octaves", "2"},
                                                               {"domain-radius", "150"},
                                                               {"outer-radius", "20mm"},
                                                               {"mesh-stretch", "1.5"},
                                                               {"mesh-distortion", "0.1"},
                                                               {"step-tolerance", "0.01"},
                                                               {"loading-steps", "32"},
                                                               {"penalty-stiffness", "1000"}};
    const auto                                      found   = numbers.find(option.name);
    EXPECT_NE(found, numbers.end()) << option.name << " is new: give a value for this test";
    return found == numbers.end() ? "" : found->second;
  }

  /// Options with which the computation depends on this one.
  SolverOptions options_with(const SolverOption &option)
  {
    for (const Geometry geometry : {Geometry::axisymmetric, Geometry::sector, Geometry::published})
      if (const SolverOptions options = SolverOptions::of(geometry); option.counts(options))
        return options;
    ADD_FAILURE() << option.name << " never counts";
    return {};
  }

  /// A rock of a criterion all of whose parameters are given, each a number of its own.
  Case complete_case(const CriterionDefinition &definition)
  {
    Case input{{10e9, 0.15, Angle(definition.has_friction_angle ? 25 : 0), 15e6}, {0.05, 70, {}}};
    input.material.criterion = definition.criterion;
    double share             = 0.8;
    for (const MaterialParameter &own : definition.parameters)
      if (own.instead_of.empty())
        {
          const double largest = own.dimension == Dimension::angle      ? 25.
                                 : own.dimension == Dimension::pressure ? 1e6
                                                                        : 1.;
          own.set(input.material, largest * (share += 0.01));
        }
    input.material.check();
    return input;
  }
} // namespace

TEST_F(IdentityTest, EveryOptionThatIsChangedRefusesTheRows)
{
  std::size_t judged = 0;
  for (const SolverOption &option : solver_options())
    {
      const SolverOptions before = options_with(option);
      SolverOptions       after  = before;
      option.read(after, another_value(option, before));
      const fs::path database = directory / (option.name + ".h5");
      RowStore(database, identity_json(before));
      const std::string message =
        message_of<SettingsMismatch>([&] { RowStore(database, identity_json(after)); });
      EXPECT_NE(message.find(option.name), std::string::npos) << message;
      ++judged;
    }
  EXPECT_EQ(judged, 23U);
}

TEST(Identity, EveryInputThatIsChangedIsAnotherKey)
{
  const Case        before{{10e9, 0.15, Angle(25), 15e6}, {}};
  std::set<CaseKey> seen{key_of(before)};
  for (const CaseParameter &parameter : stored_parameters())
    {
      Case         after = before;
      const double value = parameter.get(before);
      parameter.set(after, std::isnan(value) ? 1e5 : 0.8 * value + 0.01);
      EXPECT_TRUE(seen.insert(key_of(after)).second) << parameter.name;
      EXPECT_NE(key_json(after), key_json(before)) << parameter.name;
    }
  Case after               = before;
  after.material.criterion = Criterion::mohr_coulomb;
  EXPECT_TRUE(seen.insert(key_of(after)).second);
}

// The case of a row comes back whatever its criterion has, so that it can be computed again.
TEST(Identity, TheCaseOfARowComesBackForEveryCriterion)
{
  for (const CriterionDefinition &definition : criteria())
    for (const bool complete : {true, false})
      {
        Record record = any_record(2);
        record.input  = complete_case(definition);
        if (!complete)
          for (const MaterialParameter &own : definition.parameters)
            if (own.instead_of.empty())
              own.set(record.input.material, own.default_value.value_or(std::nan("")));
        const Record read = record_from_json(nlohmann::json::parse(to_json(record).dump()));
        EXPECT_TRUE(read.input == record.input) << label(record.input);
        EXPECT_EQ(key_of(read.input), key_of(record.input));
      }
}
