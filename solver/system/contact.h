#ifndef DPCONTACT_SOLVER_SYSTEM_CONTACT_H
#define DPCONTACT_SOLVER_SYSTEM_CONTACT_H

#include "solver/discretisation/discretisation.h"
#include "solver/discretisation/undeformed_gap.h"
#include "solver/system/unknowns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace dpcontact
{
  /// Frictionless contact of the surface with the rigid mirror plane at its nodes, by a
  /// penalty with augmentation (Simo & Laursen, Computers & Structures 42, 1992):
  /// p = ⟨λ − ε g⟩, gap g = h(r) + w − d with the undeformed gap h of one sphere, the
  /// inward displacement w of the surface and the plane's approach d to the sphere.
  template <int dim>
  class Contact
  {
  public:
    /// What the contact adds to the system at one state.
    struct Contribution
    {
      double       force           = 0; ///< ∫ p dA
      double       force_stiffness = 0; ///< ∂F/∂d at fixed displacements
      double       max_pressure    = 0;
      double       max_violation   = 0; ///< largest |g| where p > 0
      double       rounding        = 0; ///< residual norm that rounding in ε g cannot go below
      unsigned int active          = 0; ///< nodes with p > 0
    };

    /// @param undeformed_gap h(r).
    /// @param stiffness ε, pressure over length.
    Contact(const Discretisation<dim> &discretisation,
            const UndeformedGap       &undeformed_gap,
            double                     stiffness);

    /// Adds −∂(work of p)/∂u to `residual` and ∂residual/∂d to `approach_derivative`, both over the
    /// free unknowns, and calls `add_stiffness(face, N, k)` for the part k N⊗N of the tangent that
    /// every node in contact adds to the unknowns of its face.
    template <class AddStiffness>
    Contribution evaluate(const Unknowns      &at,
                          std::vector<double> &residual,
                          std::vector<double> &approach_derivative,
                          const AddStiffness  &add_stiffness) const;

    /// λ ← ⟨λ − ε g⟩.
    void augment(const Unknowns &at);

    /// λ ← 0: nothing is known of the contact to come.
    void forget() { std::fill(multipliers.begin(), multipliers.end(), 0.); }

    /// Switches all contact off (release) or on.
    void set_active(bool active) { enabled = active; }

    /// evaluate() looks at the first `n_faces` of the surface only.
    void limit_to(unsigned int n_faces) { n_evaluated = n_faces; }

    /// Whether a face that evaluate() does not look at touches.
    bool touches_beyond(const Unknowns &at) const;

    /// Pressure and inward displacement of every point of the surface.
    struct NodalFields
    {
      std::vector<double> pressure, inward;
    };
    NodalFields nodal_fields(const Unknowns &at) const;

    /// Work of the contact on the body from one state to another by the trapezoidal rule.
    double work(const NodalFields &from, const NodalFields &to) const;

    /// Mean pressure on every face of the surface, from the axis outwards: (mean radius, p).
    std::vector<std::pair<double, double>> face_pressures(const Unknowns &at) const;

    /// Radius of the contact's edge; 0 where nothing touches. It lies within one element beyond the
    /// last node that touches, where the pressure, extrapolated from the last faces that touch
    /// wholly, vanishes; p² is taken linear in r² as in Hertz.
    double edge_radius(const Unknowns &at) const;

    /// Contact radius of an elastic sphere at this approach of the plane (Hertz): √(R d).
    double hertz_radius(double approach) const { return std::sqrt(undeformed.radius() * approach); }

    /// Approach at which the plane would first touch the surface displaced by u.
    double touching_approach(const std::vector<double> &u) const;

    /// Approach below which no node that has an area touches: below it the discrete contact cannot
    /// carry a force.
    double bearing_approach(const std::vector<double> &u) const;

    std::vector<double> multipliers; ///< λ at every point, kept between steps

  private:
    double lowest(const std::vector<double> &u, double least_weight) const;
    double inward(const typename Discretisation<dim>::SurfaceFace  &face,
                  const typename Discretisation<dim>::SurfacePoint &point,
                  const std::vector<double>                        &u) const
    {
      double w = 0;
      for (unsigned int i = 0; i < face.unknowns.size(); ++i)
        w -= point.value[i] * u[face.unknowns[i]];
      return w;
    }

    /// h(r) + w: the gap at approach 0.
    double gap_without_approach(const typename Discretisation<dim>::SurfaceFace  &face,
                                const typename Discretisation<dim>::SurfacePoint &point,
                                const std::vector<double>                        &u) const
    {
      return undeformed.gap(point.radius) + inward(face, point, u);
    }

    /// g = h(r) + w − d
    double gap_at(const typename Discretisation<dim>::SurfaceFace  &face,
                  const typename Discretisation<dim>::SurfacePoint &point,
                  const Unknowns                                   &at) const
    {
      return gap_without_approach(face, point, at.u) - at.approach;
    }

    const Discretisation<dim> &discretisation;
    UndeformedGap              undeformed;
    double                     stiffness;
    bool                       enabled = true;
    unsigned int               n_evaluated;
  };

  template <int dim>
  template <class AddStiffness>
  typename Contact<dim>::Contribution
  Contact<dim>::evaluate(const Unknowns      &at,
                         std::vector<double> &residual,
                         std::vector<double> &approach_derivative,
                         const AddStiffness  &add_stiffness) const
  {
    Contribution contribution;
    double       squared_weights = 0;
    unsigned int index           = 0;
    const auto  &faces           = discretisation.surface();
    if (!enabled)
      return contribution;
    for (unsigned int f = 0; f < n_evaluated; ++f)
      {
        const auto &face = faces[f];
        for (const auto &point : face.points)
          {
            const double gap = gap_at(face, point, at);
            const double p   = multipliers[index++] - stiffness * gap;
            if (p <= 0 || point.weight <= 0) // the node on the axis has no area
              continue;
            squared_weights += point.weight * point.weight;
            ++contribution.active;
            contribution.force += p * point.weight;
            contribution.max_pressure  = std::max(contribution.max_pressure, p);
            contribution.max_violation = std::max(contribution.max_violation, std::abs(gap));
            const double k             = stiffness * point.weight;
            contribution.force_stiffness += k;
            // Moving the surface outwards by value[i] raises p by ε value[i].
            for (unsigned int i = 0; i < face.unknowns.size(); ++i)
              {
                residual[face.unknowns[i]] += p * point.weight * point.value[i];
                approach_derivative[face.unknowns[i]] += k * point.value[i];
              }
            add_stiffness(f, point.value, k);
          }
      }
    contribution.rounding = 4 * std::numeric_limits<double>::epsilon() * stiffness *
                            std::abs(at.approach) * std::sqrt(squared_weights);
    return contribution;
  }
} // namespace dpcontact

#endif
