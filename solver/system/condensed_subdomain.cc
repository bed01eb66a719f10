#include "solver/system/condensed_subdomain.h"

#include <algorithm>
#include <cmath>

namespace dpcontact
{
  namespace
  {
    constexpr unsigned int none = dealii::numbers::invalid_unsigned_int;

    /// Couples all pairs of the unknowns that `index` knows; of a symmetric matrix the upper
    /// triangle.
    void couple(const std::vector<unsigned int> &unknowns,
                const std::vector<unsigned int> &index,
                const bool                       symmetric,
                std::vector<std::vector<int>>   &columns)
    {
      for (const unsigned int i : unknowns)
        for (const unsigned int j : unknowns)
          if (index[i] != none && index[j] != none && (!symmetric || index[i] <= index[j]))
            columns[index[j]].push_back(static_cast<int>(index[i]));
    }

    template <int dim>
    dealii::Point<dim> centre(const typename Discretisation<dim>::Cell &cell)
    {
      dealii::Point<dim> sum;
      for (const auto &point : cell.points)
        sum += point.position;
      return sum / static_cast<double>(cell.points.size());
    }

    /// Position of each listed unknown in the list.
    std::vector<unsigned int> inverse(const std::vector<unsigned int> &list, const unsigned int n)
    {
      std::vector<unsigned int> index(n, none);
      for (unsigned int k = 0; k < list.size(); ++k)
        index[list[k]] = k;
      return index;
    }
  } // namespace

  template <int dim>
  CondensedSubdomain<dim>::CondensedSubdomain(
    const Discretisation<dim>              &space,
    const std::vector<std::vector<double>> &elastic_blocks,
    const double                            radius_,
    const bool                              symmetric,
    const LinearSolver                      kind)
    : radius(radius_)
    , n_faces(0)
    , far_stiffness(space.n_bodies(), 0.)
  {
    for (unsigned int b = 0; b < space.n_bodies(); ++b)
      far_unknown.push_back(space.far_unknown(b));
    std::vector<bool> inside(space.cells().size());
    for (unsigned int c = 0; c < inside.size(); ++c)
      {
        inside[c] = centre<dim>(space.cells()[c]).norm() <= radius;
        (inside[c] ? cells : outside).push_back(c);
      }
    std::vector<bool> touched_inside(space.n_free(), false), touched_outside(space.n_free(), false);
    for (unsigned int c = 0; c < inside.size(); ++c)
      for (const unsigned int i : space.cells()[c].unknowns)
        (inside[c] ? touched_inside : touched_outside)[i] = true;
    const bool alone = space.communicator().alone();
    for (unsigned int i = 0; i < space.n_free(); ++i)
      {
        if (touched_inside[i])
          unknowns.push_back(i);
        else if (alone)
          exterior.push_back(i);
        if (touched_inside[i] && touched_outside[i])
          shared.push_back(i);
      }
    while (n_faces < space.surface().size() && (!alone || inside[space.surface()[n_faces].cell]))
      ++n_faces;

    matrix.symmetric                            = symmetric;
    const std::vector<unsigned int> inner_index = inverse(unknowns, space.n_free());
    build_pattern(space, inner_index);
    for (std::size_t k = 0; k < cells.size(); ++k)
      add_elastic(elastic_blocks[cells[k]], k);
    for (unsigned int b = 0; b < space.n_bodies(); ++b)
      {
        const bool   here    = touched_inside[far_unknown[b]];
        const double holders = space.communicator().sum(here ? 1. : 0.);
        if (holders > 0)
          far_stiffness[b] = space.exterior_stiffness(b);
        if (here)
          {
            const unsigned int far = inner_index[far_unknown[b]];
            matrix.value[matrix.position(far, far)] += far_stiffness[b] / holders;
          }
      }
    if (!shared.empty())
      condense(space, elastic_blocks, inner_index);
    elastic_values = matrix.value;
    if (alone && kind == LinearSolver::direct)
      serial = make_direct_solver(matrix);
    else
      distributed = std::make_unique<DistributedSolver<dim>>(space, matrix, unknowns, kind);
  }

  template <int dim>
  bool CondensedSubdomain<dim>::factorize()
  {
    return serial ? serial->factorize(matrix) : distributed->factorize(matrix);
  }

  template <int dim>
  bool CondensedSubdomain<dim>::solve(const std::vector<double> &b,
                                      const double               factor,
                                      std::vector<double>       &x)
  {
    if (distributed)
      return distributed->solve(b, factor, x);
    inner_rhs.resize(unknowns.size());
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      inner_rhs[i] = factor * b[unknowns[i]];
    serial->solve(inner_rhs, inner_solution);
    std::fill(x.begin(), x.end(), 0.);
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      x[unknowns[i]] = inner_solution[i];
    return true;
  }

