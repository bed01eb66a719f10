#include "runs/studies/validation.h"

#include "fitting/curve_fit.h"
#include "solver/closed_form/first_yield.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace dpcontact
{
  namespace
  {
    constexpr unsigned int points_per_leg = 200;

    /// F at overlap δ within a leg, by F^(2/3) linear between its points: elastic contact is.
    double force_on(const std::vector<CurvePoint> &leg, const double overlap)
    {
      const bool up    = leg.back().approach > leg.front().approach;
      const auto after = std::find_if(leg.begin() + 1, leg.end() - 1, [&](const CurvePoint &point) {
        return up ? point.approach >= overlap : point.approach <= overlap;
      });
      const CurvePoint &to = *after, &from = *(after - 1);
      const double      share = (overlap - from.approach) / (to.approach - from.approach);
      const double      low = std::pow(from.force, 2. / 3), high = std::pow(to.force, 2. / 3);
      return std::pow(std::max(low + share * (high - low), 0.), 1.5);
    }

    /// Work along a path of (δ, F), put in and given back.
    struct Work
    {
      double in = 0, back = 0;
      void   add(const double force, const double step)
      {
        (step > 0 ? in : back) += force * std::abs(step);
      }
      double restitution() const { return std::sqrt(back / in); }
    };

    /// Root mean square and largest of what is added.
    struct Squares
    {
      double       sum = 0, largest = 0;
      unsigned int count = 0;
      void         add(const double error)
      {
        sum += error * error;
        largest = std::max(largest, std::abs(error));
        ++count;
      }
      double rms() const { return count > 0 ? std::sqrt(sum / count) : 0; }
    };
  } // namespace

  LawErrors law_errors(const ContactPair &pair, const Legs &legs)
  {
    double force_max = 0, approach_max = 0;
    for (const auto &leg : legs)
      for (const CurvePoint &point : leg)
        {
          force_max    = std::max(force_max, point.force);
          approach_max = std::max(approach_max, point.approach);
        }

    LawErrors    errors;
    Squares      loading, unloading;
    Work         law_work, work;
    ContactState state;
    double       peak = 0, law_before = 0, before = legs.front().front().force;
    for (const auto &leg : legs)
      {
        const double from = leg.front().approach, to = leg.back().approach;
        const bool   is_loading = leg.back().force > peak * (1 + 1e-9);
        const double step       = (to - from) / points_per_leg;
        Squares      of_leg;
        double       sum = 0;
        for (unsigned int i = 1; i <= points_per_leg; ++i)
          {
            const double overlap = i == points_per_leg ? to : from + step * i;
            const double force   = i == points_per_leg ? leg.back().force : force_on(leg, overlap);
            const double law     = pair.evaluate(overlap, state).force;
            (is_loading ? loading : unloading).add((law - force) / force_max);
            of_leg.add((law - force) / force_max);
            sum += (law - force) / force_max;
            work.add((before + force) / 2, step);
            law_work.add((law_before + law) / 2, step);
            before     = force;
            law_before = law;
          }
        errors.legs.push_back({leg.back().force / force_max, sum / points_per_leg, of_leg.rms()});
        peak = std::max(peak, leg.back().force);
        if (leg.back().force == 0)
          errors.residual =
            std::max(errors.residual,
                     std::abs(pair.coefficients(state.peak_overlap).residual - to) / approach_max);
      }
    errors.loading_rms     = loading.rms();
    errors.loading_max     = loading.largest;
    errors.unloading_rms   = unloading.rms();
    errors.unloading_max   = unloading.largest;
    errors.energy_loss     = ((law_work.in - law_work.back) - (work.in - work.back)) / work.in;
    errors.restitution     = work.restitution();
    errors.law_restitution = law_work.restitution();
    return errors;
  }

  std::vector<RandomHistory>
  random_histories(const unsigned int count, const unsigned int seed, const HistoryRanges &ranges)
  {
    std::mt19937_64 random(seed);
    // The library's distributions differ between implementations; this does not.
    const auto within = [&](const double low, const double high) {
      return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
    };
    const auto over_decades = [&](const double low, const double high) {
      return std::exp(within(std::log(low), std::log(high)));
    };
    std::vector<RandomHistory> result;
    for (unsigned int i = 0; i < count; ++i)
      {
        RandomHistory next{};
        Material     &material        = next.input.material;
        material.poisson_ratio        = within(ranges.nu[0], ranges.nu[1]);
        material.friction_angle       = Angle(within(ranges.phi_deg[0], ranges.phi_deg[1]));
        material.youngs_modulus       = over_decades(1e9, 1e11);
        material.compressive_strength = material.youngs_modulus * over_decades(2e-4, 5e-3);
        next.input.scene.radius       = over_decades(1e-3, 1);
        next.input.scene.force_max    = over_decades(ranges.load_level[0], ranges.load_level[1]) *
                                     first_yield(material, next.input.scene.radius).force;
        const double first = within(0.15, 0.4), second = within(0.5, 0.75);
        for (const double share : {first,
                                   first * within(0.1, 0.6),
                                   first * within(0.7, 0.95),
                                   first * within(0.02, 0.08),
                                   second,
                                   0.,
                                   second * within(0.7, 0.95),
                                   second * within(0.1, 0.6),
                                   1.,
                                   0.})
          next.turning_points.push_back(share * next.input.scene.force_max);
        result.push_back(next);
      }
    return result;
  }

  ContactRow row_of_history(const Legs &legs, const FirstYield &yield, const double radius)
  {
    Curve curve;
    curve.loading.push_back(legs.front().front());
    for (const auto &leg : legs)
      for (const CurvePoint &point : leg)
        if (point.force > curve.loading.back().force &&
            point.approach > curve.loading.back().approach)
          curve.loading.push_back(point);
    curve.unloading    = legs.back();
    const CurveFit fit = fit_curve(curve, yield.force, yield.approach);
    return {fit.loading.fit.law.coefficient,
            fit.loading.fit.law.exponent,
            fit.unloading.fit.law.coefficient,
            fit.unloading.fit.law.exponent,
            yield.force,
            yield.approach,
            radius / 2};
  }
} // namespace dpcontact
