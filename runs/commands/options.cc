#include "runs/commands/options.h"

#include "runs/commands/solver_parts.h"

namespace dpcontact::commands
{
  void add_settings(CLI::App                   &command,
                    const std::vector<Setting> &settings,
                    SettingTexts               &texts,
                    const std::string          &group)
  {
    for (const Setting &setting : settings)
      command
        .add_option_function<std::string>(
          "--" + setting.name,
          [&texts, name = setting.name](const std::string &text) { texts[name] = text; },
          setting.help)
        ->type_name("")
        ->group(group);
  }

  void add_settings(CLI::App                                   &command,
                    const std::vector<Setting>                 &settings,
                    SettingTexts                               &texts,
                    const std::string                          &group,
                    const std::function<bool(const Setting &)> &shown)
  {
    // What has no group stands in no help of CLI11.
    for (const Setting &setting : settings)
      add_settings(command, {setting}, texts, shown(setting) ? group : "");
  }

  void add_parameter_file(CLI::App &command, std::string &file)
  {
    command.add_option("--parameter-file", file, "a file that says the same; options override it")
      ->type_name("FILE.prm");
  }

  void add_json_flag(CLI::App &command, bool &json)
  {
    command.add_flag("--json", json, "print one JSON document in SI units on standard output");
  }

  SettingTexts merged(const std::string          &parameter_file,
                      const std::vector<Setting> &allowed,
                      const SettingTexts         &command_line)
  {
    SettingTexts texts = command_line;
    if (!parameter_file.empty())
      texts.merge( // keeps what is there already
        solver_parts("--parameter-file").read_parameter_file(parameter_file, allowed));
    return texts;
  }
} // namespace dpcontact::commands