  template <int dim>
  void CondensedSubdomain<dim>::add_elastic(const std::vector<double> &upper_triangle,
                                            const std::size_t          cell)
  {
    const std::vector<int> &positions = cell_positions[cell];
    if (matrix.symmetric)
      {
        for (std::size_t e = 0; e < positions.size(); ++e)
          matrix.value[positions[e]] += upper_triangle[e];
        return;
      }
    const auto    n     = static_cast<std::size_t>(std::lround(std::sqrt(positions.size())));
    const double *entry = upper_triangle.data();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i; j < n; ++j, ++entry)
        {
          matrix.value[positions[i * n + j]] += *entry;
          if (i != j)
            matrix.value[positions[j * n + i]] += *entry;
        }
  }

  template <int dim>
  void CondensedSubdomain<dim>::build_pattern(const Discretisation<dim>       &space,
                                              const std::vector<unsigned int> &inner_index)
  {
    std::vector<std::vector<int>> columns(unknowns.size());
    for (const unsigned int c : cells)
      couple(space.cells()[c].unknowns, inner_index, matrix.symmetric, columns);
    const auto own = [&](const unsigned int f) { return space.surface()[f].cell != none; };
    for (unsigned int f = 0; f < n_faces; ++f)
      if (own(f))
        couple(space.surface()[f].unknowns, inner_index, matrix.symmetric, columns);
    couple(shared, inner_index, matrix.symmetric, columns);
    matrix = SparseMatrix::with_pattern(std::move(columns), matrix.symmetric);

    const auto positions = [&](const std::vector<unsigned int> &of) {
      std::vector<int> result;
      for (unsigned int i = 0; i < of.size(); ++i)
        for (unsigned int j = matrix.symmetric ? i : 0; j < of.size(); ++j)
          result.push_back(matrix.position(inner_index[of[i]], inner_index[of[j]]));
      return result;
    };
    for (const unsigned int c : cells)
      cell_positions.push_back(positions(space.cells()[c].unknowns));
    for (unsigned int f = 0; f < n_faces; ++f)
      surface_positions.push_back(own(f) ? positions(space.surface()[f].unknowns)
                                         : std::vector<int>());
  }

  template <int dim>
  void CondensedSubdomain<dim>::condense(const Discretisation<dim>              &space,
                                         const std::vector<std::vector<double>> &elastic_blocks,
                                         const std::vector<unsigned int>        &inner_index)
  {
    const std::vector<unsigned int> exterior_index = inverse(exterior, space.n_free());
    const std::vector<unsigned int> shared_index   = inverse(shared, space.n_free());
    const std::size_t               n = shared.size(), n_exterior = exterior.size();

    std::vector<std::vector<int>> columns(n_exterior);
    for (const unsigned int c : outside)
      couple(space.cells()[c].unknowns, exterior_index, true, columns);
    SparseMatrix        K_EE = SparseMatrix::with_pattern(std::move(columns), true);
    std::vector<double> K_EI(n_exterior * n, 0.); // by columns
    stiffness.assign(n * n, 0.);
    for (const unsigned int c : outside)
      {
        const auto   &of    = space.cells()[c].unknowns;
        const double *entry = elastic_blocks[c].data();
        for (std::size_t i = 0; i < of.size(); ++i)
          for (std::size_t j = i; j < of.size(); ++j, ++entry)
            {
              const unsigned int ei = exterior_index[of[i]], ej = exterior_index[of[j]];
              const unsigned int si = shared_index[of[i]], sj = shared_index[of[j]];
              if (ei != none && ej != none)
                K_EE.value[K_EE.position(ei, ej)] += *entry;
              else if (ei != none)
                K_EI[sj * n_exterior + ei] += *entry;
              else if (ej != none)
                K_EI[si * n_exterior + ej] += *entry;
              else
                {
                  stiffness[si * n + sj] += *entry;
                  if (i != j)
                    stiffness[sj * n + si] += *entry;
                }
            }
      }
    for (unsigned int b = 0; b < space.n_bodies(); ++b)
      if (const unsigned int far = exterior_index[far_unknown[b]]; far != none)
        K_EE.value[K_EE.position(far, far)] += space.exterior_stiffness(b);

    const auto elastic  = make_direct_solver(K_EE);
    const bool definite = elastic->factorize(K_EE);
    Assert(definite, dealii::ExcInternalError());
    (void)definite;
    elastic->solve(K_EI, recovery);
    for (double &value : recovery)
      value = -value;
    std::vector<std::size_t> coupled; // the few rows of a column of K_EI that are not zero
    for (std::size_t i = 0; i < n; ++i)
      {
        coupled.clear();
        for (std::size_t e = 0; e < n_exterior; ++e)
          if (K_EI[i * n_exterior + e] != 0)
            coupled.push_back(e);
        for (std::size_t j = i; j < n; ++j)
          {
            double product = 0;
            for (const std::size_t e : coupled)
              product += K_EI[i * n_exterior + e] * recovery[j * n_exterior + e];
            stiffness[i * n + j] += product;
            stiffness[j * n + i]  = stiffness[i * n + j];
            const unsigned int ci = inner_index[shared[i]], cj = inner_index[shared[j]];
            matrix.value[matrix.position(ci, cj)] += stiffness[i * n + j];
            if (!matrix.symmetric && i != j)
              matrix.value[matrix.position(cj, ci)] += stiffness[i * n + j];
          }
      }
  }

  template <int dim>
  void CondensedSubdomain<dim>::add_exterior_force(const std::vector<double> &u,
                                                   std::vector<double>       &residual) const
  {
    for (std::size_t b = 0; b < far_unknown.size(); ++b)
      residual[far_unknown[b]] += far_stiffness[b] * u[far_unknown[b]];
    const std::size_t n = shared.size();
    for (std::size_t i = 0; i < n; ++i)
      {
        double force = 0;
        for (std::size_t j = 0; j < n; ++j)
          force += stiffness[i * n + j] * u[shared[j]];
        residual[shared[i]] += force;
      }
  }

  template <int dim>
  void CondensedSubdomain<dim>::recover(std::vector<double> &u) const
  {
    const std::size_t n_exterior = exterior.size();
    for (const unsigned int e : exterior)
      u[e] = 0;
    for (std::size_t j = 0; j < shared.size(); ++j)
      for (std::size_t e = 0; e < n_exterior; ++e)
        u[exterior[e]] += recovery[j * n_exterior + e] * u[shared[j]];
  }

  template class CondensedSubdomain<2>;
  template class CondensedSubdomain<3>;
} // namespace dpcontact
