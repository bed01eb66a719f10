#include "runs/sweep/rank_pool.h"

#include "meshing/errors.h"

#include <chrono>
#include <exception>
#include <future>
#include <mpi.h>
#include <optional>
#include <thread>

namespace dpcontact
{
  namespace
  {
    /// Kinds of messages.
    enum Tag : int
    {
      tag_order = 1,
      tag_stop,
      tag_ready,  ///< with what the rank was given
      tag_result, ///< of the order
      tag_failure ///< why the rank cannot work
    };

    struct Message
    {
      std::size_t source = 0;
      int         tag    = 0;
      std::string text;
    };

    /// Between two looks for messages. MPI's own waiting would keep a core busy.
    constexpr std::chrono::milliseconds pause(2);

    void send(const std::size_t rank, const Tag tag, const std::string &text)
    {
      MPI_Send(text.data(),
               static_cast<int>(text.size()),
               MPI_CHAR,
               static_cast<int>(rank),
               tag,
               MPI_COMM_WORLD);
    }

    std::optional<Message> look()
    {
      int        found = 0;
      MPI_Status status;
      MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &found, &status);
      if (found == 0)
        return std::nullopt;
      int size = 0;
      MPI_Get_count(&status, MPI_CHAR, &size);
      Message message;
      message.source = static_cast<std::size_t>(status.MPI_SOURCE);
      message.tag    = status.MPI_TAG;
      message.text.resize(static_cast<std::size_t>(size));
      MPI_Recv(message.text.data(),
               size,
               MPI_CHAR,
               status.MPI_SOURCE,
               status.MPI_TAG,
               MPI_COMM_WORLD,
               MPI_STATUS_IGNORE);
      return message;
    }

    Message wait()
    {
      while (true)
        {
          if (auto message = look())
            return *std::move(message);
          std::this_thread::sleep_for(pause);
        }
    }
  } // namespace

  RankPool::RankPool(const MpiSession &session)
    : ranks(session.size())
  {}

  RankPool::~RankPool()
  {
    for (std::size_t rank = 1; rank < ranks.size(); ++rank)
      {
        while (ranks[rank].state == State::busy)
          ranks[wait().source].state = State::idle;
        send(rank, tag_stop, "");
      }
  }

  bool RankPool::receive(const std::function<void(std::size_t, const std::string &given)> &on_ready,
                         const std::function<void(std::size_t, const std::string &text)>  &on_end)
  {
    const auto message = look();
    if (!message)
      return false;
    Rank &rank = ranks[message->source];
    rank.state = State::idle;
    if (message->tag == tag_failure)
      throw FileError("MPI rank " + std::to_string(message->source) + ": " + message->text);
    if (message->tag == tag_ready)
      on_ready(message->source, message->text);
    if (message->tag == tag_result)
      on_end(rank.order, message->text);
    return true;
  }

  void RankPool::run(const std::vector<std::string>                                   &orders,
                     const RankWorker                                                 &here,
                     const std::function<void(std::size_t, const std::string &given)> &on_ready,
                     const std::function<void(std::size_t, const std::string &text)>  &on_end)
  {
    std::size_t next = 0, done = 0;
    const auto  end_order = [&](const std::size_t order, const std::string &text) {
      ++done;
      on_end(order, text);
    };

    std::size_t              own_order = 0;
    std::future<std::string> own; // waits for its thread, however this ends
    while (done < orders.size())
      {
        if (!own.valid() && next < orders.size())
          {
            own_order = next++;
            own       = std::async(std::launch::async, here, orders[own_order]);
          }
        for (std::size_t rank = 1; rank < ranks.size() && next < orders.size(); ++rank)
          if (ranks[rank].state == State::idle)
            {
              ranks[rank] = {State::busy, next};
              send(rank, tag_order, orders[next++]);
            }

        if (receive(on_ready, end_order))
          continue;
        if (!own.valid())
          std::this_thread::sleep_for(pause);
        else if (own.wait_for(pause) == std::future_status::ready)
          end_order(own_order, own.get());
      }
  }

  void serve_ranks(const std::function<RankStart()> &start)
  {
    const auto report = [](const Tag tag, const std::function<std::string()> &action) {
      try
        {
          const std::string text = action();
          send(0, tag, text);
        }
      catch (const std::exception &error)
        {
          send(0, tag_failure, error.what());
        }
    };

    RankWorker worker;
    report(tag_ready, [&] {
      RankStart begun = start();
      worker          = std::move(begun.worker);
      return begun.given;
    });
    for (Message message = wait(); message.tag != tag_stop; message = wait())
      report(tag_result, [&] { return worker(message.text); });
  }
} // namespace dpcontact
