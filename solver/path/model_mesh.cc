#include "solver/path/model_mesh.h"

#include "meshing/published_mesh.h"
#include "meshing/quality.h"
#include "meshing/sphere_cap.h"
#include "meshing/wedge_mesh.h"
#include "meshing/zoned_mesh.h"

#include <deal.II/grid/grid_tools.h>

namespace dpcontact
{
  namespace
  {
    PublishedMesh published_mesh(const SolverOptions &options, const double mesh_radius)
    {
      PublishedMesh mesh;
      mesh.outer_radius = options.outer_radius;
      mesh.refinements  = options.refinements;
      mesh.unit         = mesh_radius;
      return mesh;
    }

    Zones zones_of(const SolverOptions &options)
    {
      Zones zones;
      zones.resolution       = options.resolution;
      zones.refinements      = options.refinements;
      zones.surface_halvings = options.surface_halvings.value_or(0);
      zones.domain_radius    = options.domain_radius;
      zones.stretch          = options.mesh_stretch;
      zones.octaves          = options.octaves;
      return zones;
    }
  } // namespace

  template <int dim>
  MeshQuality make_model_mesh(const SolverOptions        &options,
                              const double                mesh_radius,
                              const double                sphere_radius,
                              dealii::Triangulation<dim> &mesh)
  {
    const bool published = options.mesh == MeshKind::published;
    if constexpr (dim == 2)
      {
        if (published)
          make_published_mesh(published_mesh(options, mesh_radius), mesh);
        else
          make_zoned_mesh(zones_of(options), mesh);
        if (options.mesh_distortion > 0)
          dealii::GridTools::distort_random(options.mesh_distortion, mesh, true, 1);
        if (options.surface == Surface::sphere)
          map_to_sphere(sphere_radius / mesh_radius, mesh);
      }
    else
      {
        if (published)
          make_published_mesh(published_mesh(options, mesh_radius), options.angle(), mesh);
        else
          make_wedge_mesh(zones_of(options), options.angle(), mesh);
      }
    const MeshQuality quality = assess(mesh, 1);
    if (options.units == Units::si)
      dealii::GridTools::scale(mesh_radius, mesh);
    return quality;
  }

  template MeshQuality
  make_model_mesh(const SolverOptions &, double, double, dealii::Triangulation<2> &);
  template MeshQuality
  make_model_mesh(const SolverOptions &, double, double, dealii::Triangulation<3> &);
} // namespace dpcontact
