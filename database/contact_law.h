// The normal contact of two like elastic-plastic spheres, for discrete-element codes. One header,
// C++17, nothing but the standard library: copy it away. From dpcontact, which computes the
// coefficients by finite elements; after J. Wang, Q. Li, C. Yang, Y. Huang, C. Zhou, Adv. Mater.
// Sci. Eng. 2018, doi 10.1155/2018/6783791 (equation numbers are theirs).
//
// BSD 3-Clause License. Copyright (c) 2026, The dpcontact authors. Redistribution and use in source
// and binary forms, with or without modification, are permitted provided that the following
// conditions are met: 1. Redistributions of source code must retain the above copyright notice,
// this list of conditions and the following disclaimer.
// 2. Redistributions in binary form must reproduce the above copyright notice, this list of
// conditions and the following disclaimer in the documentation and/or other materials provided with
// the distribution. 3. Neither the name of the copyright holder nor the names of its contributors
// may be used to endorse or promote products derived from this software without specific prior
// written permission. THIS SOFTWARE IS PROVIDED BY THE COPYRIGHT HOLDERS AND CONTRIBUTORS "AS IS"
// AND ANY EXPRESS OR IMPLIED WARRANTIES, INCLUDING, BUT NOT LIMITED TO, THE IMPLIED WARRANTIES OF
// MERCHANTABILITY AND FITNESS FOR A PARTICULAR PURPOSE ARE DISCLAIMED. IN NO EVENT SHALL THE
// COPYRIGHT HOLDER OR CONTRIBUTORS BE LIABLE FOR ANY DIRECT, INDIRECT, INCIDENTAL, SPECIAL,
// EXEMPLARY, OR CONSEQUENTIAL DAMAGES (INCLUDING, BUT NOT LIMITED TO, PROCUREMENT OF SUBSTITUTE
// GOODS OR SERVICES; LOSS OF USE, DATA, OR PROFITS; OR BUSINESS INTERRUPTION) HOWEVER CAUSED AND ON
// ANY THEORY OF LIABILITY, WHETHER IN CONTRACT, STRICT LIABILITY, OR TORT (INCLUDING NEGLIGENCE OR
// OTHERWISE) ARISING IN ANY WAY OUT OF THE USE OF THIS SOFTWARE, EVEN IF ADVISED OF THE POSSIBILITY
// OF SUCH DAMAGE.
#ifndef DPCONTACT_DATABASE_CONTACT_LAW_H
#define DPCONTACT_DATABASE_CONTACT_LAW_H

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <istream>
#include <limits>
#include <locale>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

namespace dpcontact
{
  // Any consistent units (SI: m, N, Pa). The overlap δ = R₁ + R₂ − distance is the mutual approach.
  // Radii enter by R* = R₁R₂/(R₁ + R₂) alone: F_y = π³P³R*²/(6E*²), δ_y = π²P²R*/(4E*²), E* =
  // E/(2(1−ν²)) of two like bodies. A rigid wall is the plane of symmetry: its force is that of
  // overlap 2δ and R* = R/2.

  /// All that a contact remembers, and all that a restart file must keep: the largest overlap so
  /// far, in the unit of the overlap. A new contact, or one whose bodies have met anew at other
  /// places, begins with 0. A value that is no number ≥ 0 (a damaged file) counts as 0.
  struct ContactState
  {
    double peak_overlap = 0;
  };

  /// Bits of ContactResponse::flags.
  enum ContactFlag : unsigned int
  {
    contact_pressed = 1, ///< the force is positive
    contact_loading = 2, ///< the overlap is its largest so far
    contact_yielded =
      4, ///< the largest overlap lies above the onset of yield: the law is no longer elastic
    contact_strain_large =
      8, ///< a/R > 0.1 at the largest overlap, R = 2R*: the small-strain law is left behind
    contact_extrapolated = 16, ///< the largest overlap lies beyond the universal table
    contact_input_invalid =
      32 ///< overlap (or R*) not finite, or R* not positive: force 0, the state is left alone
  };

  struct ContactResponse
  {
    double       force; ///< ≥ 0, repulsive
    unsigned int flags;
  };

  /// Perfectly plastic Drucker–Prager rock with associated flow.
  struct ContactMaterial
  {
    double youngs_modulus;       ///< E
    double poisson_ratio;        ///< ν
    double friction_angle_deg;   ///< φ
    double compressive_strength; ///< uniaxial σc
  };

  /// Where Hertz's solution first yields. Pressures in the unit of E.
  struct YieldScales
  {
    double pressure; ///< P: Hertz's peak pressure at first yield on the axis, eqs (8)–(11)
    double force;    ///< F_y/R*², eq (12)
    double approach; ///< δ_y/R*, eq (13)
    double
      onset_level; ///< F/F_y up to which nothing yields: 1, or where the ring r = a yields before
  };

