#include "meshing/gmsh_session.h"

#include "meshing/boundary_ids.h"
#include "meshing/corner_jacobian.h"
#include "meshing/errors.h"

#include <deal.II/grid/grid_in.h>

#include <gmsh.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <unistd.h>

namespace dpcontact
{
  namespace
  {
    /// A file of its own under the temporary directory, gone with its scope.
    class TemporaryFile
    {
    public:
      explicit TemporaryFile(const std::string &suffix)
      {
        path = (std::filesystem::temp_directory_path() / "dpcontact-XXXXXX").string() + suffix;
        const int descriptor = mkstemps(path.data(), static_cast<int>(suffix.size()));
        if (descriptor < 0)
          throw FileError("cannot create a temporary file like '" + path +
                          "': check that the directory (TMPDIR) is writable");
        close(descriptor);
      }
      ~TemporaryFile()
      {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
      }
      TemporaryFile(const TemporaryFile &)            = delete;
      TemporaryFile &operator=(const TemporaryFile &) = delete;

      std::string path;
    };
  } // namespace

  GmshSession::GmshSession()
  {
    gmsh::initialize(0, nullptr, /*readConfigFiles=*/false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::option::setNumber("Mesh.MshFileVersion", 4.1);
    gmsh::model::add("dpcontact");
  }

  GmshSession::~GmshSession() { gmsh::finalize(); }

  void GmshSession::name_groups(const std::vector<int> &axis,
                                const std::vector<int> &surface,
                                const std::vector<int> &far,
                                const std::vector<int> &faces) const
  {
    gmsh::model::geo::synchronize();
    gmsh::model::addPhysicalGroup(1, axis, boundary::axis);
    gmsh::model::addPhysicalGroup(1, surface, boundary::surface);
    gmsh::model::addPhysicalGroup(1, far, boundary::far);
    gmsh::model::addPhysicalGroup(2, faces, 1);
    gmsh::model::setPhysicalName(1, boundary::axis, "axis");
    gmsh::model::setPhysicalName(1, boundary::surface, "surface");
    gmsh::model::setPhysicalName(1, boundary::far, "far");
  }

  template <int dim>
  void GmshSession::mesh_into(dealii::Triangulation<dim> &mesh) const
  {
    gmsh::model::mesh::generate(dim);
    const TemporaryFile file(".msh");
    gmsh::write(file.path);

    std::ifstream       input(file.path);
    dealii::GridIn<dim> reader(mesh);
    reader.read_msh(input);
    if (!mesh.all_reference_cells_are_hyper_cube())
      throw SolverError(dim == 2 ? "gmsh left triangles in a quadrilateral mesh"
                                 : "gmsh left other cells than bricks in a mesh of bricks");
  }

  namespace
  {
    std::string where(const dealii::Point<2> &p)
    {
      std::ostringstream text;
      text << "(r, y) = (" << p[0] << ", " << p[1] << ")";
      return text.str();
    }

    std::string where(const dealii::Point<3> &p)
    {
      std::ostringstream text;
      text << "(x, y, z) = (" << p[0] << ", " << p[1] << ", " << p[2] << ")";
      return text.str();
    }

    /// The id that belongs where all of the face's vertices lie, to 1e-9 of its size.
    template <int dim, typename Face>
    unsigned int expected_id(const Face &face, const double angle)
    {
      const auto lies_on = [&](const dealii::Tensor<1, dim> &normal) {
        for (const unsigned int v : face->vertex_indices())
          if (!(std::abs(normal * face->vertex(v)) < 1e-9 * face->diameter()))
            return false;
        return true;
      };
      dealii::Tensor<1, dim> normal;
      normal[dim - 1] = 1;
      if (lies_on(normal))
        return boundary::surface;
      normal = dealii::Tensor<1, dim>();
      if constexpr (dim == 2)
        normal[0] = 1;
      else if (angle > 2 * M_PI - 1e-9)
        return boundary::far;
      else
        {
          normal[1] = 1;
          if (lies_on(normal))
            return boundary::axis;
          normal[0] = std::sin(angle);
          normal[1] = -std::cos(angle);
        }
      return lies_on(normal) ? boundary::axis : boundary::far;
    }
  } // namespace

  template <int dim>
  void check_jacobians(const dealii::Triangulation<dim> &mesh)
  {
    for (const auto &cell : mesh.active_cell_iterators())
      {
        if (!cell->reference_cell().is_hyper_cube())
          throw SolverError(std::string("mesh check: no ") +
                            (dim == 2 ? "quadrilateral" : "brick") + " at " +
                            where(cell->center()));
        double lengths;
        for (const unsigned int v : cell->vertex_indices())
          if (!(corner_jacobian<dim>(cell, v, lengths) > 0))
            throw SolverError("mesh check: Jacobian not positive in the cell at " +
                              where(cell->center()));
      }
  }

  template <int dim>
  void check_mesh(const dealii::Triangulation<dim> &mesh, const double angle)
  {
    check_jacobians(mesh);
    for (const auto &cell : mesh.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          {
            const unsigned int id = face->boundary_id(), expected = expected_id<dim>(face, angle);
            if (id != expected)
              throw SolverError("mesh check: the boundary face at " + where(face->center()) +
                                " has id " + std::to_string(id) + ", expected " +
                                std::to_string(expected));
          }
  }

  template void GmshSession::mesh_into(dealii::Triangulation<2> &) const;
  template void GmshSession::mesh_into(dealii::Triangulation<3> &) const;
  template void check_jacobians(const dealii::Triangulation<2> &);
  template void check_jacobians(const dealii::Triangulation<3> &);
  template void check_mesh(const dealii::Triangulation<2> &, double);
  template void check_mesh(const dealii::Triangulation<3> &, double);
} // namespace dpcontact
