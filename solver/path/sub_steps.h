#ifndef DPCONTACT_SOLVER_PATH_SUB_STEPS_H
#define DPCONTACT_SOLVER_PATH_SUB_STEPS_H

#include <cmath>

namespace dpcontact
{
  /// The parts of one nominal step, which is cut where Newton fails.
  struct SubSteps
  {
    double       level; ///< reached so far
    double       end;
    double       step;
    unsigned int halvings = 0;

    SubSteps(const double from, const double to)
      : level(from)
      , end(to)
      , step(to - from)
    {}

    bool done() const { return level == end; }

    /// Level of the next part; it does not leave a sliver before the end.
    double next()
    {
      const double left = end - level;
      if (std::abs(step) > std::abs(left) * (1 - 1e-9))
        step = left;
      return std::abs(left - step) < 1e-12 ? end : level + step;
    }

    void reach(const double next, const bool easily)
    {
      level = next;
      if (halvings > 0 && easily)
        {
          --halvings;
          step *= 2;
        }
    }

    void halve()
    {
      ++halvings;
      step /= 2;
    }
  };
} // namespace dpcontact

#endif
