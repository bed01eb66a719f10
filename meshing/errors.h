#ifndef DPCONTACT_MESHING_ERRORS_H
#define DPCONTACT_MESHING_ERRORS_H

#include <stdexcept>
#include <string>
#include <utility>

namespace dpcontact
{
  /// How the program ends. One value a kind of failure, so that a script can tell them apart.
  enum class ExitCode : int
  {
    success           = 0,
    internal          = 1, ///< a defect of the program
    usage             = 2, ///< unknown option or subcommand, missing argument
    bad_input         = 3, ///< a value outside its range or of the wrong type
    file              = 4, ///< a file that is missing, unreadable or cannot be written
    solver            = 5, ///< the computation did not reach its goal
    settings_mismatch = 6, ///< stored results were made with other settings
    corrupt_data      = 7, ///< a stored file is damaged or not ours
    incomplete = 8 ///< a sweep ended with failed or missing rows, or a hard case unlike expected
  };

  /// Base of everything that dpcontact throws on purpose. `what()` says what, where and what to do.
  class Error : public std::runtime_error
  {
  public:
    Error(ExitCode code, const std::string &message)
      : std::runtime_error(message)
      , exit_code(code)
    {}
    ExitCode code() const noexcept { return exit_code; }

  private:
    ExitCode exit_code;
  };

  /// A command line that is not understood.
  struct UsageError : Error
  {
    explicit UsageError(const std::string &message)
      : Error(ExitCode::usage, message)
    {}
  };

  /// A value outside its range or of the wrong type.
  struct InputError : Error
  {
    explicit InputError(const std::string &message)
      : Error(ExitCode::bad_input, message)
    {}
  };

  /// A file that is missing, unreadable or cannot be written.
  struct FileError : Error
  {
    explicit FileError(const std::string &message)
      : Error(ExitCode::file, message)
    {}
  };

  /// The computation did not reach its goal; the message holds the reason.
  struct SolverError : Error
  {
    /// @param log_ numbers for whoever looks into it: "residuals 1 0.3 …"
    explicit SolverError(const std::string &message, std::string log_ = "")
      : Error(ExitCode::solver, message)
      , log(std::move(log_))
    {}
    std::string log;
  };

  /// Stored results were made with other settings; the message prints both values.
  struct SettingsMismatch : Error
  {
    explicit SettingsMismatch(const std::string &message)
      : Error(ExitCode::settings_mismatch, message)
    {}
  };

  /// A stored file is damaged, truncated or foreign.
  struct CorruptData : Error
  {
    explicit CorruptData(const std::string &message)
      : Error(ExitCode::corrupt_data, message)
    {}
  };
} // namespace dpcontact

#endif
