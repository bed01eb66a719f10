#include "solver/scene.h"

#include "meshing/errors.h"
#include "solver/laws/drucker_prager.h"
#include "solver/laws/mohr_coulomb.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dpcontact
{
  namespace
  {
    [[noreturn]] void
    refuse(const char *quantity, const double value, const char *unit, const char *range)
    {
      std::ostringstream message;
      message.precision(12);
      message << quantity << " is " << value << unit << "; it must be " << range << ".";
      throw InputError(message.str());
    }

    [[noreturn]] void refuse_for(const Criterion criterion, const char *quantity, const char *owner)
    {
      throw InputError(std::string(quantity) + " is set, but " + to_string(criterion) +
                       " has none: leave it out, or use " + owner + ".");
    }

    constexpr double degrees = 180 / M_PI;

    // Finiteness is asked first: an ordered comparison with NaN raises a floating-point exception.
    void require_positive(const char *quantity, const double value, const char *unit)
    {
      if (!std::isfinite(value) || !(value > 0))
        refuse(quantity, value, unit, "finite and greater than 0");
    }
  } // namespace

  void Material::check() const
  {
    require_positive("Young's modulus E", youngs_modulus, " Pa");
    if (!std::isfinite(poisson_ratio) || poisson_ratio < 0 || poisson_ratio >= 0.5)
      refuse("Poisson's ratio nu", poisson_ratio, "", "at least 0 and less than 0.5");
    if (!std::isfinite(friction_angle) || friction_angle < 0 || friction_angle >= M_PI / 2)
      refuse("friction angle phi",
             friction_angle * degrees,
             " degrees",
             "at least 0 and less than 90 degrees");
    require_positive("uniaxial compressive strength sigma_c", compressive_strength, " Pa");

    if (criterion == Criterion::von_mises && friction_angle != 0)
      refuse_for(criterion, "friction angle phi", "drucker-prager or mohr-coulomb");
    if (criterion != Criterion::drucker_prager && flow_stress_ratio != 1)
      refuse_for(criterion, "flow stress ratio K", "drucker-prager");
    if (criterion == Criterion::von_mises && dilation_angle)
      refuse_for(criterion, "dilation angle psi", "drucker-prager or mohr-coulomb");
    if (criterion == Criterion::mohr_coulomb && hardening != 0)
      refuse_for(criterion, "hardening modulus H", "drucker-prager or von-mises");
    if (criterion != Criterion::mohr_coulomb && tension_cutoff)
      refuse_for(criterion, "tension cut-off T0", "mohr-coulomb");

    if (!std::isfinite(flow_stress_ratio) || flow_stress_ratio < 0.778 || flow_stress_ratio > 1)
      refuse("flow stress ratio K", flow_stress_ratio, "", "at least 0.778 and at most 1");
    if (!std::isfinite(flow_angle()) || flow_angle() < 0 || flow_angle() > friction_angle)
      refuse("dilation angle psi",
             flow_angle() * degrees,
             " degrees",
             "at least 0 and at most the friction angle");
    if (!std::isfinite(hardening) || hardening < 0)
      refuse("hardening modulus H", hardening, " Pa", "finite and at least 0");
    if (tension_cutoff && (!std::isfinite(*tension_cutoff) || *tension_cutoff < 0))
      refuse("tension cut-off T0", *tension_cutoff, " Pa", "finite and at least 0");
  }

  double Material::shear_strength() const
  {
    if (criterion != Criterion::mohr_coulomb)
      return laws::drucker_prager_strength(friction_angle, compressive_strength) * 2 /
             (1 + 1 / flow_stress_ratio);
    const double strength =
      std::cos(friction_angle) * laws::mohr_coulomb_cohesion(friction_angle, compressive_strength);
    return tension_cutoff ? std::min(strength, *tension_cutoff) : strength;
  }

  const char *to_string(const Criterion criterion)
  {
    return criterion == Criterion::drucker_prager ? "drucker-prager"
           : criterion == Criterion::von_mises    ? "von-mises"
                                                  : "mohr-coulomb";
  }

  Criterion parse_criterion(const std::string &name)
  {
    for (const Criterion criterion :
         {Criterion::drucker_prager, Criterion::von_mises, Criterion::mohr_coulomb})
      if (name == to_string(criterion))
        return criterion;
    throw InputError("criterion: '" + name +
                     "' is not one of drucker-prager, von-mises, mohr-coulomb");
  }

  double Scene::effective_radius() const
  {
    return second ? 1 / (1 / radius + 1 / second->radius) : radius / 2;
  }

  void Scene::check() const
  {
    require_positive("sphere radius R", radius, " m");
    require_positive("peak force F_max", force_max, " N");
    if (!second)
      return;
    if (!(second->radius > 0))
      refuse("second radius R2", second->radius, " m", "positive (infinite for a flat)");
    if (second->material)
      try
        {
          second->material->check();
        }
      catch (const InputError &error)
        {
          throw InputError(std::string("second body: ") + error.what());
        }
  }
} // namespace dpcontact
