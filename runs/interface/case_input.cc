#include "runs/interface/case_input.h"

#include "meshing/errors.h"
#include "solver/closed_form/first_yield.h"
#include "solver/laws/criterion.h"
#include "solver/problem/quantity.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace dpcontact
{
  namespace
  {
    /// "drucker-prager: K, from 0.778 to 1 (the circular cone) [1]"
    std::string help_of(const CaseParameter &parameter)
    {
      std::string help = parameter.owners.empty() ? "" : one_of(parameter.owners) + ": ";
      help += parameter.help;
      if (!parameter.example.empty())
        help += " (" + parameter.example + ")";
      if (!parameter.default_text.empty())
        help += " [" + parameter.default_text + "]";
      else if (parameter.default_value)
        help += " [" + format_quantity(*parameter.default_value, parameter.dimension) + "]";
      return help;
    }

    std::string second_option(const CaseParameter &parameter) { return parameter.option() + "-2"; }

    /// The criterion, refusing what it does not have and what is given in two ways.
    Criterion read_criterion(const SettingTexts &texts)
    {
      const auto      text      = find(texts, "criterion");
      const Criterion criterion = text ? parse_enum<Criterion>(*text) : Criterion::drucker_prager;
      for (const CaseParameter &parameter : case_parameters())
        {
          const std::string name = parameter.option();
          if (!find(texts, name))
            continue;
          if (!parameter.belongs_to(criterion))
            throw InputError(name + " is a parameter of " + one_of(parameter.owners) + ", not of " +
                             to_string(criterion) + ": leave it out");
          if (!parameter.instead_of.empty() && find(texts, option_name(parameter.instead_of)))
            throw InputError(name + " and " + option_name(parameter.instead_of) +
                             " say the same: give one of them");
          if (!parameter.makes_needless.empty() &&
              find(texts, option_name(parameter.makes_needless)))
            throw InputError(parameter.makes_needless + " is set, but " + to_string(criterion) +
                             " with a " + name + " has no " + parameter.makes_needless +
                             ": leave it out");
        }
      return criterion;
    }

    /// One axis of a grid: a parameter as it is given, and its values. No values: nothing is given,
    /// and nothing is needed.
    struct Axis
    {
      const CaseParameter *parameter;
      std::vector<double>  values;
    };

    std::vector<double> read_list(const CaseParameter &parameter, const std::string &text)
    {
      const std::string   name = parameter.option();
      std::vector<double> values;
      std::set<double>    known;
      for (const std::string &part : split_list(text))
        {
          const double value = parse_quantity(name, part, parameter.dimension);
          if (!known.insert(value).second)
            throw InputError(name + ": '" + part + "' stands twice in the list '" +
                             (text.size() > 200 ? text.substr(0, 200) + "…" : text) + "'");
          values.push_back(value);
        }
      return values;
    }

    /// The axis of a stored parameter: given as itself, in another way, or left out.
    Axis read_axis(const SettingTexts &texts, const CaseParameter &stored)
    {
      bool needless = false;
      for (const CaseParameter &parameter : case_parameters())
        if (const auto text = find(texts, parameter.option()))
          {
            if (parameter.name == stored.name || parameter.instead_of == stored.name)
              return {&parameter, read_list(parameter, *text)};
            needless = needless || parameter.makes_needless == stored.name;
          }
      if (needless)
        return {&stored, {}};
      if (!stored.may_be_left_out())
        throw InputError(stored.option() + " is missing: give --" + stored.option() + " or 'set " +
                         stored.option() + " = …' in a parameter file");
      return {&stored, {stored.default_value.value_or(std::nan(""))}};
    }

    Case case_at(const Criterion                 criterion,
                 const std::vector<Axis>        &axes,
                 const std::vector<std::size_t> &place)
    {
      Case next{};
      next.material.criterion = criterion;
      bool   is_rock          = false;
      double load_level       = 0;
      for (std::size_t i = 0; i < axes.size(); ++i)
        if (!axes[i].values.empty())
          {
            const double value = axes[i].values[place[i]];
            axes[i].parameter->set(next, value);
            is_rock = is_rock || axes[i].parameter->name == "sigma_c";
            if (axes[i].parameter->name == "load_level")
              load_level = value;
          }
      if (const auto convert = definition_of(criterion).from_rock; is_rock && convert)
        convert(next.material);
      next.material.check();
      if (load_level != 0)
        next.scene.force_max = load_level * first_yield(next.material, next.scene.radius).force;
      next.scene.check();
      return next;
    }
  } // namespace

  std::vector<Setting> scene_settings()
  {
    std::vector<Setting> settings = {
      choice_setting("criterion",
                     "yield criterion: " + one_of(enum_names<Criterion>()) + " [" +
                       to_string(Material{}.criterion) + "]",
                     enum_names<Criterion>())};
    for (const CaseParameter &parameter : case_parameters())
      settings.push_back(
        quantity_setting(parameter.option(), help_of(parameter), parameter.dimension, true));
    return settings;
  }

  std::vector<Case> read_grid(const SettingTexts &texts)
  {
    const Criterion   criterion = read_criterion(texts);
    std::vector<Axis> axes;
    for (const CaseParameter &parameter : stored_parameters())
      axes.push_back(read_axis(texts, parameter));

    std::size_t count = 1;
    for (const Axis &axis : axes)
      {
        count *= std::max<std::size_t>(1, axis.values.size()); // either is at most 10⁶
        if (count > largest_grid)
          throw InputError("the lists span more than " + std::to_string(largest_grid) +
                           " cases: shorten them, or make several grids");
      }

    // An odometer: the last axis turns fastest.
    std::vector<Case>        cases;
    std::vector<std::size_t> place(axes.size(), 0);
    for (;;)
      {
        cases.push_back(case_at(criterion, axes, place));
        std::size_t i = axes.size();
        while (i > 0 && ++place[i - 1] >= axes[i - 1].values.size())
          place[--i] = 0;
        if (i == 0)
          return cases;
      }
  }

  Case read_case(const SettingTexts &texts)
  {
    for (const CaseParameter &parameter : case_parameters())
      if (const auto text = find(texts, parameter.option()))
        parse_quantity(parameter.option(), *text, parameter.dimension); // a list is no number
    return read_grid(texts).front();
  }

  std::vector<Setting> second_body_settings()
  {
    std::vector<Setting> settings;
    for (const CaseParameter &parameter : case_parameters())
      if (parameter.of_second_body)
        {
          const std::string name = second_option(parameter), &word = parameter.second_word;
          const Setting     number = quantity_setting(name, "", parameter.dimension);
          settings.push_back({name,
                              parameter.help + " of the second body" +
                                (word.empty() ? "" : ", or " + word) + " [" + parameter.option() +
                                "]",
                              [number, word](const std::string &text) {
                                if (word.empty() || text != word)
                                  number.check(text);
                              }});
        }
    return settings;
  }

  void read_second_body(const SettingTexts &texts, Case &input)
  {
    Case        second{input.material, input.scene};
    bool        any = false, rigid = false, flat = false;
    std::string given; // of the material, besides "rigid"
    for (const Setting &setting : second_body_settings())
      if (const auto text = find(texts, setting.name))
        setting.check(*text);
    for (const CaseParameter &parameter : case_parameters())
      {
        const std::string name = second_option(parameter);
        const auto        text = parameter.of_second_body ? find(texts, name) : std::nullopt;
        if (!text || text->empty())
          continue;
        any = true;
        if (!parameter.second_word.empty() && *text == parameter.second_word)
          {
            (parameter.name == "radius" ? flat : rigid) = true;
            continue;
          }
        if (parameter.name == "phi" && !definition_of(input.material.criterion).has_friction_angle)
          throw InputError(name + " is set, but " + to_string(input.material.criterion) +
                           " has no friction angle: leave it out");
        parameter.set(second, parse_quantity(name, *text, parameter.dimension));
        if (parameter.name != "radius")
          given = name;
      }
    if (!any)
      return;
    if (rigid && !given.empty())
      throw InputError(given + " is set, but the second body is rigid: leave it out");

    SecondBody body;
    if (!flat)
      body.radius = second.scene.radius;
    if (!rigid)
      body.material = second.material;
    input.scene.second = body;
    input.scene.check();
  }
} // namespace dpcontact
