#ifndef DPCONTACT_SOLVER_SYSTEM_NESTED_SUBDOMAINS_H
#define DPCONTACT_SOLVER_SYSTEM_NESTED_SUBDOMAINS_H

#include "solver/system/condensed_subdomain.h"

#include <memory>
#include <vector>

namespace dpcontact
{
  /// Whether what stays elastic is condensed onto the part of the body that is solved for.
  enum class Condensation
  {
    none, ///< every step is solved for the whole body
    nested_subdomains
  };

  /// Condensed subdomains of growing radius, the last of them the whole body, of which one is in
  /// use. Each is made when it is first needed.
  template <int dim>
  class NestedSubdomains
  {
  public:
    /// @param space must outlive this object.
    /// @param elastic_blocks elastic stiffness of every cell: upper triangle, row by row.
    /// @param symmetric whether the tangents of what yields are.
    NestedSubdomains(const Discretisation<dim>       &space,
                     std::vector<std::vector<double>> elastic_blocks,
                     Condensation                     condensation,
                     bool                             symmetric,
                     LinearSolver                     kind);

    CondensedSubdomain<dim>       &present() { return *subdomain; }
    const CondensedSubdomain<dim> &present() const { return *subdomain; }

    void use_first() { use(0); }
    void use_next() { use(stage + 1); }
    /// Takes the next ones until `distance` from the contact's centre lies well within.
    void cover(double distance);

  private:
    void use(std::size_t stage);

    const Discretisation<dim>       &space;
    std::vector<std::vector<double>> elastic_blocks;
    bool                             symmetric;
    LinearSolver                     kind;
    std::vector<double>              radii; ///< ascending; the last is infinite

    std::vector<std::unique_ptr<CondensedSubdomain<dim>>> made;
    std::size_t                                           stage     = 0;
    CondensedSubdomain<dim>                              *subdomain = nullptr; ///< in use
  };
} // namespace dpcontact

#endif
