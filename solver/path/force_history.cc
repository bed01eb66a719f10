#include "solver/path/force_history.h"

#include "meshing/errors.h"
#include "solver/path/contact_model.h"
#include "solver/path/pilot.h"
#include "solver/path/runs.h"
#include "solver/path/step_extrapolation.h"
#include "solver/path/step_refinement.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace dpcontact
{
  namespace
  {
    using Legs = std::vector<std::vector<CurvePoint>>;

    constexpr unsigned int first_steps = 16, most_steps = 512; // from 0 to the largest force

    void check(const std::vector<double> &turning_points)
    {
      double before = 0;
      for (const double force : turning_points)
        {
          if (!std::isfinite(force) || force < 0 || force == before)
            {
              std::ostringstream message;
              message << "force history: " << force << " N after " << before
                      << " N; forces must be finite, not negative, and differ from the one before";
              throw InputError(message.str());
            }
          before = force;
        }
      if (turning_points.empty())
        throw InputError("force history: there is no force");
    }

    /// Steps of a leg in proportion to its length in the force's own parameter, at least four.
    std::vector<Leg> legs_of(const std::vector<double> &turning_points)
    {
      const double most  = *std::max_element(turning_points.begin(), turning_points.end());
      const auto   steps = [most](const double from, const double to) {
        const double power  = to > from ? 1. / 3 : 2. / 3;
        const double length = std::abs(std::pow(to / most, power) - std::pow(from / most, power));
        return std::max(4u, static_cast<unsigned int>(std::lround(first_steps * length)));
      };
      std::vector<Leg> legs;
      double           present = 0, peak = 0;
      for (const double force : turning_points)
        {
          if (present < peak && force > peak)
            {
              legs.push_back({peak, steps(present, peak)});
              present = peak;
            }
          legs.push_back({force, steps(present, force)});
          present = force;
          peak    = std::max(peak, force);
        }
      return legs;
    }

    Legs extrapolated(const Legs &coarse, const Legs &fine)
    {
      Legs result;
      for (std::size_t i = 0; i < fine.size(); ++i)
        result.push_back(extrapolate_steps({coarse[i], coarse[i]}, {fine[i], fine[i]}).loading);
      return result;
    }

    /// Largest difference of the force at equal approach over the largest force.
    double difference(const Legs &coarse, const Legs &fine, const double most)
    {
      double largest = 0;
      for (std::size_t i = 0; i < fine.size(); ++i)
        largest = std::max(largest,
                           step_difference({coarse[i], coarse[i]}, {fine[i], fine[i]}) *
                             std::max(fine[i].front().force, fine[i].back().force) / most);
      return largest;
    }
  } // namespace

  ForceHistory solve_force_history(const Material            &material,
                                   const double               radius,
                                   const std::vector<double> &turning_points,
                                   const SolverOptions       &options,
                                   const StepObserver        &observer)
  {
    material.check();
    options.check();
    check(turning_points);
    const double most = *std::max_element(turning_points.begin(), turning_points.end());
    const Scene  scene{radius, most};
    scene.check();

    ForceHistory history;
    history.yield       = first_yield(material, radius);
    const Pilot   pilot = run_pilots(material, scene, history.yield, history.cost, observer);
    SolverOptions used  = options;
    if (!used.surface_halvings)
      used.surface_halvings = pilot.approach > strongly_plastic ? 1 : 0;
    HalfSpaceModel model(material, scene, used, pilot.contact_radius);

    StepRule rule;
    rule.first_steps   = first_steps;
    rule.last_steps    = most_steps;
    rule.tolerance     = options.step_tolerance;
    rule.at_last_steps = AtLastSteps::accept;
    rule.cut_runs      = CutRuns::left_out;
    StepRefinement<Legs> refinement(
      {[most](const Legs &coarse, const Legs &fine) { return difference(coarse, fine, most); },
       extrapolated,
       {},
       {}},
      rule);
    const std::vector<Leg> legs = legs_of(turning_points);
    const auto             run  = [&](const unsigned int steps) {
      std::vector<Leg> halved = legs;
      for (Leg &leg : halved)
        leg.steps *= steps / first_steps;
      StepRefinement<Legs>::Run result{run_history(model, halved, observer)};
      add_cost(history.cost, model);
      result.was_cut = model.counters().cut_backs > 0;
      return result;
    };
    RefinedSteps<Legs> refined = refinement.refine(run);
    history.legs               = std::move(refined.points);
    history.step_error         = refined.error;
    return history;
  }
} // namespace dpcontact