  /// A row of coefficients: F/F_y = a (δ/δ_y)^b, unloading F/F_y = m ((δ − δ_res)/δ_y)^n, eqs (16),
  /// (17).
  struct ContactRow
  {
    double a, b, m, n;
    double force_yield; ///< F_y
    double
      approach_yield; ///< δ_y, mutual like δ (the consistent pair: a, m → 1 in the elastic limit)
    double effective_radius; ///< R* of the spheres that F_y and δ_y belong to: R/2 for two spheres
                             ///< of radius R

    /// From the published convention, whose δ_y is that of one sphere: a = a_published 2^b, m =
    /// m_published 2^n.
    static ContactRow published(const double a,
                                const double b,
                                const double m,
                                const double n,
                                const double force_yield,
                                const double approach_yield_of_one_sphere,
                                const double effective_radius)
    {
      return {a * std::exp2(b),
              b,
              m * std::exp2(n),
              n,
              force_yield,
              2 * approach_yield_of_one_sphere,
              effective_radius};
    }
  };

  namespace contact_law_detail
  {
    constexpr double pi = 3.14159265358979323846;

    inline void
    check(const bool holds, const std::string &what, const double value, const char *range)
    {
      if (holds)
        return;
      std::ostringstream message;
      message << "contact law: " << what << " is " << value << "; it must be " << range;
      throw std::runtime_error(message.str());
    }

    inline void check_positive(const char *what, const double value)
    {
      check(std::isfinite(value) && value > 0, what, value, "finite and positive");
    }

    inline double power(const double x, const double y) { return std::exp2(y * std::log2(x)); }

    inline double from_bits(const std::uint64_t bits)
    {
      double value;
      std::memcpy(&value, &bits, sizeof value);
      return value;
    }

    /// x^y of one y for many x > 0, without the latency of a logarithm: x = 2^e c (1 + r) with the
    /// nearest c = 1 + i/32, of which the powers stand in tables, and the binomial series of (1 +
    /// r)^y. Relative error below 2⁻⁵⁰ for y ≤ 3 and 2⁻⁶⁴ ≤ x < 2⁶⁴, elsewhere power()'s.
    class FixedPower
    {
    public:
      explicit FixedPower(const double exponent)
        : y(exponent)
        , in_table(exponent <= 3 ? 2 * octaves : 0)
      {
        if (in_table == 0)
          return;
        double binomial = 1;
        for (int k = 0; k < terms; ++k)
          series[k] = binomial *= (y - k) / (k + 1);
        for (int i = 0; i <= steps; ++i)
          {
            inverse[i]  = 1 / (1 + static_cast<double>(i) / steps);
            fraction[i] = std::pow(1 + static_cast<double>(i) / steps, y);
          }
        for (int e = 0; e < 2 * octaves; ++e)
          octave[e] = std::pow(std::exp2(e - octaves), y);
      }

      double operator()(const double x) const
      {
        constexpr std::uint64_t one = 0x3FF0000000000000u, part = 0x000FFFFFFFFFFFFFu;
        std::uint64_t           bits;
        std::memcpy(&bits, &x, sizeof bits);
        const std::uint64_t e = (bits >> 52) - (1023 - octaves);
        if (e >= in_table)
          return power(x, y);
        const std::uint64_t i = ((bits & part) + (std::uint64_t(1) << 46)) >> 47;
        const double r = (from_bits((bits & part) | one) - from_bits(one + (i << 47))) * inverse[i];
        const double r2  = r * r;
        const double sum = (series[0] + r * series[1] + r2 * (series[2] + r * series[3])) +
                           r2 * r2 * (series[4] + r * series[5] + r2 * series[6]);
        const double known = octave[e] * fraction[i];
        return known + known * (r * sum);
      }

    private:
      static constexpr int steps = 32, octaves = 64, terms = 7;

      double        y;
      std::uint64_t in_table;
      double        series[terms] = {}, inverse[steps + 1] = {}, fraction[steps + 1] = {},
             octave[2 * octaves] = {};
    };

    /// (√J₂ + α I₁)√3/P₀ on the axis at depth u a under Hertz's pressure, regrouped so that nothing
    /// cancels, with t = u atan(1/u), κ = 1 − √3 α: (3/2)(1/(1+u²) − 3(1−t)) + (3(½−ν) +
    /// 2κ(1+ν))(1−t). Deep down by its series.
    inline double axis_stress(const double nu, const double kappa, const double u)
    {
      const double x    = 1 / (u * u);
      double       fall = 0, excess = 0;
      if (x > 0.09)
        {
          fall   = 1 - u * std::atan(1 / u);
          excess = 1 / (1 + u * u) - 3 * fall;
        }
      else
        for (int k = 16; k >= 1; --k)
          {
            fall   = x * (1. / (2 * k + 1) - fall);
            excess = x * ((2. * k - 2) / (2 * k + 1) - excess);
          }
      return 1.5 * excess + (3 * (0.5 - nu) + 2 * kappa * (1 + nu)) * fall;
    }

