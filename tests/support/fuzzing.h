#ifndef DPCONTACT_TESTS_SUPPORT_FUZZING_H
#define DPCONTACT_TESTS_SUPPORT_FUZZING_H

#include "meshing/errors.h"
#include "tests/support/mutations.h"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>
#include <vector>

#ifdef __SANITIZE_ADDRESS__
/// The memory that an altered file may ask for, and no detours: what malloc refuses, HDF5 bears.
extern "C" inline const char *__asan_default_options()
{
  return "max_allocation_size_mb=1024:allocator_may_return_null=1:quarantine_size_mb=32:"
         "hard_rss_limit_mb=3000";
}
#endif

/// Readers that are given altered files: each must refuse one with an error of the project, or read
/// numbers that its checks would pass, without a crash, in bounded time and memory.
namespace dpcontact::testing_fuzzing
{
  namespace fs = std::filesystem;

  constexpr long        most_kilobytes = 1L << 20; ///< that reading takes
  constexpr std::time_t most_seconds   = 10;       ///< of processor time, per file

  /// What a reader must not do.
  struct Wrong : std::logic_error
  {
    using std::logic_error::logic_error;
  };

  struct Reader
  {
    std::string              name;
    bool                     is_text;
    std::vector<std::string> seeds; ///< whole files, or what is to be altered in them

    /// Reads what an altered seed makes. @throws Error where it refuses it, Wrong.
    std::function<void(const std::string &)> read;
  };

  /// A directory of its own, which stays where the process crashes.
  class Directory
  {
  public:
    Directory()
    {
      std::string name = (fs::temp_directory_path() / "dpcontact-fuzzing-XXXXXX").string();
      if (::mkdtemp(name.data()) == nullptr)
        throw std::runtime_error("cannot make a temporary directory");
      path = name;
    }
    ~Directory() { fs::remove_all(path); }
    Directory(const Directory &)            = delete;
    Directory &operator=(const Directory &) = delete;

    fs::path path;
  };

  inline void write(const fs::path &file, const std::string &bytes)
  {
    std::ofstream(file, std::ios::binary) << bytes;
  }

  inline std::string read_whole(const fs::path &file)
  {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  }

  /// A few families of a universal table: two nu with two phi each, so that it is read in no time.
  inline std::string few_families(const std::string &table)
  {
    std::istringstream                 lines(table);
    const std::string                  count = "# rows: ";
    std::string                        result;
    std::size_t                        rows = 0;
    std::map<std::string, std::size_t> nu, phi;
    for (std::string line; std::getline(lines, line);)
      {
        const std::size_t first = line.find(','), second = line.find(',', first + 1);
        bool wanted = line.front() == '#' || line.front() == 'n'; // a comment, the header
        if (!wanted)
          {
            const auto i = nu.emplace(line.substr(0, first), nu.size()).first->second;
            const auto k =
              phi.emplace(line.substr(first, second - first), phi.size()).first->second;
            wanted = i < 2 && (k == 3 || k == 4);
          }
        if (line.rfind(count, 0) == 0)
          continue;
        if (wanted)
          result += line + "\n";
        rows += wanted && line.front() != '#' && line.front() != 'n';
      }
    // After the title, which is the first line.
    return result.insert(result.find('\n') + 1, count + std::to_string(rows) + "\n");
  }

  /// The largest that this process, or any of its children, ever was.
  inline long peak_kilobytes()
  {
    rusage own{}, children{};
    getrusage(RUSAGE_SELF, &own);
    getrusage(RUSAGE_CHILDREN, &children);
    return std::max(own.ru_maxrss, children.ru_maxrss);
  }

  /// Ends the process after so much processor time.
  inline void limit_seconds(const std::time_t seconds)
  {
    std::signal(SIGPROF, [](int) {
      static const char text[]  = "fuzzing: a file took more than 10 s of processor time\n";
      const auto        ignored = ::write(2, text, sizeof(text) - 1);
      static_cast<void>(ignored);
      ::_exit(3);
    });
    const itimerval timer{{0, 0}, {seconds, 0}};
    setitimer(ITIMER_PROF, &timer, nullptr);
  }

  /// Gives a reader the inputs of numbers `first` to `first + count − 1`; the same number is always
  /// the same input. The last one stays in the file `input` of the directory while it is read.
  /// @return how many inputs were treated wrongly; each is kept in the working directory.
  inline std::size_t fuzz(const Reader     &reader,
                          const std::size_t first,
                          const std::size_t count,
                          const fs::path   &directory)
  {
    const long  before  = peak_kilobytes();
    std::size_t refused = 0, wrong = 0;
    for (const std::string &seed : reader.seeds)
      reader.read(seed); // whole files are read
    for (std::size_t number = first; number < first + count; ++number)
      {
        testing_mutations::Mutator mutate(number, reader.is_text);
        const std::string          input = mutate(reader.seeds[number % reader.seeds.size()]);
        write(directory / "input", input);
        const auto keep = [&](const std::string &what) {
          const std::string name = "fuzz-" + reader.name + "-" + std::to_string(number);
          write(name, input);
          std::cerr << reader.name << ", input " << number << ", kept in " << name << ": " << what
                    << std::endl;
          ++wrong;
        };
        limit_seconds(most_seconds);
        try
          {
            reader.read(input);
          }
        catch (const Error &error)
          {
            ++refused;
            if (error.code() == ExitCode::internal)
              keep(error.what());
          }
        catch (const std::exception &error)
          {
            keep(error.what());
          }
        limit_seconds(0);
      }
    const long added = peak_kilobytes() - before;
    std::cerr << reader.name << ": " << count << " inputs, " << refused << " refused, " << wrong
              << " wrong, " << added / 1024 << " MB more at most" << std::endl;
    return wrong + (added > most_kilobytes ? 1 : 0);
  }

  /// PROGRAM READER COUNT [FIRST]
  inline int run(const int                  argc,
                 const char *const         *argv,
                 const fs::path            &directory,
                 const std::vector<Reader> &readers)
  {
    std::size_t wrong = 0, found = 0;
    for (const Reader &reader : readers)
      if (argc > 2 && (argv[1] == reader.name || argv[1] == std::string("all")))
        {
          ++found;
          wrong += fuzz(reader, argc > 3 ? std::stoul(argv[3]) : 0, std::stoul(argv[2]), directory);
        }
    if (found > 0)
      return wrong == 0 ? 0 : 1;
    std::cerr << "usage: " << argv[0] << " READER COUNT [FIRST]; READER is all";
    for (const Reader &reader : readers)
      std::cerr << ", " << reader.name;
    std::cerr << std::endl;
    return 2;
  }
} // namespace dpcontact::testing_fuzzing

#endif
