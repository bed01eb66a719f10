#include "meshing/gmsh_session.h"

#include "meshing/boundary_ids.h"
#include "meshing/corner_jacobian.h"
#include "meshing/errors.h"

#include <deal.II/grid/grid_in.h>

#include <gmsh.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

/// FLTK's class, whose function gmsh calls for one option of its windows when it starts. FLTK's own
/// function would write preferences into /etc/fltk and into the home directory for that. This
/// program has no windows, and the definition here takes the place of the library's.
class Fl
{
public:
  enum Fl_Option : unsigned int
  {
  };
  static void option(Fl_Option, bool);
};
void Fl::option(Fl_Option, bool) {}

namespace dpcontact
{
  namespace
  {
    /// The directory for temporary files. @throws FileError where it is none.
    std::filesystem::path temporary_directory()
    {
      std::error_code             error;
      const std::filesystem::path directory = std::filesystem::temp_directory_path(error);
      if (!error)
        return directory;
      const char *const given = std::getenv("TMPDIR");
      throw FileError(std::string("the directory for temporary files (TMPDIR = '") +
                      (given == nullptr ? "" : given) + "') cannot be used: " + error.message());
    }

    /// A mesh file of its own in the directory for temporary files, gone with its scope. A lock on
    /// it (flock) tells that somebody is at work, so that what killed processes left can be
    /// removed.
    class TemporaryMesh
    {
    public:
      TemporaryMesh()
      {
        const std::filesystem::path directory = temporary_directory();
        remove_leftovers(directory);
        path       = (directory / (std::string(prefix) + "XXXXXX" + suffix)).string();
        descriptor = mkostemps(path.data(), static_cast<int>(std::strlen(suffix)), O_CLOEXEC);
        if (descriptor < 0)
          throw FileError("cannot create a temporary file like '" + path +
                          "' (see TMPDIR): " + std::strerror(errno));
        ::flock(descriptor, LOCK_EX);
      }
      ~TemporaryMesh()
      {
        std::error_code ignored;
        std::filesystem::remove(path, ignored);
        ::close(descriptor);
      }
      TemporaryMesh(const TemporaryMesh &)            = delete;
      TemporaryMesh &operator=(const TemporaryMesh &) = delete;

      std::string path;

    private:
      static constexpr const char *prefix = "dpcontact-";
      static constexpr const char *suffix = ".msh";

      static bool is_ours(const std::string &name)
      {
        const std::size_t ends = std::strlen(prefix) + std::strlen(suffix);
        return name.size() == ends + 6 && name.rfind(prefix, 0) == 0 &&
               name.compare(name.size() - std::strlen(suffix), std::string::npos, suffix) == 0;
      }

      /// What nobody holds, of this user.
      static void remove_leftovers(const std::filesystem::path &directory)
      {
        std::error_code ignored;
        for (const auto &entry : std::filesystem::directory_iterator(directory, ignored))
          {
            if (!is_ours(entry.path().filename().string()))
              continue;
            const int   file   = ::open(entry.path().c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
            struct stat status = {};
            if (file >= 0 && ::fstat(file, &status) == 0 && status.st_uid == ::geteuid() &&
                ::flock(file, LOCK_EX | LOCK_NB) == 0)
              std::filesystem::remove(entry.path(), ignored);
            if (file >= 0)
              ::close(file);
          }
      }

      int descriptor = -1;
    };

    /// gmsh's mesh of its model in the text of its format 4.1. gmsh writes no other place than a
    /// file, which is there for no longer than that takes.
    /// @throws FileError where the file is not whole, of which gmsh itself says nothing.
    std::string mesh_text()
    {
      const TemporaryMesh file;
      gmsh::write(file.path);
      std::ifstream     input(file.path);
      std::stringstream text;
      text << input.rdbuf();
      const std::string content = text.str(), end = "$EndElements\n";
      if (content.size() < end.size() ||
          content.compare(content.size() - end.size(), end.size(), end) != 0)
        throw FileError("cannot write the mesh into the temporary file " + file.path +
                        ": the disk (see TMPDIR) may be full");
      return content;
    }
  } // namespace

  GmshSession::GmshSession()
  {
    gmsh::initialize(0, nullptr, /*readConfigFiles=*/false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::option::setNumber("General.SaveOptions", 0);
    gmsh::option::setNumber("General.SaveSession", 0);
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
    std::istringstream  input(mesh_text());
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