    /// Derivative at x[i] of the polynomial through the points from first to last.
    inline double slope(const std::vector<double> &x,
                        const std::vector<double> &y,
                        const std::size_t          first,
                        const std::size_t          last,
                        const std::size_t          i)
    {
      double sum = 0;
      for (std::size_t k = first; k <= last; ++k)
        if (k != i)
          {
            double weight = 1 / (x[k] - x[i]);
            for (std::size_t j = first; j <= last; ++j)
              if (j != i && j != k)
                weight *= (x[i] - x[j]) / (x[k] - x[j]);
            sum += weight * (y[k] - y[i]);
          }
      return sum;
    }

    /// C¹ cubic through given points, with slopes of fourth order that are bounded (Hyman) so that
    /// the curve is monotone wherever its points are. It starts with slope 0 and goes on beyond its
    /// last point as a straight line.
    class Cubic
    {
    public:
      Cubic(const std::vector<double> &x_, std::vector<double> y_)
        : x(x_)
        , y(std::move(y_))
        , d(x.size(), 0.)
      {
        const std::size_t n = x.size();
        for (std::size_t i = 1; i < n; ++i)
          {
            const std::size_t first = std::min(i < 2 ? 0 : i - 2, n < 5 ? 0 : n - 5);
            d[i]                    = slope(x, y, first, std::min(first + 4, n - 1), i);
            const double left       = (y[i] - y[i - 1]) / (x[i] - x[i - 1]);
            const double right      = i + 1 < n ? (y[i + 1] - y[i]) / (x[i + 1] - x[i]) : left;
            const double bound =
              left * right > 0 ? 3 * std::min(std::abs(left), std::abs(right)) : 0;
            d[i] = left > 0 ? std::clamp(d[i], 0., bound) : std::clamp(d[i], -bound, 0.);
          }
      }

      /// Value and slope at or above the first point.
      std::pair<double, double> operator()(const double at) const
      {
        if (at >= x.back())
          return {y.back() + d.back() * (at - x.back()), d.back()};
        const auto i =
          static_cast<std::size_t>(std::upper_bound(x.begin() + 1, x.end(), at) - x.begin()) - 1;
        const double h = x[i + 1] - x[i], t = (at - x[i]) / h, mean = (y[i + 1] - y[i]) / h;
        const double c2 = 3 * mean - 2 * d[i] - d[i + 1], c3 = d[i] + d[i + 1] - 2 * mean;
        return {y[i] + h * t * (d[i] + t * (c2 + t * c3)), d[i] + t * (2 * c2 + t * 3 * c3)};
      }

    private:
      std::vector<double> x, y, d;
    };

    /// Lagrange's weights at `at` of `count` nodes of an axis.
    inline std::vector<double> lagrange(const std::vector<double> &axis,
                                        const std::size_t          first,
                                        const std::size_t          count,
                                        const double               at)
    {
      std::vector<double> result(count, 1.);
      for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < count; ++k)
          if (k != i)
            result[i] *= (at - axis[first + k]) / (axis[first + i] - axis[first + k]);
      return result;
    }

    /// At `at` the C² cubic spline through all points; end slopes of the polynomials through five.
    inline double
    spline(const std::vector<double> &x, const std::vector<double> &y, const double at)
    {
      const std::size_t   n = x.size(), near = std::min<std::size_t>(n, 5) - 1;
      const auto          h    = [&](const std::size_t i) { return x[i + 1] - x[i]; };
      const auto          mean = [&](const std::size_t i) { return (y[i + 1] - y[i]) / h(i); };
      std::vector<double> upper(n, 0.), d(n, slope(x, y, 0, near, 0));
      for (std::size_t i = 1; i + 1 < n; ++i) // Thomas' elimination for the slopes
        {
          const double q = h(i) / h(i - 1), pivot = 2 + 2 * q - q * upper[i - 1];
          upper[i] = 1 / pivot;
          d[i]     = (3 * (q * mean(i - 1) + mean(i)) - q * d[i - 1]) / pivot;
        }
      d[n - 1] = slope(x, y, n - 1 - near, n - 1, n - 1);
      for (std::size_t i = n - 1; i-- > 1;)
        d[i] -= upper[i] * d[i + 1];
      const auto i =
        static_cast<std::size_t>(std::upper_bound(x.begin() + 1, x.end() - 1, at) - x.begin()) - 1;
      const double t = (at - x[i]) / h(i), c2 = 3 * mean(i) - 2 * d[i] - d[i + 1];
      return y[i] + h(i) * t * (d[i] + t * (c2 + t * (d[i] + d[i + 1] - 2 * mean(i))));
    }

