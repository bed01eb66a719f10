#include "runs/interface/parameter_file.h"

#include "meshing/errors.h"

#include <deal.II/base/parameter_handler.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <regex>
#include <sstream>
#include <system_error>

namespace dpcontact
{
  namespace
  {
    /// Stands for an entry that a file does not set; never a valid value of a setting.
    const std::string unset = "<unset>";

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
            *complaint = error.what();
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

    /// deal.II's "Line <3> of file <x.prm>: some\n  paragraphs" as "x.prm:3: some paragraphs".
    std::string one_line(const dealii::ExceptionBase &exception)
    {
      std::ostringstream stream;
      exception.print_info(stream);
      std::string text = std::regex_replace(stream.str(), std::regex("\\s+"), " ");
      text             = std::regex_replace(text, std::regex("^ | $"), "");
      return std::regex_replace(text, std::regex("Line <([0-9]+)> of file <(.*?)>: ?"), "$2:$1: ");
    }

    std::string location(const dealii::ExceptionBase &exception)
    {
      std::smatch       found;
      const std::string text = one_line(exception);
      return std::regex_search(text, found, std::regex("^.*?:[0-9]+: ")) ? found.str() : "";
    }
  } // namespace

  SettingTexts read_parameter_file(const std::filesystem::path &file,
                                   const std::vector<Setting>  &allowed)
  {
    std::error_code ignored;
    if (std::filesystem::is_directory(file, ignored))
      throw FileError("cannot read parameter file '" + file.string() + "': it is a directory");
    std::ifstream input(file);
    if (!input)
      throw FileError("cannot read parameter file '" + file.string() +
                      "': " + std::strerror(errno));

    const auto               complaint = std::make_shared<std::string>();
    dealii::ParameterHandler handler;
    for (const Setting &setting : allowed)
      handler.declare_entry(setting.name, unset, SettingPattern(setting, complaint), setting.help);

    try
      {
        handler.parse_input(input, file.string());
      }
    catch (const dealii::ParameterHandler::ExcInvalidEntryForPattern &exception)
      {
        throw InputError(location(exception) + *complaint);
      }
    catch (const dealii::ExceptionBase &exception)
      {
        throw InputError(one_line(exception));
      }

    SettingTexts texts;
    for (const Setting &setting : allowed)
      if (const std::string text = handler.get(setting.name); text != unset)
        texts[setting.name] = text;
    return texts;
  }
} // namespace dpcontact
