#ifndef DPCONTACT_SOLVER_CONTACT_H
#define DPCONTACT_SOLVER_CONTACT_H

#include "solver/discretization.h"
#include "solver/profile.h"

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
    struct Response
    {
      double       force           = 0; ///< ∫ p dA
      double       force_stiffness = 0; ///< ∂F/∂d at fixed displacements
      double       max_pressure    = 0;
      double       max_violation   = 0; ///< largest |g| where p > 0
      double       rounding        = 0; ///< residual norm that rounding in ε g cannot go below
      unsigned int active          = 0; ///< nodes with p > 0
    };

    /// @param profile the undeformed gap h(r).
    /// @param stiffness ε, pressure over length.
    Contact(const Discretization<dim> &discretization, const Profile &profile, double stiffness);

    /// Adds −∂(work of p)/∂u to `residual`, and where asked ε∫N⊗N to `add_stiffness(face, i, j, k)`
    /// and ∂residual/∂d to `approach_derivative`.
    template <class AddStiffness>
    Response evaluate(const std::vector<double> &u,
                      double                     approach,
                      std::vector<double>       &residual,
                      std::vector<double>       &approach_derivative,
                      const AddStiffness        &add_stiffness) const;

    /// λ ← ⟨λ − ε g⟩.
    void augment(const std::vector<double> &u, double approach);

    /// λ ← 0: nothing is known of the contact to come.
    void forget() { std::fill(multipliers.begin(), multipliers.end(), 0.); }

    /// Switches all contact off (release) or on.
    void set_active(bool active) { enabled = active; }

    /// evaluate() looks at the first `n_faces` of the surface only.
    void limit_to(unsigned int n_faces) { n_evaluated = n_faces; }

    /// Whether a face that evaluate() does not look at touches.
    bool touches_beyond(const std::vector<double> &u, double approach) const;

    /// Pressure and inward displacement of every point of the surface.
    struct Surface
    {
      std::vector<double> pressure, inward;
    };
    Surface state(const std::vector<double> &u, double approach) const;

    /// Work of the contact on the body from one state to another by the trapezoidal rule.
    double work(const Surface &from, const Surface &to) const;

    /// Mean pressure on every face of the surface, from the axis outwards: (mean radius, p).
    std::vector<std::pair<double, double>> profile(const std::vector<double> &u,
                                                   double                     approach) const;

    /// Radius of the contact's edge; 0 where nothing touches. It lies within one element beyond the
    /// last node that touches, where the pressure, extrapolated from the last faces that touch
    /// wholly, vanishes; p² is taken linear in r² as in Hertz.
    double edge_radius(const std::vector<double> &u, double approach) const;

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
    double inward(const typename Discretization<dim>::SurfaceFace  &face,
                  const typename Discretization<dim>::SurfacePoint &point,
                  const std::vector<double>                        &u) const
    {
      double w = 0;
      for (unsigned int i = 0; i < face.unknowns.size(); ++i)
        w -= point.value[i] * u[face.unknowns[i]];
      return w;
    }

    /// g = h(r) + w − d
    double gap_at(const typename Discretization<dim>::SurfaceFace  &face,
                  const typename Discretization<dim>::SurfacePoint &point,
                  const std::vector<double>                        &u,
                  const double                                      approach) const
    {
      return undeformed.gap(point.radius) + inward(face, point, u) - approach;
    }

    const Discretization<dim> &discretization;
    Profile                    undeformed;
    double                     stiffness;
    bool                       enabled = true;
    unsigned int               n_evaluated;
  };

  template <int dim>
  template <class AddStiffness>
  typename Contact<dim>::Response Contact<dim>::evaluate(const std::vector<double> &u,
                                                         const double               approach,
                                                         std::vector<double>       &residual,
                                                         std::vector<double> &approach_derivative,
                                                         const AddStiffness  &add_stiffness) const
  {
    Response     response;
    double       squared_weights = 0;
    unsigned int index           = 0;
    const auto  &faces           = discretization.surface();
    if (!enabled)
      return response;
    for (unsigned int f = 0; f < n_evaluated; ++f)
      {
        const auto &face = faces[f];
        for (const auto &point : face.points)
          {
            const double gap = gap_at(face, point, u, approach);
            const double p   = multipliers[index++] - stiffness * gap;
            if (p <= 0 || point.weight <= 0) // the node on the axis has no area
              continue;
            squared_weights += point.weight * point.weight;
            ++response.active;
            response.force += p * point.weight;
            response.max_pressure  = std::max(response.max_pressure, p);
            response.max_violation = std::max(response.max_violation, std::abs(gap));
            const double k         = stiffness * point.weight;
            response.force_stiffness += k;
            // Moving the surface outwards by value[i] raises p by ε value[i].
            for (unsigned int i = 0; i < face.unknowns.size(); ++i)
              {
                residual[face.unknowns[i]] += p * point.weight * point.value[i];
                approach_derivative[face.unknowns[i]] += k * point.value[i];
              }
            add_stiffness(f, point.value, k);
          }
      }
    response.rounding = 4 * std::numeric_limits<double>::epsilon() * stiffness *
                        std::abs(approach) * std::sqrt(squared_weights);
    return response;
  }
} // namespace dpcontact

#endif
