// Writes sample.h5, sample.csv and sample.json (the rows by another way) into the directory given.

#include "database/rows/exports.h"
#include "database/rows/row_json.h"
#include "tests/support/records.h"

#include <nlohmann/json.hpp>

int main(int, char **arguments)
{
  using namespace dpcontact;
  using namespace dpcontact::testing_database;
  const fs::path directory = arguments[1];
  Database       database;
  nlohmann::json rows = nlohmann::json::array();
  for (std::uint64_t seed = 0; seed < 6; ++seed)
    {
      database.records.push_back(any_record(seed, seed == 3 ? 0 : 5));
      rows.push_back(to_json(database.records.back()));
    }
  database.provenance = {{"git_revision", "0123abc"}, {"input", "φ = 20°"}};
  write_store(directory / "sample.h5", database);
  write_csv(directory / "sample.csv", database);
  spill(directory / "sample.json", rows.dump());
}
