#include "solver/scene.h"

#include "meshing/errors.h"

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
             friction_angle * (180 / M_PI),
             " degrees",
             "at least 0 and less than 90 degrees");
    require_positive("uniaxial compressive strength sigma_c", compressive_strength, " Pa");
  }

  void Scene::check() const
  {
    require_positive("sphere radius R", radius, " m");
    require_positive("peak force F_max", force_max, " N");
  }
} // namespace dpcontact
