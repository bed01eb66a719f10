#include "runs/sweep/worker_pool.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <deque>
#include <iostream>
#include <optional>
#include <poll.h>
#include <set>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace dpcontact
{
  namespace
  {
    [[noreturn]] void throw_errno(const char *what)
    {
      throw std::system_error(errno, std::generic_category(), what);
    }

    /// A file descriptor that is closed with its owner.
    class Descriptor
    {
    public:
      explicit Descriptor(const int value = -1)
        : number(value)
      {}
      Descriptor(Descriptor &&other) noexcept
        : number(std::exchange(other.number, -1))
      {}
      Descriptor &operator=(Descriptor &&other) noexcept
      {
        std::swap(number, other.number);
        return *this;
      }
      ~Descriptor()
      {
        if (number >= 0)
          close(number);
      }
      int get() const { return number; }

    private:
      int number;
    };

    /// The whole buffer or nothing: false at the end of the pipe or where nobody reads.
    template <typename Transfer, typename Byte>
    bool transfer_all(Transfer transfer, const int descriptor, Byte *data, std::size_t size)
    {
      while (size > 0)
        {
          const ssize_t count = transfer(descriptor, data, size);
          if (count < 0 && errno == EINTR)
            continue;
          if (count <= 0)
            return false;
          data += count;
          size -= static_cast<std::size_t>(count);
        }
      return true;
    }

    bool write_all(const int descriptor, const void *data, const std::size_t size)
    {
      return transfer_all(::write, descriptor, static_cast<const char *>(data), size);
    }

    bool read_all(const int descriptor, void *data, const std::size_t size)
    {
      return transfer_all(::read, descriptor, static_cast<char *>(data), size);
    }

    bool write_text(const int descriptor, const std::string &text)
    {
      const std::uint64_t size = text.size();
      return write_all(descriptor, &size, sizeof(size)) &&
             write_all(descriptor, text.data(), text.size());
    }

    std::optional<std::string> read_text(const int descriptor)
    {
      std::uint64_t size = 0;
      if (!read_all(descriptor, &size, sizeof(size)))
        return std::nullopt;
      std::string text(size, '\0');
      if (!read_all(descriptor, text.data(), text.size()))
        return std::nullopt;
      return text;
    }

    /// A child process as its parent sees it.
    struct Child
    {
      pid_t                      process = -1;
      Descriptor                 orders;  ///< write end: job numbers
      Descriptor                 results; ///< read end: texts
      std::optional<std::size_t> job;     ///< what it works at
    };

    [[noreturn]] void
    serve(const int orders, const int results, const std::function<Worker()> &make_worker)
    {
      try
        {
          const Worker worker = make_worker();
          for (std::uint64_t job = 0; read_all(orders, &job, sizeof(job));)
            if (!write_text(results, worker(job)))
              break;
        }
      catch (const std::exception &error)
        {
          std::cerr << "dpcontact: worker process: " << error.what() << std::endl;
          _exit(1);
        }
      _exit(0);
    }

    Child start(const std::function<Worker()> &make_worker, std::vector<Child> &others)
    {
      int order_pipe[2];
      if (pipe(order_pipe) != 0)
        throw_errno("cannot make a pipe");
      Descriptor order_read(order_pipe[0]), order_write(order_pipe[1]);
      int        result_pipe[2];
      if (pipe(result_pipe) != 0)
        throw_errno("cannot make a pipe");
      Descriptor result_read(result_pipe[0]), result_write(result_pipe[1]);

      const pid_t parent = getpid();
      std::cout.flush();
      std::cerr.flush();
      Child child;
      child.process = fork();
      if (child.process < 0)
        throw_errno("cannot start a worker process");
      if (child.process == 0)
        {
          // The parent may have died before the signal was asked for.
          prctl(PR_SET_PDEATHSIG, SIGKILL);
          if (getppid() != parent)
            _exit(1);
          others.clear(); // closes their pipes, or they would not see theirs end
          order_write = Descriptor();
          result_read = Descriptor();
          serve(order_read.get(), result_write.get(), make_worker);
        }
      child.orders  = std::move(order_write);
      child.results = std::move(result_read);
      return child;
    }

    std::string cause_of_death(const pid_t process)
    {
      int status = 0;
      while (waitpid(process, &status, 0) < 0)
        if (errno != EINTR)
          return "the worker process vanished";
      if (WIFSIGNALED(status))
        return std::string("the worker process was ended by signal ") +
               std::to_string(WTERMSIG(status)) + " (" + strsignal(WTERMSIG(status)) + ")";
      return "the worker process ended with exit code " + std::to_string(WEXITSTATUS(status));
    }

    /// Ends the children that are left when the pool is done or was left by an exception.
    struct Children
    {
      std::vector<Child> list;

      ~Children()
      {
        for (Child &child : list)
          {
            if (child.job)
              kill(child.process, SIGKILL);
            child.orders = Descriptor();
          }
        for (const Child &child : list)
          cause_of_death(child.process);
      }
    };

    /// Writing to a child that has died must not end the parent, nor a file that becomes too large
    /// a child: both are errors of the call.
    class IgnoreWriteSignals
    {
    public:
      IgnoreWriteSignals()
        : broken_pipe(std::signal(SIGPIPE, SIG_IGN))
        , file_size(std::signal(SIGXFSZ, SIG_IGN))
      {}
      ~IgnoreWriteSignals()
      {
        std::signal(SIGPIPE, broken_pipe);
        std::signal(SIGXFSZ, file_size);
      }
      IgnoreWriteSignals(const IgnoreWriteSignals &)            = delete;
      IgnoreWriteSignals &operator=(const IgnoreWriteSignals &) = delete;

    private:
      void (*broken_pipe)(int);
      void (*file_size)(int);
    };
  } // namespace

  void run_jobs(const std::vector<std::size_t>               &jobs,
                const unsigned int                            processes,
                const std::function<Worker()>                &make_worker,
                const std::function<void(std::size_t job)>   &on_start,
                const std::function<void(const JobResult &)> &on_end)
  {
    const IgnoreWriteSignals guard;
    std::deque<std::size_t>  waiting(jobs.begin(), jobs.end());
    std::set<std::size_t>    tried_again;
    Children                 children;

    const auto hand_out = [&](Child &child) {
      child.job = waiting.front();
      waiting.pop_front();
      on_start(*child.job);
      const std::uint64_t number = *child.job;
      write_all(child.orders.get(), &number, sizeof(number)); // a failure shows as its death
    };

    while (true)
      {
        while (children.list.size() <
               std::min<std::size_t>(processes, children.list.size() + waiting.size()))
          {
            children.list.push_back(start(make_worker, children.list));
            hand_out(children.list.back());
          }
        if (children.list.empty())
          return;

        std::vector<pollfd> polled;
        for (const Child &child : children.list)
          polled.push_back({child.results.get(), POLLIN, 0});
        if (poll(polled.data(), polled.size(), -1) < 0)
          {
            if (errno == EINTR)
              continue;
            throw_errno("cannot wait for worker processes");
          }

        for (std::size_t i = polled.size(); i-- > 0;)
          {
            if (polled[i].revents == 0)
              continue;
            Child    &child = children.list[i];
            JobResult result;
            result.job      = *child.job;
            const auto text = read_text(child.results.get());
            const bool done = !text || waiting.empty();
            if (text)
              {
                result.text = *text;
                child.job.reset();
                if (!done)
                  hand_out(child);
              }
            if (done)
              {
                child.orders           = Descriptor(); // an idle child ends by this
                const std::string fate = cause_of_death(child.process);
                if (!text)
                  {
                    result.died = true;
                    result.text = fate;
                  }
                children.list.erase(children.list.begin() + static_cast<std::ptrdiff_t>(i));
                if (result.died && tried_again.insert(result.job).second)
                  {
                    std::cerr << "dpcontact: " << fate << "; its job is tried again" << std::endl;
                    waiting.push_front(result.job);
                    continue;
                  }
              }
            on_end(result);
          }
      }
  }
} // namespace dpcontact