    /// Weights of an axis' nodes at `at`: of the polynomial through all where it does not swing
    /// (its Lebesgue constant is below 3: up to five nodes, or Chebyshev–Lobatto points), otherwise
    /// of the cubic spline. Exact at the nodes, and beyond the ends what stands there goes on.
    inline std::vector<double> weights(const std::vector<double> &axis, const double at)
    {
      const std::size_t n       = axis.size();
      double            largest = 0;
      for (std::size_t i = 0; i + 1 < n; ++i)
        for (double t = 0.1; t < 1; t += 0.1)
          {
            double sum = 0;
            for (const double w : lagrange(axis, 0, n, axis[i] + t * (axis[i + 1] - axis[i])))
              sum += std::abs(w);
            largest = std::max(largest, sum);
          }
      if (largest < 3 || n <= 4)
        return lagrange(axis, 0, n, at);
      std::vector<double> result(n), unit(n, 0.);
      for (std::size_t i = 0; i < n; ++i)
        {
          unit[i]   = 1;
          result[i] = spline(axis, unit, at);
          unit[i]   = 0;
        }
      return result;
    }

    inline void check_within(const std::vector<double> &axis, const double at, const char *name)
    {
      std::ostringstream range;
      range << "within the universal table, from " << axis.front() << " to " << axis.back();
      check(at >= axis.front() && at <= axis.back(), name, at, range.str().c_str());
    }
  } // namespace contact_law_detail

  /// First yield of two like spheres. @throws std::runtime_error naming what is out of range.
  inline YieldScales yield_scales(const ContactMaterial &material)
  {
    using namespace contact_law_detail;
    const double nu = material.poisson_ratio, phi = material.friction_angle_deg;
    check_positive("Young's modulus", material.youngs_modulus);
    check_positive("compressive strength", material.compressive_strength);
    check(nu >= 0 && nu < 0.5, "Poisson's ratio", nu, "at least 0 and below 0.5");
    check(phi >= 0 && phi < 90, "friction angle", phi, "at least 0 and below 90 degrees");
    const double sine = std::sin(phi * pi / 180), kappa = 1 - 2 * sine / (3 - sine);
    // One maximum over ln u: golden section, down to what a maximum can tell about its place.
    const double golden = (std::sqrt(5.) - 1) / 2;
    double       low = std::log(0.1), high = std::log(1e10);
    const auto value = [&](const double log_u) { return axis_stress(nu, kappa, std::exp(log_u)); };
    for (int k = 0; k < 60; ++k)
      {
        const double width = golden * (high - low);
        (value(high - width) > value(low + width) ? high : low) =
          value(high - width) > value(low + width) ? low + width : high - width;
      }
    const double root3_k = material.compressive_strength * kappa; // √3 k, eq (11)
    const double E       = material.youngs_modulus / (2 * (1 - nu * nu));
    YieldScales  scales{};
    scales.pressure    = root3_k / value((low + high) / 2);
    const double ratio = pi * scales.pressure / (2 * E); // a/R* at first yield
    scales.approach    = ratio * ratio;
    scales.force       = 2. / 3. * pi * ratio * ratio * scales.pressure;
    const double ring =
      std::sqrt(3.) * root3_k / (1 - 2 * nu) / scales.pressure; // P₀ of the ring: 3k/(1 − 2ν)
    scales.onset_level = ring < 1 ? ring * ring * ring : 1;
    return scales;
  }

  /// The universal table: what finite elements give over (ν, φ, Λ = F/F_y), for every radius,
  /// stiffness and strength.
  struct ContactTable
  {
    std::vector<double> nu, phi, load_level; ///< ascending; φ in degrees, Λ
    /// Over (ν, φ, Λ), Λ fastest: δ/δ_y when F first reaches Λ F_y; δ_res/δ_y after release from
    /// there; m and n, eq (17), of a branch that goes through the peak.
    std::vector<double> approach, residual, m, n;

    std::size_t index(const std::size_t i, const std::size_t k, const std::size_t l) const
    {
      return (i * phi.size() + k) * load_level.size() + l;
    }

    /// Reads CSV with the columns nu, phi_deg, load_level, approach, residual_approach, m_law,
    /// n_law in any order, others ignored; lines that begin with '#' are comments. Every (ν, φ) has
    /// every Λ, once.
    /// @throws std::runtime_error saying what is wrong and in which line.
    static ContactTable read(std::istream &stream)
    {
      const std::vector<std::string> names{
        "nu", "phi_deg", "load_level", "approach", "residual_approach", "m_law", "n_law"};
      std::map<std::tuple<double, double, double>, std::vector<double>> rows;
      std::vector<std::size_t>                                          column;
      std::size_t                                                       line_number = 0;
      const auto fail = [&](const std::string &what) {
        throw std::runtime_error("universal table, line " + std::to_string(line_number) + ": " +
                                 what);
      };
      for (std::string line; std::getline(stream, line);)
        {
          ++line_number;
          if (!line.empty() && line.back() == '\r')
            line.pop_back();
          if (line.empty() || line.front() == '#')
            continue;
          std::vector<std::string> cells;
          std::istringstream       parts(line);
          for (std::string cell; std::getline(parts, cell, ',');)
            cells.push_back(cell);
          if (column.empty())
            {
              for (const std::string &name : names)
                {
                  const auto found = std::find(cells.begin(), cells.end(), name);
                  if (found == cells.end())
                    fail("the header lacks the column '" + name + "'");
                  column.push_back(static_cast<std::size_t>(found - cells.begin()));
                }
              continue;
            }
          std::vector<double> row;
          for (std::size_t c = 0; c < names.size(); ++c)
            {
              std::istringstream cell(column[c] < cells.size() ? cells[column[c]] : "");
              cell.imbue(std::locale::classic());
              double value = 0;
              if (!(cell >> value) || !(cell >> std::ws).eof() || !std::isfinite(value))
                fail("'" + cell.str() + "' is no value of " + names[c]);
              row.push_back(value);
            }
          if (row[0] < 0 || row[0] >= 0.5 || row[1] < 0 || row[1] >= 90 || !(row[2] > 0))
            fail("nu, phi_deg or load_level is out of range");
          if (!(row[3] > 0) || !(std::abs(row[4]) < row[3]) || row[4] < -1e-3 * row[3] ||
              !(row[5] > 0) || !(row[6] > 0))
            fail("approach, m_law and n_law must be positive, residual_approach from 0 (but for "
                 "rounding) to below approach");
          if (!rows.emplace(std::tuple(row[0], row[1], row[2]), row).second)
            fail("this nu, phi_deg and load_level stand there twice");
        }

      ContactTable table;
      const auto   collect = [&](std::vector<double> &axis, const std::size_t c) {
        for (const auto &row : rows)
          axis.push_back(row.second[c]);
        std::sort(axis.begin(), axis.end());
        axis.erase(std::unique(axis.begin(), axis.end()), axis.end());
      };
      collect(table.nu, 0);
      collect(table.phi, 1);
      collect(table.load_level, 2);
      if (table.load_level.size() < 5)
        fail("fewer than 5 load levels");
      const auto node = [](const std::vector<double> &row) {
        std::ostringstream text;
        text << "nu " << row[0] << ", phi_deg " << row[1] << ", load_level " << row[2];
        return text.str();
      };
      for (const double i : table.nu)
        for (const double k : table.phi)
          for (const double l : table.load_level)
            {
              const auto found = rows.find({i, k, l});
              if (found == rows.end())
                fail("there is no row for " + node({i, k, l}));
              const std::vector<double> &row = found->second;
              if (l != table.load_level.front() && row[3] <= table.approach.back())
                fail("the approach does not increase at " + node(row));
              table.approach.push_back(row[3]);
              table.residual.push_back(row[4]);
              table.m.push_back(row[5]);
              table.n.push_back(row[6]);
            }
      return table;
    }
  };

  /// The law at one peak overlap.
  struct ContactCoefficients
  {
    double force;    ///< F_p: the loading force at the peak
    double residual; ///< δ_res, where unloading ends: eq (18) of δ_p, F_p, m, n
    double m, n; ///< of eq (17); below the onset of yield 1 and 1.5 (universal) or a and b (row)
  };

  class ContactPair;

  /// Force of a contact over its history of overlaps: along the loading curve L(δ) while δ ≥ δ_p,
  /// its largest value so far; below δ_p, down and up again, along U(δ; δ_p) = F_p ((δ −
  /// δ_res)/(δ_p − δ_res))^n, F_p = L(δ_p), which is eq (17) with eq (18)'s δ_res; 0 below δ_res.
  /// Up to the onset of yield δ_res = 0 and U = L.
  ///
  /// No energy is created. At a given peak the force is a function of δ, so motion below it gives
  /// back what it takes. Where U does not increase with δ_p at any δ, a cycle that raises the peak
  /// ends on a lower branch than the one it began on, and L, the envelope of the branches, is above
  /// both: it takes work. With w = δ_p − δ_res and ' = d/dδ_p
  ///   ∂ ln U/∂δ_p = F_p'/F_p + n' ln z − (n/w)(1 − δ_res' + δ_res'/z),   z = (δ − δ_res)/w in (0,
  ///   1],
  /// which is negative for all z where (1) δ_res' ≥ 0, (2) n F_p/w ≥ F_p', unloading is steeper
  /// than loading, and (3) n δ_res' ≥ −w n': by (1) and (3) it increases with z, and (2) is its
  /// value at z = 1. The constructors raise δ_res where a row or a table violates one of the three
  /// by rounding or noise.
  class ContactLaw
  {
  public:
    /// Coefficients that stay what they are, whatever the peak. Reversible up to δ_y; beyond, eqs
    /// (16)–(18).
    /// @throws std::runtime_error naming what is not positive.
    static ContactLaw from_row(const ContactRow &row)
    {
      using contact_law_detail::check_positive;
      check_positive("a", row.a);
      check_positive("b", row.b);
      check_positive("m", row.m);
      check_positive("n", row.n);
      check_positive("the yield force F_y", row.force_yield);
      check_positive("the yield approach delta_y", row.approach_yield);
      check_positive("the effective radius R*", row.effective_radius);
      ContactLaw law;
      law.a         = row.a;
      law.b         = row.b;
      law.m         = row.m;
      law.n         = row.n;
      law.steepness = std::min(1., row.n / row.b);
      law.width     = std::pow(row.a / row.m, 1 / row.n);
      const auto powers =
        std::make_shared<Powers>(Powers{contact_law_detail::FixedPower(row.b),
                                        contact_law_detail::FixedPower(row.b / row.n),
                                        contact_law_detail::FixedPower(row.n)});
      law.powers     = powers.get();
      law.owner      = powers;
      law.approach_y = law.approach_1 = row.approach_yield / row.effective_radius;
      law.force_y = law.force_1 = row.force_yield / row.effective_radius / row.effective_radius;
      law.find_strain_limit();
      return law;
    }

    /// One loading curve for every peak, and m and n as functions of the contact's own peak.
    /// Interpolates the table in (ν, φ), smoothly, once.
    /// @throws std::runtime_error naming what is out of range.
    static ContactLaw universal(const ContactMaterial &material, const ContactTable &table)
    {
      using namespace contact_law_detail;
      const YieldScales scales = yield_scales(material);
      const double      onset  = std::log(scales.onset_level);
      check_within(table.nu, material.poisson_ratio, "Poisson's ratio");
      check_within(table.phi, material.friction_angle_deg, "friction angle");
      const std::vector<double> in_i = weights(table.nu, material.poisson_ratio);
      const std::vector<double> in_k = weights(table.phi, material.friction_angle_deg);

      // Over ln Λ: ln of δ and of w = δ_p − δ_res over Hertz's approach, and n; at the onset 0,
      // 0, 1.5.
      std::vector<double> level{onset}, approach{0.}, width{0.}, exponent{1.5};
      for (std::size_t l = 0; l < table.load_level.size(); ++l)
        {
          const double at = std::log(table.load_level[l]);
          if (at < onset + 0.02) // elastic, or indistinguishable from it
            continue;
          double x = 0, w = 0, n = 0;
          for (std::size_t i = 0; i < in_i.size(); ++i)
            for (std::size_t k = 0; k < in_k.size(); ++k)
              {
                const std::size_t at_node = table.index(i, k, l);
                const double      weight  = in_i[i] * in_k[k];
                x += weight * (std::log(table.approach[at_node]) - 2. / 3. * at);
                w += weight * ((at - std::log(table.m[at_node])) / table.n[at_node] - 2. / 3. * at);
                n += weight * table.n[at_node];
              }
          level.push_back(at);
          approach.push_back(x);
          width.push_back(w);
          exponent.push_back(n);
        }
      check(level.size() > 1,
            "the universal table's highest load level",
            table.load_level.back(),
            "plastic");
      const Cubic x_of(level, approach), w_of(level, width), n_of(level, exponent);

      ContactLaw law;
      law.is_universal = true;
      law.force_y      = scales.force;
      law.approach_y   = scales.approach;
      law.force_1      = scales.force * scales.onset_level;
      law.approach_1   = scales.approach * std::exp(2. / 3. * onset);
      law.table_end    = std::exp(2. / 3. * (level.back() - onset) + approach.back());

      const auto bins  = std::make_shared<std::vector<Bin>>();
      double     log_f = 0; // ln F at ξ, both over their values at the onset
      double     xi = 1, f = 1, slope = 1.5, n = 1.5, r = 0;
      while (xi < law.table_end)
        {
          const double step = std::exp2(std::floor(std::log2(xi) + 1e-9)) / bins_per_octave;
          const double next = xi + step;
          for (int k = 0; k < 60; ++k) // Newton on ln ξ = 2/3 ln F + x(ln F)
            {
              const auto [x, dx]  = x_of(onset + log_f);
              const double change = (std::log(next) - 2. / 3. * log_f - x) / (2. / 3. + dx);
              log_f += change;
              if (std::abs(change) < 1e-14)
                break;
            }
          const double next_f     = std::exp(log_f);
          const double next_slope = 1 / (2. / 3. + x_of(onset + log_f).second);
          const double next_n     = n_of(onset + log_f).first;
          const double d0 = step * slope * f / xi, d1 = step * next_slope * next_f / next;
          Bin          bin{
            f, d0, 3 * (next_f - f) - 2 * d0 - d1, d0 + d1 - 2 * (next_f - f), n, next_n - n, r, 0};
          double next_r =
            next * (1 - std::exp(w_of(onset + log_f).first - x_of(onset + log_f).first));
          next_r = std::max(next_r, r); // (1)
          if (next_n < n)               // (3)
            next_r = std::max(next_r, r + (n - next_n) / next_n * std::max(xi - r, next - r));
          for (double t = 0.125; t <= 1; t += 0.125) // (2), also between the ends of the bin
            {
              const double rise  = (bin.f1 + t * (2 * bin.f2 + t * 3 * bin.f3)) / step;
              const double least = xi + t * step - (n + t * bin.n1) * force_at(bin, t) / rise;
              next_r             = std::max(next_r, r + (least - r) / t);
            }
          check(next_slope > 0 && next_slope < 3,
                "the slope of ln F over ln delta in the universal table",
                next_slope,
                "between 0 and 3");
          check(next_r < next,
                "delta_res over delta after the fall of n in the universal table",
                next_r / next,
                "below 1");
          bin.r1 = next_r - r;
          bins->push_back(bin);
          std::tie(xi, f, slope, n, r) = std::tuple(next, next_f, next_slope, next_n, next_r);
        }
      law.end   = {xi, f, slope, n, r / xi};
      law.bins  = bins->data();
      law.owner = bins;
      law.find_strain_limit();
      return law;
    }

    /// R* of two radii.
    static double effective_radius(const double radius_1, const double radius_2)
    {
      return radius_1 * radius_2 / (radius_1 + radius_2);
    }

    /// The contact of two bodies of this R*, all scales computed once.
    ContactPair pair(double effective_radius) const;

    /// Force of any contact of this material; a division dearer than ContactPair::evaluate.
    /// Allocates nothing, never throws.
    ContactResponse evaluate(const double  overlap,
                             const double  effective_radius,
                             ContactState &state) const noexcept
    {
      if (!(std::isgreater(effective_radius, 0) && std::isless(effective_radius, largest)))
        return {0, contact_input_invalid};
      return evaluate(overlap,
                      1 / (approach_1 * effective_radius),
                      force_1 * effective_radius * effective_radius,
                      state);
    }

    /// F_y and δ_y for this R*.
    double force_yield(const double effective_radius) const
    {
      return force_y * effective_radius * effective_radius;
    }
    double approach_yield(const double effective_radius) const
    {
      return approach_y * effective_radius;
    }

    ContactCoefficients coefficients(const double peak_overlap, const double effective_radius) const
    {
      const double xi = std::max(peak_overlap / (approach_1 * effective_radius), 0.);
      const Branch at = branch(xi);
      if (xi <= 1)
        return {at.force * force_1 * effective_radius * effective_radius, 0, a, at.exponent};
      const double w = (xi - at.residual) * approach_1 / approach_y;
      return {at.force * force_1 * effective_radius * effective_radius,
              at.residual * approach_1 * effective_radius,
              at.force * force_1 / force_y / std::pow(w, at.exponent),
              at.exponent};
    }

    /// dF/dδ where unloading from this peak begins: the stiffest that a contact is, which limits
    /// the time step, and 2E*a of its contact radius a.
    double stiffness(const double peak_overlap, const double effective_radius) const
    {
      return stiffness(peak_overlap / (approach_1 * effective_radius)) * force_1 / approach_1 *
             effective_radius;
    }

    /// Contact radius over 2R* at this peak, from the stiffness: exact in small strain, for the
    /// law's own stiffness.
    double strain_measure(const double peak_overlap, const double effective_radius) const
    {
      return strain_measure(peak_overlap / (approach_1 * effective_radius));
    }

  private:
    friend class ContactPair;
    static constexpr double       largest         = 1e100; // ξ or R* beyond it are none
    static constexpr std::int64_t bins_per_octave = 16;
    static_assert(std::numeric_limits<double>::is_iec559,
                  "the bins are found by the bits of IEEE doubles");

    /// At one ξ = δ_p over its value at the onset of yield (universal) or δ_y (row): all in that
    /// unit and its force.
    struct Branch
    {
      double force, residual, exponent;
    };

    /// A sixteenth of an octave of ξ: the loading force as a cubic, and the unloading branch of a
    /// peak there.
    struct alignas(64) Bin
    {
      double f0, f1, f2, f3, n0, n1, r0, r1;
    };

    /// Of a row: ξ^b, ξ^(b/n), ξ^n.
    struct Powers
    {
      contact_law_detail::FixedPower loading, width, unloading;
    };

    /// The bin that ξ ≥ 1 lies in, and how far, from 0 to 1.
    static std::pair<std::int64_t, double> place(const double xi)
    {
      std::uint64_t bits;
      std::memcpy(&bits, &xi, sizeof bits);
      constexpr std::uint64_t one = 0x3FF0000000000000u, part = 0x0000FFFFFFFFFFFFu;
      return {static_cast<std::int64_t>((bits >> 48) - (one >> 48)),
              contact_law_detail::from_bits((bits & part) << 4 | one) - 1};
    }

    static double force_at(const Bin &bin, const double t)
    {
      return bin.f0 + t * (bin.f1 + t * (bin.f2 + t * bin.f3));
    }

    double loading(const double xi) const
    {
      if (!is_universal)
        return a * powers->loading(xi);
      if (xi <= 1)
        return xi * std::sqrt(xi);
      if (xi >= end.xi)
        return end.force * std::pow(xi / end.xi, end.slope);
      const auto [i, t] = place(xi);
      return force_at(bins[i], t);
    }

    Branch branch(const double xi) const
    {
      if (xi <= 1)
        return {xi > 0 ? loading(xi) : 0, 0, is_universal ? 1.5 : b};
      if (!is_universal)
        return {loading(xi), xi - std::min(width * powers->width(xi), xi * steepness), n};
      if (xi >= end.xi)
        return {loading(xi), end.residual * xi, end.exponent};
      const auto [i, t] = place(xi);
      const Bin &bin    = bins[i];
      return {force_at(bin, t), bin.r0 + t * bin.r1, bin.n0 + t * bin.n1};
    }

    double unloading(const double xi, const double peak) const
    {
      if (peak <= 1)
        return loading(xi);
      if (!is_universal)
        {
          // Without a clamp F_p need not be known.
          const double w = width * powers->width(peak), least = xi - peak;
          if (w <= peak * steepness)
            return w + least > 0 ? m * powers->unloading(w + least) : 0;
        }
      const Branch at = branch(peak);
      const double z  = (xi - at.residual) / (peak - at.residual);
      return z > 0 ? at.force * contact_law_detail::power(z, at.exponent) : 0;
    }

    double stiffness(const double xi) const
    {
      const Branch at = branch(xi);
      return xi > 0 ? at.exponent * at.force / (xi - at.residual) : 0;
    }

    /// a/(2R*): Hertz's (1/2)√(δ_y/R*) at F_y, and a ∝ stiffness.
    double strain_measure(const double xi) const
    {
      return std::sqrt(approach_y) / 3 * stiffness(xi) * (force_1 / force_y) /
             (approach_1 / approach_y);
    }

    void find_strain_limit()
    {
      double low = -230, high = 230; // ln ξ
      for (int k = 0; k < 60; ++k)
        (strain_measure(std::exp((low + high) / 2)) > 0.1 ? high : low) = (low + high) / 2;
      strain_limit = std::exp(high);
    }

    ContactResponse evaluate(const double  overlap,
                             const double  per_approach,
                             const double  force_unit,
                             ContactState &state) const noexcept
    {
      const double xi = overlap * per_approach;
      if (!std::isless(std::abs(xi), largest)) // NaN as well; raises no floating-point exception
        return {0, contact_input_invalid};
      double peak = state.peak_overlap * per_approach;
      if (!(std::isgreater(peak, 0) && std::isless(peak, largest)))
        peak = state.peak_overlap = 0;
      double       force = 0;
      unsigned int flags = 0;
      // Not of ξ, for which a processor would wait before it knows the branch.
      if (overlap >= state.peak_overlap && overlap > 0)
        {
          peak               = xi;
          state.peak_overlap = overlap;
          force              = loading(xi);
          flags              = contact_loading;
        }
      else if (xi > 0)
        force = unloading(xi, peak);
      flags |= (force > 0 ? contact_pressed : 0u) | (peak > 1 ? contact_yielded : 0u) |
               (peak > strain_limit ? contact_strain_large : 0u) |
               (peak > table_end ? contact_extrapolated : 0u);
      return {force * force_unit, flags};
    }

    struct End
    {
      double xi, force, slope, exponent, residual; // residual over ξ
    };

    bool          is_universal = false;
    const Bin    *bins         = nullptr;         // of a universal law
    const Powers *powers       = nullptr;         // of a row
    double        a = 1, b = 1.5, m = 1, n = 1.5; // of a row
    double        width = 1, steepness = 1;       // (a/m)^(1/n), min(1, n/b)
    End           end{};
    double        strain_limit = 0, table_end = std::numeric_limits<double>::infinity();
    double        force_1 = 0, approach_1 = 0; // units of F and ξ, for R* = 1
    double        force_y = 0, approach_y = 0; // F_y and δ_y for R* = 1

    std::shared_ptr<const void> owner; // of the bins or powers
  };

  /// A law with one R*.
  class ContactPair
  {
  public:
    ContactPair(const ContactLaw &law_, const double effective_radius_)
      : law(law_)
      , radius(effective_radius_)
    {
      contact_law_detail::check_positive("the effective radius R*", radius);
      per_approach = 1 / (law.approach_1 * radius);
      force_unit   = law.force_1 * radius * radius;
    }

    /// Force at this overlap, which follows those before. Allocates nothing, never throws.
    ContactResponse evaluate(const double overlap, ContactState &state) const noexcept
    {
      return law.evaluate(overlap, per_approach, force_unit, state);
    }

    double              force_yield() const { return law.force_yield(radius); }
    double              approach_yield() const { return law.approach_yield(radius); }
    ContactCoefficients coefficients(const double peak) const
    {
      return law.coefficients(peak, radius);
    }
    double stiffness(const double peak) const { return law.stiffness(peak, radius); }

  private:
    ContactLaw law;
    double     radius, per_approach, force_unit;
  };

  inline ContactPair ContactLaw::pair(const double effective_radius) const
  {
    return {*this, effective_radius};
  }
} // namespace dpcontact

#endif
