// What commands read besides databases, given altered files: parameter files, held-out curves,
// checkpoints.

#include "database/files/digest.h"
#include "runs/commands/program.h"
#include "runs/commands/solver_parts.h"
#include "runs/interface/checkpoint_file.h"
#include "runs/studies/evaluation.h"
#include "tests/support/fuzzing.h"

#include <sstream>

using namespace dpcontact;
using namespace dpcontact::testing_fuzzing;

namespace
{
  /// Runs the program as from a shell, without what it prints.
  /// @throws Error with the code with which it ends.
  void command(const std::vector<std::string> &words)
  {
    std::vector<const char *> arguments = {"dpcontact"};
    for (const std::string &word : words)
      arguments.push_back(word.c_str());
    std::ostringstream out, messages;
    auto *const        cout = std::cout.rdbuf(out.rdbuf());
    auto *const        cerr = std::cerr.rdbuf(messages.rdbuf());
    const int          code = run_program(
      static_cast<int>(arguments.size()), arguments.data(), &commands::all_solver_parts());
    std::cout.rdbuf(cout);
    std::cerr.rdbuf(cerr);
    if (code != 0)
      throw Error(static_cast<ExitCode>(code), messages.str());
  }

  Reader parameter_reader(const fs::path &directory)
  {
    const fs::path file = directory / "grid.prm";
    return {
      "parameters",
      true,
      {"# a grid\nset E = 10GPa, 20GPa\nset nu = 0.2\nset phi = 20, 30, 35\nset sigma-c = 20MPa\n"
       "set resolution = 12\nset step-tolerance = 1e-2\n",
       "set criterion = mohr-coulomb\nset E = 10GPa\nset nu = 0.25\nset phi = 30\nset cohesion = "
       "1e6\n"
       "set radius = 3mm, 4 \\\n  mm\nset load-level = 0.5, 5, 50 # levels\nset mode = direct\nset "
       "mesh = fitted\n"},
      [file, database = directory / "absent.h5"](const std::string &text) {
        write(file, text);
        command({"sweep", file.string(), "--dry-run", "--json", "--database", database.string()});
      }};
  }

  Reader held_out_reader(const fs::path &directory)
  {
    Json document = Json::parse(read_whole(DPCONTACT_HELD_OUT));
    document["box"].erase(document["box"].begin() + 2, document["box"].end());
    document["paper"].erase(document["paper"].begin() + 1, document["paper"].end());
    const fs::path    file = directory / "held_out.json", universal = directory / "universal.csv";
    const std::string table = few_families(read_whole(DPCONTACT_UNIVERSAL_TABLE));
    write(universal, table);
    write(digest_path_of(universal), sha256(table) + "  universal.csv\n");
    const UniversalTable families = UniversalTable::read(universal);
    for (Json &row : document["box"]) // inside the few families
      {
        row["material"]["nu"]  = (families.nu().front() + families.nu().back()) / 2;
        row["material"]["phi"] = (families.phi_deg().front() + families.phi_deg().back()) / 2;
      }
    return {"held_out",
            true,
            {document.dump(), document.dump(1)},
            [file, universal](const std::string &text) {
              write(file, text);
              command({"evaluate",
                       "--universal",
                       universal.string(),
                       "--held-out-only",
                       "--held-out",
                       file.string()});
            }};
  }

  Reader checkpoint_reader(const fs::path &directory)
  {
    const fs::path    file     = directory / "checkpoint";
    const Json        settings = {{"E", 1e10}, {"mesh", {{"level", 1}}}};
    const Arrays      state    = {{"approach", {0.5}}, {"empty", {}}, {"forces", {1., 2., 3.}}};
    const std::string title    = "dpcontact checkpoint 1\n";
    write_checkpoint(file, settings, state);
    const std::string whole = read_whole(file);
    return {"checkpoint",
            true,
            {whole.substr(whole.find('\n', title.size()) + 1)},
            [file, settings, title](const std::string &content) {
              write(file, title + sha256(content) + "\n" + content);
              const Arrays found = read_checkpoint(file, settings);
              std::size_t  bytes = 0;
              for (const auto &[name, numbers] : found)
                bytes += numbers.size() * sizeof(double);
              if (bytes > content.size())
                throw Wrong("more numbers than the file holds");
            }};
  }
} // namespace

int main(int argc, char **argv)
{
  const Directory directory;
  return run(argc,
             argv,
             directory.path,
             {parameter_reader(directory.path),
              held_out_reader(directory.path),
              checkpoint_reader(directory.path)});
}
