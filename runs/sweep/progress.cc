#include "runs/sweep/progress.h"

#include <cmath>
#include <cstdio>
#include <iostream>
#include <sys/ioctl.h>
#include <unistd.h>

namespace dpcontact
{
  namespace
  {
    /// Of the terminal.
    std::size_t columns()
    {
      winsize size{};
      return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
    }
  } // namespace

  std::string fitted(const std::string &text, const std::size_t columns)
  {
    std::size_t width = 0, end = 0;
    const auto  is_first_byte = [](const char c) {
      return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    };
    while (end < text.size() && (!is_first_byte(text[end]) || ++width < columns))
      ++end;
    return text.substr(0, end);
  }

  Progress::Progress(const std::size_t rows, const std::size_t finished_before)
    : total(rows)
    , done(finished_before)
    , terminal(isatty(STDERR_FILENO) == 1)
    , start(std::chrono::steady_clock::now())
  {}

  Progress::~Progress()
  {
    if (terminal && computed > 0)
      std::cerr << std::endl;
  }

  double Progress::seconds() const
  {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  void Progress::row_done(const std::string &text, const bool matters)
  {
    ++done;
    ++computed;
    const double seconds_a_row = seconds() / static_cast<double>(computed);
    char         rate[48];
    std::snprintf(rate, sizeof(rate), "%.1f rows/min", 60 / seconds_a_row);
    const std::string status =
      "[" + std::to_string(done) + "/" + std::to_string(total) + "] " + rate + ", " +
      format_duration(seconds_a_row * static_cast<double>(total - done)) + " left";

    if (!terminal)
      std::cerr << status << "; " << text << std::endl;
    else
      {
        const char *const clear_line = "\r\033[K";
        if (matters)
          std::cerr << clear_line << text << '\n';
        std::cerr << clear_line << fitted(status + "; " + (matters ? "" : text), columns())
                  << std::flush;
      }
  }

  std::string format_duration(const double seconds)
  {
    const auto whole = static_cast<long>(std::lround(seconds));
    if (whole < 120)
      return std::to_string(whole) + " s";
    const long minutes = (whole + 30) / 60;
    if (minutes < 120)
      return std::to_string(minutes) + " min";
    return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
  }
} // namespace dpcontact
