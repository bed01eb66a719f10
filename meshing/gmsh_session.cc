#include "meshing/gmsh_session.h"

#include "meshing/boundary_ids.h"
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

  void GmshSession::mesh_into(dealii::Triangulation<2> &mesh) const
  {
    gmsh::model::mesh::generate(2);
    const TemporaryFile file(".msh");
    gmsh::write(file.path);

    std::ifstream     input(file.path);
    dealii::GridIn<2> reader(mesh);
    reader.read_msh(input);
    if (!mesh.all_reference_cells_are_hyper_cube())
      throw SolverError("gmsh left triangles in a quadrilateral mesh");
  }

  namespace
  {
    std::string where(const dealii::Point<2> &p)
    {
      std::ostringstream text;
      text << "(r, y) = (" << p[0] << ", " << p[1] << ")";
      return text.str();
    }
  } // namespace

  void check_jacobians(const dealii::Triangulation<2> &mesh)
  {
    for (const auto &cell : mesh.active_cell_iterators())
      {
        if (!cell->reference_cell().is_hyper_cube())
          throw SolverError("mesh check: no quadrilateral at " + where(cell->center()));
        // Signed area of the corner triangles = Jacobian at the corners (deal.II numbers
        // lexicographically).
        const unsigned int corners[4][3] = {{0, 1, 2}, {1, 3, 0}, {3, 2, 1}, {2, 0, 3}};
        for (const auto &c : corners)
          {
            const dealii::Tensor<1, 2> a = cell->vertex(c[1]) - cell->vertex(c[0]);
            const dealii::Tensor<1, 2> b = cell->vertex(c[2]) - cell->vertex(c[0]);
            if (a[0] * b[1] - a[1] * b[0] <= 0)
              throw SolverError("mesh check: Jacobian not positive in the cell at " +
                                where(cell->center()));
          }
      }
  }

  void check_mesh(const dealii::Triangulation<2> &mesh)
  {
    check_jacobians(mesh);
    for (const auto &cell : mesh.active_cell_iterators())
      {
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            {
              const dealii::Point<2> m          = face->center();
              const auto             id         = face->boundary_id();
              const double           h          = face->diameter();
              const bool             on_axis    = std::abs(m[0]) < 1e-9 * h;
              const bool             on_surface = std::abs(m[1]) < 1e-9 * h;
              const unsigned int     expected   = on_axis      ? boundary::axis
                                                  : on_surface ? boundary::surface
                                                               : boundary::far;
              if (id != expected)
                throw SolverError("mesh check: the boundary face at " + where(m) + " has id " +
                                  std::to_string(id) + ", expected " + std::to_string(expected));
            }
      }
  }
} // namespace dpcontact
