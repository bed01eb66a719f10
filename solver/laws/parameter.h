#ifndef DPCONTACT_SOLVER_LAWS_PARAMETER_H
#define DPCONTACT_SOLVER_LAWS_PARAMETER_H

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace dpcontact
{
  enum class Criterion; // material.h

  /// What a number measures, and so in which unit it is kept.
  enum class Dimension
  {
    pressure, ///< Pa
    length,   ///< m
    force,    ///< N
    density,  ///< kg/m3
    velocity, ///< m/s
    angle,    ///< degrees
    number    ///< no unit
  };

  /// The unit in which numbers of a dimension are kept, as it stands in the names of columns: "Pa",
  /// "m", "N", "kg/m3", "m/s", "deg"; "1" of a number without one.
  const char *unit_of(Dimension dimension);

  /// The values that a number may have. All are finite.
  struct Range
  {
    double low       = 0;
    double high      = std::numeric_limits<double>::infinity();
    bool   open_low  = false; ///< `low` itself is outside
    bool   open_high = false; ///< `high` itself is outside

    bool contains(double value) const;

    /// "finite and greater than 0", "at least 0 and less than 90 degrees"
    std::string text(Dimension dimension) const;
  };

  /// One parameter of something that a user describes: a material, a scene. It has one entry in one
  /// list, and everything that names it follows from that entry: the option --sigma-c, the JSON key
  /// sigma_c, the column sigma_c_Pa, help, range check, labels and messages.
  template <class Owner>
  struct Parameter
  {
    std::string name;        ///< with underscores: "sigma_c"
    std::string symbol;      ///< in labels and messages: "sigma_c", "K"
    std::string title;       ///< in messages: "uniaxial compressive strength sigma_c"
    std::string help;        ///< of the option
    std::string description; ///< of the column
    Dimension   dimension = Dimension::number;
    Range       range     = {};
    std::string example   = {}; ///< what may stand after the option: "15MPa"

    std::vector<Criterion> owners = {}; ///< criteria that have it; empty: all

    /// The value where none is given, in SI units and degrees; unset: one must be given.
    std::optional<double> default_value = {};
    /// The default as help says it, where it is no number: "phi: associated".
    std::string default_text = {};

    std::function<double(const Owner &)> get = {}; ///< empty: it is only another way to give one
    std::function<void(Owner &, double value)> set = {};

    /// It describes the scene, not a material: labels show it also where it is at its default.
    bool of_scene = false;

    /// The parameter that this one is another way to give, by its name: `set` then makes that one's
    /// value of this one's.
    std::string instead_of = {};
    /// A parameter that may not be given beside this one, because this one leaves nothing to it.
    std::string makes_needless = {};
    /// A second body may have another value: there is an option of its own, --sigma-c-2.
    bool of_second_body = true;
    /// What may stand there instead of a number: "rigid" of E, "flat" of the radius.
    std::string second_word = {};

    /// The option without its dashes: "sigma-c".
    std::string option() const;
    /// The key in JSON documents: "sigma_c", "phi_deg".
    std::string key() const;
    /// The column of tables: "sigma_c_Pa", "phi_deg", "nu".
    std::string column() const;
    /// Whether materials of a criterion have it.
    bool belongs_to(Criterion criterion) const;
    /// Whether the case is complete without it.
    bool may_be_left_out() const { return default_value.has_value() || !default_text.empty(); }
  };

  std::string option_name(const std::string &name);
  std::string key_name(const std::string &name, Dimension dimension);
  std::string column_name(const std::string &name, Dimension dimension);

  template <class Owner>
  bool Parameter<Owner>::belongs_to(const Criterion criterion) const
  {
    return owners.empty() || std::find(owners.begin(), owners.end(), criterion) != owners.end();
  }
  template <class Owner>
  std::string Parameter<Owner>::option() const
  {
    return option_name(name);
  }
  template <class Owner>
  std::string Parameter<Owner>::key() const
  {
    return key_name(name, dimension);
  }
  template <class Owner>
  std::string Parameter<Owner>::column() const
  {
    return column_name(name, dimension);
  }

  /// @throws InputError "TITLE is VALUE UNIT; it must be RANGE." unless the range holds the value.
  void check_range(const std::string &title, double value, Dimension dimension, const Range &range);

  /// @throws InputError "TITLE is VALUE UNIT; it must be RANGE.".
  [[noreturn]] void refuse_value(const std::string &title,
                                 double             value,
                                 Dimension          dimension,
                                 const std::string &range);
} // namespace dpcontact

#endif
