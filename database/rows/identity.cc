#include "database/rows/identity.h"

#include "solver/problem/option_list.h"

#include <nlohmann/json.hpp>

namespace dpcontact
{
  nlohmann::json key_json(const Case &input)
  {
    const CaseKey  key  = key_of(input);
    nlohmann::json list = nlohmann::json::array({key.first});
    for (const double value : key.second)
      list.push_back(value);
    return list;
  }

  nlohmann::json identity_json(const SolverOptions &options)
  {
    nlohmann::json identity = nlohmann::json::object();
    for (const SolverOption &option : solver_options())
      if (option.counts(options))
        std::visit([&](const auto &value) { identity[option.name] = value; }, option.get(options));
    return identity;
  }
} // namespace dpcontact
