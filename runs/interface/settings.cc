#include "runs/interface/settings.h"

#include "meshing/errors.h"
#include "solver/problem/option_list.h"
#include "solver/problem/quantity.h"

#include <algorithm>

namespace dpcontact
{
  Setting quantity_setting(const std::string &name,
                           const std::string &help,
                           const Dimension    dimension,
                           const bool         list)
  {
    return {name, help, [name, dimension, list](const std::string &text) {
              if (list)
                parse_quantities(name, text, dimension);
              else
                parse_quantity(name, text, dimension);
            }};
  }

  Setting count_setting(const std::string &name, const std::string &help)
  {
    return {name, help, [name](const std::string &text) { parse_count(name, text); }};
  }

  Setting choice_setting(const std::string              &name,
                         const std::string              &help,
                         const std::vector<std::string> &choices)
  {
    return {name, help, [name, choices](const std::string &text) {
              if (std::find(choices.begin(), choices.end(), text) == choices.end())
                throw InputError(name + ": '" + text + "' is not one of " + one_of(choices));
            }};
  }

  Setting text_setting(const std::string &name, const std::string &help)
  {
    return {name, help, [name](const std::string &text) {
              if (text.empty())
                throw InputError(name + ": is empty");
            }};
  }

  std::vector<Setting> operator+(std::vector<Setting> left, const std::vector<Setting> &right)
  {
    left.insert(left.end(), right.begin(), right.end());
    return left;
  }

  std::optional<std::string> find(const SettingTexts &texts, const std::string &name)
  {
    const auto found = texts.find(name);
    return found == texts.end() ? std::nullopt : std::make_optional(found->second);
  }

  std::vector<Setting> solver_settings()
  {
    std::vector<Setting> settings;
    for (const SolverOption &option : solver_options())
      settings.push_back({option.name,
                          option.help + " [" + default_text(option) + "]",
                          [&option](const std::string &text) {
                            SolverOptions scratch;
                            option.read(scratch, text);
                          }});
    return settings;
  }

  SolverOptions read_solver_options(const SettingTexts &texts)
  {
    SolverOptions options;
    for (const SolverOption &option : solver_options())
      if (const auto text = find(texts, option.name))
        option.read(options, *text);
    options.check();
    return options;
  }
} // namespace dpcontact
