#include "runs/commands/sweep_options.h"

#include "runs/commands/options.h"
#include "runs/interface/case_input.h"
#include "runs/interface/outputs.h"
#include "solver/parallel/launcher.h"
#include "solver/path/families.h"
#include "solver/problem/quantity.h"

#include <algorithm>
#include <thread>

namespace dpcontact::commands
{
  std::vector<Setting> sweep_settings()
  {
    return {count_setting("jobs", "worker processes [all cores]"),
            choice_setting("mode",
                           "direct: every row for itself; families: one loading path for rows of "
                           "equal nu and phi [direct]",
                           enum_names<SweepMode>()),
            text_setting("database",
                         "HDF5 file; finished rows are kept in FILE.rows beside it "
                         "[the parameter file's name with .h5, here]")};
  }

  void add_replace_flag(CLI::App &command, bool &replace)
  {
    command.add_flag("--replace",
                     replace,
                     "leave rows of other grids out of the database, which keeps them otherwise");
  }

  Sweep read_sweep(const std::string &parameter_file, const SettingTexts &given)
  {
    const SettingTexts texts =
      merged(parameter_file, scene_settings() + solver_settings() + sweep_settings(), given);
    Sweep sweep;
    sweep.cases  = read_grid(texts);
    sweep.solver = read_solver_options(texts);

    const auto database = texts.find("database");
    if (database == texts.end())
      sweep.database = std::filesystem::path(parameter_file).filename().replace_extension(".h5");
    else if (database->second.empty())
      throw InputError("database: is empty");
    else
      sweep.database = database->second;

    const std::string ending = sweep.database.extension().string();
    if (ending != ".h5" && ending != ".hdf5")
      throw InputError("database: " + sweep.database.string() +
                       " is to be an HDF5 file, so its name must end in .h5 or .hdf5; dpcontact "
                       "export writes other formats of it");
    check_files({{parameter_file}, {sweep.database}});

    const auto mode = texts.find("mode");
    if (mode != texts.end())
      {
        sweep.mode = parse_enum<SweepMode>(mode->second);
        if (sweep.mode == SweepMode::families)
          for (const Case &input : sweep.cases)
            check_similar(input.material);
      }

    const auto         jobs  = texts.find("jobs");
    const unsigned int ranks = launched_ranks();
    if (ranks > 1)
      {
        if (jobs != texts.end())
          throw InputError("jobs: '" + jobs->second +
                           "' is set, but under MPI the launcher decides (" +
                           std::to_string(ranks) + " ranks, mpirun -np); leave jobs out");
        sweep.jobs = ranks;
      }
    else
      sweep.jobs = jobs == texts.end() ? std::max(1U, std::thread::hardware_concurrency())
                                       : parse_count("jobs", jobs->second);
    if (sweep.jobs == 0)
      throw InputError("jobs: '0' is too few; there must be at least 1");
    return sweep;
  }
} // namespace dpcontact::commands
