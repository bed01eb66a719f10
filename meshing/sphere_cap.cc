#include "meshing/sphere_cap.h"

#include "meshing/errors.h"
#include "meshing/gmsh_session.h"

#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dpcontact
{
  dealii::Point<2> to_sphere(const dealii::Point<2> &p, const double sphere_radius)
  {
    const double rho = p.norm();
    if (rho == 0)
      return p;
    const double share = std::acos(rho / (2 * sphere_radius)) / (M_PI / 2);
    const double theta = share * std::atan2(p[0], -p[1]);
    return {rho * std::sin(theta), -rho * std::cos(theta)};
  }

  void map_to_sphere(const double sphere_radius, dealii::Triangulation<2> &mesh)
  {
    double reach = 0;
    for (const auto &vertex : mesh.get_vertices())
      reach = std::max(reach, vertex.norm());
    // A far boundary asked for at just R may be rounded beyond it.
    if (!(reach <= sphere_radius * (1 + 1e-9)))
      {
        std::ostringstream message;
        message << "option domain-radius: the mesh reaches " << reach
                << " contact radii from the contact, but the sphere's radius is " << sphere_radius
                << "; with surface = sphere the far boundary must lie within the sphere's radius";
        throw InputError(message.str());
      }
    dealii::GridTools::transform(
      [sphere_radius](const dealii::Point<2> &p) { return to_sphere(p, sphere_radius); }, mesh);
    check_jacobians(mesh);
  }
} // namespace dpcontact
