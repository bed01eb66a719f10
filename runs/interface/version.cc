#include "runs/interface/version.h"

#include "git_revision.h"

#include <CLI/Version.hpp>
#include <H5public.h>
#include <gmsh.h>
#include <gsl/gsl_version.h>
#include <nlohmann/json.hpp>

#define DPCONTACT_TEXT_(x) #x
#define DPCONTACT_TEXT(x) DPCONTACT_TEXT_(x)

namespace dpcontact
{
  std::string git_revision() { return DPCONTACT_GIT_REVISION; }

  std::map<std::string, std::string> versions()
  {
    return {{"dpcontact", DPCONTACT_VERSION},
            {"git_revision", git_revision()},
            {"compiler", __VERSION__},
            {"deal.II", DPCONTACT_DEALII_VERSION},
            {"gmsh", GMSH_API_VERSION},
            {"GSL", GSL_VERSION},
            {"HDF5",
             DPCONTACT_TEXT(H5_VERS_MAJOR) "." DPCONTACT_TEXT(H5_VERS_MINOR) "." DPCONTACT_TEXT(
               H5_VERS_RELEASE)},
            {"CLI11", CLI11_VERSION},
            {"nlohmann-json",
             DPCONTACT_TEXT(NLOHMANN_JSON_VERSION_MAJOR) "." DPCONTACT_TEXT(
               NLOHMANN_JSON_VERSION_MINOR) "." DPCONTACT_TEXT(NLOHMANN_JSON_VERSION_PATCH)}};
  }
} // namespace dpcontact
