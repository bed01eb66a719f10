#ifndef DPCONTACT_DATABASE_TABLES_UNIVERSAL_TABLE_H
#define DPCONTACT_DATABASE_TABLES_UNIVERSAL_TABLE_H

#include "database/rows/store.h"

#include <array>
#include <filesystem>
#include <iosfwd>
#include <string>
#include <vector>

namespace dpcontact
{
  /// What a universal table calls itself in files.
  constexpr const char *universal_title = "dpcontact: universal table of elastic-plastic contact";

  /// What is known at one (ν, φ, Λ), in the consistent convention: forces in F_y, approaches in the
  /// mutual δ_y.
  struct UniversalNode
  {
    static constexpr double unset = unset_number;

    double nu = unset, phi_deg = unset, load_level = unset;
    double approach          = unset; ///< δ/δ_y where F = Λ F_y on the virgin loading curve
    double residual_approach = unset; ///< δ_res/δ_y after release from Λ
    double a = unset, b = unset, m = unset, n = unset; ///< eqs (16), (17) of the path to Λ
    /// m, n of the branch along which a contact law unloads: it passes through the peak, and δ_res
    /// follows from eq (18) (fit_through_peak()).
    double m_law = unset, n_law = unset;

    double approach_error          = unset; ///< numerical error of ln(approach)
    double residual_approach_error = unset; ///< numerical error, in δ_y
    /// Numerical error of each coefficient: of mesh, load step, contact and far field together.
    double a_error = unset, b_error = unset, m_error = unset, n_error = unset;
    /// How well the power laws describe the path: standard error and change with the window.
    double a_misfit = unset, b_misfit = unset, m_misfit = unset, n_misfit = unset;
    double rmse_loading = unset, rmse_unloading = unset; ///< of the power laws, over the peak force

    double pressure_yield  = unset; ///< Hertz peak pressure at F_y, over σ_c
    double ring_load_level = unset; ///< load level at which the ring r = a yields
  };

  /// A column of the universal table. All but phi_deg are without dimension.
  struct UniversalColumn
  {
    const char *name;
    const char *unit;
    const char *description;
    double UniversalNode::*member;
    Range                  range = {}; ///< of its values
  };
  const std::vector<UniversalColumn> &universal_columns();

  /// Nodes on a grid: every ν with every φ and every Λ.
  class UniversalTable
  {
  public:
    /// Makes the table of the rows of a sweep over (ν, φ, Λ). The loading states of all paths of
    /// one (ν, φ) make one smooth curve, because single states scatter: the contact's edge moves
    /// from node to node.
    /// @param revision of the program, for the provenance
    /// @throws InputError where the rows are no complete grid, a row failed, or a material is not
    /// associated, perfectly plastic Drucker–Prager.
    static UniversalTable from_rows(const Database &database, const std::string &revision);

    /// Reads what write() has written.
    /// @throws FileError where it cannot be read, CorruptData where digest, header, a number or the
    /// grid is wrong.
    static UniversalTable read(const std::filesystem::path &file);

    /// The table in the text of a file.
    /// @param name of the file, for messages.
    /// @throws CorruptData as read() does.
    static UniversalTable from_text(const std::string &name, const std::string &text);

    /// The nodes of both tables together, so that what has been computed need not be computed again
    /// where an axis becomes denser. The provenance is that of this table, and says which revision
    /// made the other nodes.
    /// @throws InputError where they were made with other settings than the grid, or are no grid
    /// together.
    UniversalTable joined(const UniversalTable &other) const;

    /// Writes a CSV file: comments with the provenance and the columns' meaning, a header, one line
    /// for each node with ν the slowest; and its digest (digest.h). @throws FileError.
    void write(const std::filesystem::path &file) const;
    void write(std::ostream &out) const;

    const std::vector<double> &nu() const { return axes[0]; }
    const std::vector<double> &phi_deg() const { return axes[1]; }
    const std::vector<double> &load_level() const { return axes[2]; }

    const std::vector<UniversalNode> &all() const { return nodes; }
    const UniversalNode &node(std::size_t i_nu, std::size_t i_phi, std::size_t i_level) const
    {
      return nodes[(i_nu * axes[1].size() + i_phi) * axes[2].size() + i_level];
    }

    const Provenance &made_from() const { return provenance; }

    /// Whether the nodes of the text that it was read from stood in the order of write().
    bool was_read_in_order() const { return was_in_order; }

  private:
    UniversalTable(std::vector<UniversalNode> nodes, Provenance provenance);

    std::array<std::vector<double>, 3> axes;
    std::vector<UniversalNode>         nodes;
    Provenance                         provenance;
    bool                               was_in_order = true;
  };
} // namespace dpcontact

#endif
