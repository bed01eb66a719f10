#include "database/rows/read_in_child.h"

#include "database/files/bounded_process.h"
#include "database/rows/store.h"

#include <cstring>

namespace dpcontact
{
  namespace
  {
    /// A database reads at tens of MB a second; the address space holds the program as well.
    ProcessBounds bounds_of(const std::uint64_t size)
    {
      constexpr std::uint64_t least_seconds = 2, bytes_a_second = 1 << 20;
      constexpr std::uint64_t least_bytes = std::uint64_t(4) << 30, times_its_size = 16;
      constexpr std::uint64_t wall_over_processor = 30; // others may use the processors
      const std::uint64_t     seconds             = least_seconds + size / bytes_a_second;
      return {seconds, wall_over_processor * seconds, least_bytes + times_its_size * size};
    }

    ProcessEnd read(const std::filesystem::path &file, const std::string &bytes)
    {
      const auto end = [](const ExitCode code, const std::string &text) {
        return ProcessEnd{static_cast<int>(code), text, 0};
      };
      try
        {
          return end(ExitCode::success,
                     std::to_string(read_store_unchecked(file, bytes).records.size()) + " rows");
        }
      catch (const Error &error)
        {
          return end(error.code(), error.what());
        }
      catch (const std::exception &error)
        {
          return end(ExitCode::corrupt_data,
                     file.string() + " is not a database of this program: " + error.what());
        }
    }
  } // namespace

  ChildReading read_in_child(const std::filesystem::path &file, const std::string &bytes)
  {
    const ProcessEnd end = in_process_of_its_own(
      "read " + file.string(), bounds_of(bytes.size()), [&] { return read(file, bytes); });
    if (end.signal != 0)
      return {ExitCode::corrupt_data,
              file.string() + " cannot be read: HDF5 ended with '" + strsignal(end.signal) +
                "' in a process of its own"};
    return {static_cast<ExitCode>(end.code), end.text};
  }
} // namespace dpcontact
