#ifndef DPCONTACT_TESTS_SUPPORT_CONTACT_PROBLEM_H
#define DPCONTACT_TESTS_SUPPORT_CONTACT_PROBLEM_H

#include "meshing/zoned_mesh.h"
#include "solver/laws/strengths.h"
#include "solver/path/load_path.h"
#include "solver/system/contact_system.h"

#include <cmath>

namespace dpcontact::tests
{
  /// An axisymmetric contact in the solver's own units, E = R = 1 and lengths in the contact radius
  /// that the mesh is fitted to, with everything open to a test.
  struct ContactProblem
  {
    dealii::Triangulation<2> mesh;
    Discretisation<2>        space;
    ContactSystem<2>         system;

    /// @param strength uniaxial compressive strength σc over E a/R.
    ContactProblem(const double       nu,
                   const double       friction_angle_deg,
                   const double       strength,
                   const unsigned int resolution,
                   const double       penalty_stiffness = 1e5,
                   const Element      element           = Element::serendipity_reduced)
      : ContactProblem(
          laws::DruckerPrager{
            1 / (2 * (1 + nu)),
            1 / (3 * (1 - 2 * nu)),
            laws::drucker_prager_alpha(friction_angle_deg * (M_PI / 180)),
            laws::drucker_prager_strength(friction_angle_deg * (M_PI / 180), strength)},
          nu,
          resolution,
          penalty_stiffness,
          element)
    {}

    ContactProblem(const laws::Law   &law,
                   const double       nu,
                   const unsigned int resolution,
                   const double       penalty_stiffness = 1e5,
                   const Element      element           = Element::serendipity_reduced)
      : space(zoned(mesh, resolution), BoussinesqField<2>(1., nu), element)
      , system(space, {law}, 1., penalty_stiffness)
    {}

    /// Hertz's force for a contact radius of 1: (4/3) E* a³/R* with the constants of one sphere.
    static double hertz_force(const double nu) { return 4. / (3 * (1 - nu * nu)); }

  private:
    static dealii::Triangulation<2> &zoned(dealii::Triangulation<2> &mesh,
                                           const unsigned int        resolution)
    {
      Zones zones;
      zones.resolution = resolution;
      make_zoned_mesh(zones, mesh);
      return mesh;
    }
  };

  /// y = A x of the upper triangle that SparseMatrix keeps.
  inline std::vector<double> multiply(const SparseMatrix &A, const std::vector<double> &x)
  {
    std::vector<double> y(x.size(), 0.);
    for (unsigned int j = 0; j < A.n(); ++j)
      for (int k = A.column_start[j]; k < A.column_start[j + 1]; ++k)
        {
          const auto position = static_cast<std::size_t>(k);
          const auto i        = static_cast<unsigned int>(A.row[position]);
          y[i] += A.value[position] * x[j];
          if (i != j && A.symmetric)
            y[j] += A.value[position] * x[i];
        }
    return y;
  }

  inline double norm(const std::vector<double> &v)
  {
    double square = 0;
    for (const double x : v)
      square += x * x;
    return std::sqrt(square);
  }
} // namespace dpcontact::tests

#endif
