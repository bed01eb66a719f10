#include "runs/interface/interruption.h"

#include "solver/parallel/launcher.h"

#include <csignal>
#include <unistd.h>

namespace dpcontact
{
  namespace
  {
    // A handler may touch nothing else: no memory, no stream.
    std::string what_is_kept;
    pid_t       owner = 0;

    void say_and_end(const int signal)
    {
      if (::getpid() == owner)
        (void)!::write(STDERR_FILENO, what_is_kept.data(), what_is_kept.size());
      std::signal(signal, SIG_DFL);
      std::raise(signal);
    }
  } // namespace

  InterruptionMessage::InterruptionMessage(const std::string &message)
  {
    if (launched_ranks() > 1)
      return;
    what_is_kept = "\ndpcontact: interrupted: " + message + "\n";
    owner        = ::getpid();
    for (const int signal : {SIGINT, SIGTERM})
      std::signal(signal, say_and_end);
  }

  InterruptionMessage::~InterruptionMessage()
  {
    if (owner != ::getpid())
      return;
    for (const int signal : {SIGINT, SIGTERM})
      std::signal(signal, SIG_DFL);
  }
} // namespace dpcontact
