#include "runs/interface/parameter_file.h"

#include "database/files/regular_file.h"
#include "meshing/errors.h"
#include "runs/interface/spelling.h"

#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>
#include <regex>
#include <sstream>

namespace dpcontact
{
  namespace
  {
    /// Stands for an entry that a file does not set; never a valid value of a setting.
    const std::string unset = "<unset>";

    /// Messages repeat what was read, which may be as long as a file; std::regex takes stack for
    /// every character.
    std::string shortened(const std::string &message)
    {
      constexpr std::size_t longest = 2000;
      return message.size() > longest ? message.substr(0, longest) + "…" : message;
    }

    /// Lets deal.II check an entry while it still knows the line.
    class SettingPattern : public dealii::Patterns::PatternBase
    {
    public:
      SettingPattern(const Setting &checked, std::shared_ptr<std::string> why)
        : setting(checked)
        , complaint(std::move(why))
      {}

      bool match(const std::string &text) const override
      {
        if (text == unset)
          return true;
        try
          {
            setting.check(text);
            return true;
          }
        catch (const InputError &error)
          {
            *complaint = shortened(error.what());
            return false;
          }
      }

      std::string description(const OutputStyle = Machine) const override { return setting.help; }

      std::unique_ptr<PatternBase> clone() const override
      {
        return std::make_unique<SettingPattern>(setting, complaint);
      }

    private:
      Setting                      setting;
      std::shared_ptr<std::string> complaint; ///< why the last text did not match
    };

    /// White space at the ends removed, and any other run of it made one blank.
    std::string with_single_blanks(const std::string &text)
    {
      std::istringstream words(text);
      std::string        result;
      for (std::string word; words >> word;)
        result += (result.empty() ? "" : " ") + word;
      return result;
    }

    /// deal.II's "Line <3> of file <x.prm>: some\n  paragraphs" as "x.prm:3: some paragraphs".
    std::string message_of(const dealii::ExceptionBase &exception)
    {
      std::ostringstream stream;
      exception.print_info(stream);
      const std::string text = shortened(with_single_blanks(stream.str()));
      return std::regex_replace(text, std::regex("Line <([0-9]+)> of file <(.*?)>: ?"), "$2:$1: ");
    }

    std::string location(const dealii::ExceptionBase &exception)
    {
      std::smatch       found;
      const std::string text = message_of(exception);
      return std::regex_search(text, found, std::regex("^.*?:[0-9]+: ")) ? found.str() : "";
    }

    /// How many files may include each other, and how large each may be.
    constexpr std::size_t    deepest_include = 8;
    constexpr std::uintmax_t largest_file    = std::uintmax_t(1) << 24;

    /// The name of an entry "set NAME = VALUE"; empty where the line is none.
    std::string entry_name(const std::string &line)
    {
      const auto equals = line.find('=');
      if (equals == std::string::npos || (line.rfind("set ", 0) != 0 && line.rfind("SET ", 0) != 0))
        return "";
      return dealii::Utilities::trim(line.substr(4, equals - 4));
    }

    /// deal.II's reader, which calls its own parse_input() for a file that is included.
    class LimitedHandler : public dealii::ParameterHandler
    {
    public:
      /// @param known the names of all entries.
      explicit LimitedHandler(std::vector<std::string> known)
        : names(std::move(known))
      {}

      using dealii::ParameterHandler::parse_input;

      void parse_input(std::istream      &input,
                       const std::string &file,
                       const std::string &last_line,
                       const bool         skip_undefined) override
      {
        std::istringstream lines(checked_lines(input, file));
        ++depth;
        dealii::ParameterHandler::parse_input(lines, file, last_line, skip_undefined);
        --depth;
      }

    private:
      std::size_t              depth = 0;
      std::vector<std::string> names;

      /// The lines, every entry that goes on over several joined in the first of them (the others
      /// become empty, so that numbers of lines stay), without comments. What they include is
      /// looked at before deal.II opens it.
      std::string checked_lines(std::istream &input, const std::string &file) const
      {
        std::string                        result;
        std::map<std::string, std::size_t> seen; // the line of an entry
        std::size_t                        number = 0;
        for (std::string line; std::getline(input, line);)
          {
            const std::size_t first = ++number;
            if (first == 1 && line.rfind("\xEF\xBB\xBF", 0) == 0)
              line.erase(0, 3); // the mark that some editors put before UTF-8
            std::string entry = dealii::Utilities::trim(line), empty_lines;
            while (!entry.empty() && entry.back() == '\\')
              {
                entry.pop_back();
                if (!std::getline(input, line))
                  break;
                ++number;
                entry += dealii::Utilities::trim(line);
                empty_lines += '\n';
              }
            entry = with_single_blanks(entry.substr(0, entry.find('#')));
            if (entry.rfind("include ", 0) == 0 || entry.rfind("INCLUDE ", 0) == 0)
              check_included(entry.substr(8), file);
            else
              check_entry(entry, file + ":" + std::to_string(first) + ": ", seen, first);
            result += entry + '\n' + empty_lines;
          }
        return result;
      }

      /// An entry is known, stands once in its file (one that the file includes it may override),
      /// and is not without its "set".
      void check_entry(const std::string                  &entry,
                       const std::string                  &place,
                       std::map<std::string, std::size_t> &seen,
                       const std::size_t                   line) const
      {
        const std::string name   = entry_name(entry);
        const auto        equals = entry.find('=');
        if (name.empty())
          {
            const std::string word = dealii::Utilities::trim(entry.substr(0, equals));
            if (equals != std::string::npos && !nearest(word, names).empty())
              throw InputError(place + "'" + shortened(entry) + "' is no entry: write 'set " +
                               nearest(word, names) + " =" + shortened(entry.substr(equals + 1)) +
                               "'");
            return;
          }
        if (std::find(names.begin(), names.end(), name) == names.end())
          throw InputError(place + "there is no entry " + shortened(name) +
                           suggestion(name, names));
        const auto [earlier, is_new] = seen.emplace(name, line);
        if (!is_new)
          throw InputError(place + name + " is set twice, first in line " +
                           std::to_string(earlier->second) + ": leave one of them out");
      }

      void check_included(const std::string &included, const std::string &file) const
      {
        if (depth >= deepest_include)
          throw InputError(file + " includes " + included + ", which is more than " +
                           std::to_string(deepest_include) +
                           " files deep: does a file include itself?");
        require_regular_file(included, largest_file);
      }
    };
  } // namespace

  SettingTexts read_parameter_file(const std::filesystem::path &file,
                                   const std::vector<Setting>  &allowed)
  {
    require_regular_file(file, largest_file);
    std::ifstream input(file);
    if (!input)
      throw FileError("cannot read " + file.string() + ": " + std::strerror(errno));

    const auto               complaint = std::make_shared<std::string>();
    std::vector<std::string> names;
    for (const Setting &setting : allowed)
      names.push_back(setting.name);
    LimitedHandler handler(names);
    for (const Setting &setting : allowed)
      handler.declare_entry(setting.name, unset, SettingPattern(setting, complaint), setting.help);

    try
      {
        handler.parse_input(input, file.string(), "", false);
      }
    catch (const dealii::ParameterHandler::ExcInvalidEntryForPattern &exception)
      {
        throw InputError(location(exception) + *complaint);
      }
    catch (const dealii::ExceptionBase &exception)
      {
        throw InputError(message_of(exception));
      }

    SettingTexts texts;
    for (const Setting &setting : allowed)
      if (const std::string text = handler.get(setting.name); text != unset)
        texts[setting.name] = text;
    return texts;
  }
} // namespace dpcontact
