#include "solver/problem/scene.h"

#include "meshing/errors.h"

#include <algorithm>

namespace dpcontact
{
  namespace
  {
    constexpr Range positive{0, std::numeric_limits<double>::infinity(), true, false};
  }

  bool operator==(const SecondBody &p, const SecondBody &q)
  {
    return p.radius == q.radius && p.material == q.material;
  }

  bool operator==(const Scene &p, const Scene &q)
  {
    return p.radius == q.radius && p.force_max == q.force_max && p.second == q.second;
  }

  double Scene::effective_radius() const
  {
    return second ? 1 / (1 / radius + 1 / second->radius) : radius / 2;
  }

  double Scene::smaller_radius() const
  {
    return second ? std::min(radius, second->radius) : radius;
  }

  void Scene::check() const
  {
    check_range("sphere radius R", radius, Dimension::length, positive);
    check_range("peak force F_max", force_max, Dimension::force, positive);
    if (!second)
      return;
    if (!(second->radius > 0))
      refuse_value(
        "second radius R2", second->radius, Dimension::length, "positive (infinite for a flat)");
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
