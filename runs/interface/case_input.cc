#include "runs/interface/case_input.h"

#include "meshing/errors.h"
#include "runs/interface/warnings.h"
#include "solver/closed_form/first_yield.h"
#include "solver/closed_form/plausibility.h"
#include "solver/laws/criterion.h"
#include "solver/problem/quantity.h"

#include <algorithm>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    /// "required", or "required without yield-stress" where another parameter says the same.
    std::string requirement(const CaseParameter &parameter)
    {
      std::vector<std::string> others;
      for (const CaseParameter &other : case_parameters())
        if (other.instead_of == parameter.name || other.makes_needless == parameter.name)
          others.push_back(other.option());
      return others.empty() ? "required" : "required without " + one_of(others);
    }

    /// "drucker-prager: K, from 0.778 to 1 (the circular cone) [1]"
    std::string help_of(const CaseParameter &parameter)
    {
      std::string help = parameter.owners.empty() ? "" : one_of(parameter.owners) + ": ";
      help += parameter.help;
      if (!parameter.example.empty())
        help += ", as " + parameter.example;
      if (!parameter.default_text.empty())
        help += " [" + parameter.default_text + "]";
      else if (parameter.default_value)
        help += " [" + format_quantity(*parameter.default_value, parameter.dimension) + "]";
      else if (parameter.instead_of.empty())
        help += " [" + requirement(parameter) + "]";
      return help;
    }

    Setting setting_of(const CaseParameter &parameter)
    {
      return quantity_setting(parameter.option(), help_of(parameter), parameter.dimension, true);
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

    /// The axis of a stored parameter: given as itself, in another way, or left out.
    Axis read_axis(const SettingTexts &texts, const CaseParameter &stored)
    {
      bool needless = false;
      for (const CaseParameter &parameter : case_parameters())
        if (const auto text = find(texts, parameter.option()))
          {
            if (parameter.name == stored.name || parameter.instead_of == stored.name)
              return {&parameter, parse_quantities(parameter.option(), *text, parameter.dimension)};
            needless = needless || parameter.makes_needless == stored.name;
          }
      if (needless)
        return {&stored, {}};
      if (!stored.may_be_left_out())
        throw InputError(stored.option() + " is missing: give --" + stored.option() + " or 'set " +
                         stored.option() + " = …' in a parameter file");
      return {&stored, {stored.default_value.value_or(std::nan(""))}};
    }

    /// Without what no single parameter can tell: whether force and radius go with the material.
    Case case_at(const Criterion                 criterion,
                 const std::vector<Axis>        &axes,
                 const std::vector<std::size_t> &place)
    {
      Case next{};
      next.material.criterion = criterion;
      bool is_rock            = false;
      for (std::size_t i = 0; i < axes.size(); ++i)
        if (!axes[i].values.empty())
          {
            axes[i].parameter->set(next, axes[i].values[place[i]]);
            is_rock = is_rock || axes[i].parameter->name == "sigma_c";
          }
      if (const auto convert = definition_of(criterion).from_rock; is_rock && convert)
        convert(next.material);
      next.material.check();
      return next;
    }

    /// A force that was given as a load level is made one; what cannot be a contact is refused.
    void complete(const std::vector<Axis> &axes, Case &input)
    {
      for (const Axis &axis : axes)
        if (axis.parameter->name == "load_level")
          input.scene.force_max *= first_yield(input.material, input.scene).force;
      with_case(input, [&] { check_possible(input); });
    }

    std::vector<Axis> read_axes(const SettingTexts &texts)
    {
      std::vector<Axis> axes;
      for (const CaseParameter &parameter : stored_parameters())
        axes.push_back(read_axis(texts, parameter));
      return axes;
    }

    std::size_t count_cases(const std::vector<Axis> &axes)
    {
      std::size_t count = 1;
      for (const Axis &axis : axes)
        {
          count *= std::max<std::size_t>(1, axis.values.size()); // either is at most 10⁶
          if (count > largest_grid)
            throw InputError("the lists span more than " + std::to_string(largest_grid) +
                             " cases: shorten them, or make several grids");
        }
      return count;
    }

    /// What a setting of the second body says: a number, a word such as "rigid", or nothing.
    std::string said_of_second(const SettingTexts &texts, const CaseParameter &parameter)
    {
      return parameter.of_second_body ? find(texts, second_option(parameter)).value_or("") : "";
    }

    /// A word: the second body is rigid, or flat.
    bool says_word(const CaseParameter &parameter, const std::string &text)
    {
      return !parameter.second_word.empty() && text == parameter.second_word;
    }

    /// The texts of the second body's material as if it were the first: what is said of it, and for
    /// the rest what is said of the first (never what followed from that). Of two ways to give one
    /// number, what is said of the second body counts.
    SettingTexts texts_of_second(const SettingTexts &texts)
    {
      SettingTexts result;
      for (const CaseParameter &parameter : case_parameters())
        if (const auto text = find(texts, parameter.option()); text && !parameter.of_scene)
          result[parameter.option()] = *text;
      if (const auto criterion = find(texts, "criterion"))
        result["criterion"] = *criterion;
      for (const CaseParameter &parameter : case_parameters())
        {
          const std::string text = said_of_second(texts, parameter);
          if (text.empty() || parameter.of_scene || says_word(parameter, text))
            continue;
          for (const CaseParameter &other : case_parameters())
            if (const bool same = other.name == parameter.instead_of ||
                                  other.instead_of == parameter.name ||
                                  other.name == parameter.makes_needless;
                same && said_of_second(texts, other).empty())
              result.erase(other.option());
          result[parameter.option()] = text;
        }
      return result;
    }

    Material read_second_material(const SettingTexts &texts)
    {
      try
        {
          return read_body(texts_of_second(texts)).material;
        }
      catch (const InputError &error)
        {
          throw InputError(std::string("second body: ") + error.what());
        }
    }

    /// @return unset where none of its settings is given.
    std::optional<SecondBody> read_second_body(const SettingTexts &texts, const double first_radius)
    {
      for (const Setting &setting : second_body_settings())
        if (const auto text = find(texts, setting.name); text && !text->empty())
          setting.check(*text);
      bool        any = false, rigid = false, flat = false;
      SecondBody  body;
      std::string given; // of the material, besides "rigid"
      body.radius = first_radius;
      for (const CaseParameter &parameter : case_parameters())
        {
          const std::string text = said_of_second(texts, parameter);
          any                    = any || !text.empty();
          if (says_word(parameter, text))
            (parameter.of_scene ? flat : rigid) = true;
          else if (!text.empty() && !parameter.of_scene)
            given = second_option(parameter);
          else if (!text.empty())
            body.radius = parse_quantity(second_option(parameter), text, parameter.dimension);
        }
      if (!any)
        return std::nullopt;
      if (rigid && !given.empty())
        throw InputError(given + " is set, but the second body is rigid: leave it out");
      if (flat)
        body.radius = SecondBody{}.radius;
      if (!rigid)
        body.material = read_second_material(texts);
      return body;
    }
  } // namespace

  std::vector<Setting> material_settings()
  {
    std::vector<Setting> settings = {
      choice_setting("criterion",
                     "yield criterion: " + one_of(enum_names<Criterion>()) + " [" +
                       to_string(Material{}.criterion) + "]",
                     enum_names<Criterion>())};
    for (const CaseParameter &parameter : case_parameters())
      if (!parameter.of_scene)
        settings.push_back(setting_of(parameter));
    return settings;
  }

  std::vector<Setting> body_settings()
  {
    return material_settings() + std::vector{setting_of(case_parameter("radius"))};
  }

  std::vector<Setting> scene_settings()
  {
    std::vector<Setting> settings = material_settings();
    for (const CaseParameter &parameter : case_parameters())
      if (parameter.of_scene)
        settings.push_back(setting_of(parameter));
    return settings;
  }

  std::vector<Case> read_grid(const SettingTexts &texts)
  {
    const Criterion         criterion = read_criterion(texts);
    const std::vector<Axis> axes      = read_axes(texts);
    std::vector<Case>       cases;
    cases.reserve(count_cases(axes));

    // An odometer: the last axis turns fastest.
    std::vector<std::size_t> place(axes.size(), 0);
    for (;;)
      {
        cases.push_back(case_at(criterion, axes, place));
        complete(axes, cases.back());
        std::size_t i = axes.size();
        while (i > 0 && ++place[i - 1] >= axes[i - 1].values.size())
          place[--i] = 0;
        if (i == 0)
          return cases;
      }
  }

  namespace
  {
    /// A case that is not complete yet, of texts without lists.
    std::pair<Case, std::vector<Axis>> read_single(const SettingTexts &texts)
    {
      for (const CaseParameter &parameter : case_parameters())
        if (const auto text = find(texts, parameter.option()))
          parse_quantity(parameter.option(), *text, parameter.dimension); // a list is no number
      const Criterion   criterion = read_criterion(texts);
      std::vector<Axis> axes      = read_axes(texts);
      return {case_at(criterion, axes, std::vector<std::size_t>(axes.size(), 0)), axes};
    }
  } // namespace

  Case read_case(const SettingTexts &texts)
  {
    auto [input, axes] = read_single(texts);
    input.scene.second = read_second_body(texts, input.scene.radius);
    complete(axes, input);
    return input;
  }

  Case read_body(const SettingTexts &texts) { return read_single(texts).first; }

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
} // namespace dpcontact
