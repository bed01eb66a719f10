#include "database/contact_law/collision.h"

#include "meshing/errors.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dpcontact
{
  namespace
  {
    /// @throws InputError unless `holds`.
    void check(const bool holds, const char *name, const double value, const char *range)
    {
      if (holds)
        return;
      std::ostringstream message;
      message << "collision: " << name << " is " << value << "; it must be " << range;
      throw InputError(message.str());
    }
  } // namespace

  double CollidingSpheres::effective_mass() const
  {
    const auto mass = [this](const double r) { return density * 4. / 3. * M_PI * r * r * r; };
    return mass(radius_1) * mass(radius_2) / (mass(radius_1) + mass(radius_2));
  }

  Collision
  collide(const ContactLaw &law, const CollidingSpheres &spheres, const unsigned int steps)
  {
    const auto check_within =
      [](const char *name, const double value, const double low, const double high) {
        std::ostringstream range;
        range << "from " << low << " to " << high << " in SI units";
        // NaN is asked for first: an ordered comparison with it raises a floating-point exception
        check(
          std::isfinite(value) && value >= low && value <= high, name, value, range.str().c_str());
      };
    // Far beyond all grains, and where no power of them leaves the range of doubles.
    check_within("radius", spheres.radius_1, 1e-9, 1e6);
    check_within("second radius", spheres.radius_2, 1e-9, 1e6);
    check_within("density", spheres.density, 1e-3, 1e6);
    check_within("velocity", spheres.velocity, 1e-9, 1e5);
    check(steps >= 100, "number of steps", steps, "at least 100");

    const double r    = ContactLaw::effective_radius(spheres.radius_1, spheres.radius_2);
    const auto   pair = law.pair(r);
    const double mass = spheres.effective_mass();
    // Hertz's collision lasts 2.94 δ_max/v with δ_max = (5 m v²/(4 k))^(2/5), F = k δ^1.5; yield
    // makes it longer, by less than half.
    const double k     = law.force_yield(r) / std::pow(law.approach_yield(r), 1.5);
    const double speed = spheres.velocity;
    const double step  = 2.94 * std::pow(1.25 * mass * speed * speed / k, 0.4) / speed / steps;

    Collision    result;
    ContactState state;
    double       overlap = 0, velocity = speed, time = 0;
    const auto   acceleration = [&](const double at) {
      ContactState trial = state; // a stage is no part of the history
      return -pair.evaluate(at, trial).force / mass;
    };
    for (std::size_t i = 0; i < std::size_t(100) * steps; ++i)
      {
        const double a1     = acceleration(overlap);
        const double v2     = velocity + step / 2 * a1;
        const double a2     = acceleration(overlap + step / 2 * velocity);
        const double v3     = velocity + step / 2 * a2;
        const double a3     = acceleration(overlap + step / 2 * v2);
        const double v4     = velocity + step * a3;
        const double a4     = acceleration(overlap + step * v3);
        const double before = overlap;
        overlap += step / 6 * (velocity + 2 * v2 + 2 * v3 + v4);
        velocity += step / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        const ContactResponse response = pair.evaluate(overlap, state);
        result.flags |= response.flags;
        result.peak_force = std::max(result.peak_force, response.force);
        if (velocity < 0 && response.force == 0)
          {
            const double end = pair.coefficients(state.peak_overlap).residual;
            time += step * std::clamp((before - end) / (before - overlap), 0., 1.);
            break;
          }
        time += step;
      }
    result.peak_overlap     = state.peak_overlap;
    result.residual_overlap = pair.coefficients(state.peak_overlap).residual;
    result.duration         = time;
    result.rebound_velocity = -velocity;
    result.restitution      = -velocity / speed;
    // The law creates no energy; the rest is the integration's error.
    constexpr double rounding = 1e-3;
    if (!std::isfinite(result.restitution + result.peak_force + result.peak_overlap +
                       result.duration) ||
        result.restitution < 0 || result.restitution > 1 + rounding)
      {
        std::ostringstream message;
        message << "collision: no rebound was found (restitution " << result.restitution
                << ", peak force " << result.peak_force << " N, overlap " << result.peak_overlap
                << " m): is the law one of rock, and is --steps large enough?";
        throw SolverError(message.str());
      }
    return result;
  }
} // namespace dpcontact
