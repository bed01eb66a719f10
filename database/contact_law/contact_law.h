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
#ifndef DPCONTACT_DATABASE_CONTACT_LAW_CONTACT_LAW_H
#define DPCONTACT_DATABASE_CONTACT_LAW_CONTACT_LAW_H

#include <algorithm>
#include <array>
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
#include <utility>
#include <variant>
#include <vector>

namespace dpcontact
{
  // All quantities are in one consistent system of units (SI: m, N, Pa).
  //
  // The overlap δ = R₁ + R₂ − distance of two spheres, as discrete-element codes call it, is their
  // mutual approach, as mechanics calls it: the two words mean the same length. This header says
  // overlap; a public name or a column of the table that says approach (approach_yield) means it
  // too. Forces are positive where they repel.
  //
  // Radii enter by R* = R₁R₂/(R₁ + R₂) alone. First yield is at the force F_y = π³P³R*²/(6E*²) and
  // the overlap δ_y = π²P²R*/(4E*²), with E* = E/(2(1−ν²)) of two like bodies and Hertz's peak
  // pressure P. A rigid wall is the plane of symmetry of two like spheres: its force is that of the
  // overlap 2δ and of R* = R/2.

  /// All that a contact remembers, and all that a restart file must keep. A new contact, or one
  /// whose bodies have met anew at other places, begins with 0.
  struct ContactState
  {
    double peak_overlap = 0; ///< the largest overlap so far; what is no number ≥ 0 counts as 0
  };

  /// Bits of ContactResponse::flags.
  enum ContactFlag : unsigned int
  {
    contact_pressed = 1, ///< the force is positive
    contact_loading = 2, ///< the overlap is its largest so far
    /// The largest overlap lies above the onset of yield, where the law is no longer elastic.
    contact_yielded = 4,
    /// The contact radius a is above R/10 at the largest overlap, with R = 2R*: small strain, which
    /// the law assumes, is left behind.
    contact_strain_large = 8,
    contact_extrapolated = 16, ///< the largest overlap lies beyond the universal table
    /// The overlap or R* is not finite, or R* is not positive: the force is 0 and the state is left
    /// as it was.
    contact_input_invalid = 32
  };

  /// What a contact does at one overlap.
  struct ContactResponse
  {
    double       force; ///< at least 0: it repels
    unsigned int flags; ///< of ContactFlag
  };

  /// Perfectly plastic Drucker–Prager rock with associated flow.
  struct ContactMaterial
  {
    double youngs_modulus;       ///< E
    double poisson_ratio;        ///< ν, at least 0 and below 0.5
    double friction_angle_deg;   ///< φ in degrees, at least 0 and below 90
    double compressive_strength; ///< uniaxial σc, in the unit of E
  };

  /// Where Hertz's solution first yields.
  struct YieldScales
  {
    double pressure; ///< P: Hertz's peak pressure at first yield on the axis, eqs (8)–(11)
    double force;    ///< F_y/R*², eq (12)
    double approach; ///< δ_y/R*, eq (13)
    /// F/F_y up to which nothing yields: 1, or less where the ring r = a yields before the axis.
    double onset_level;
  };

  /// A row of coefficients: loading F/F_y = a (δ/δ_y)^b, eq (16), and unloading F/F_y = m ((δ −
  /// δ_res)/δ_y)^n, eq (17).
  struct ContactRow
  {
    double a, b, m, n;
    double force_yield; ///< F_y
    /// δ_y, mutual like δ. With this pair, which is the consistent one, a and m tend to 1 in the
    /// elastic limit.
    double approach_yield;
    /// R* of the spheres that F_y and δ_y belong to: R/2 for two spheres of radius R.
    double effective_radius;

    /// The row of a row in the published convention, whose δ_y is that of one sphere, half the
    /// mutual one: a = a_published 2^b and m = m_published 2^n.
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

    /// @throws std::runtime_error unless `holds`, with what it is, its value and its range.
    inline void
    check(const bool holds, const std::string &what, const double value, const char *range)
    {
      if (holds)
        return;
      std::ostringstream message;
      message << "contact law: " << what << " is " << value << "; it must be " << range;
      throw std::runtime_error(message.str());
    }

    // What is asked of numbers that may be NaN or infinite is asked of their bits: DEM codes are
    // compiled with -ffast-math, for which there are no such numbers.

    inline std::uint64_t bits_of(const double value)
    {
      std::uint64_t bits;
      std::memcpy(&bits, &value, sizeof bits);
      return bits;
    }

    /// |value| < limit, a finite positive number; false of NaN.
    inline bool is_below(const double value, const double limit)
    {
      return (bits_of(value) & 0x7FFFFFFFFFFFFFFFu) < bits_of(limit);
    }

    inline bool is_finite(const double value)
    {
      return (bits_of(value) & 0x7FF0000000000000u) != 0x7FF0000000000000u;
    }

    /// Finite and greater than 0.
    inline bool is_positive(const double value)
    {
      return is_finite(value) && bits_of(value) - 1 < 0x7FFFFFFFFFFFFFFFu;
    }

    inline void check_positive(const char *what, const double value)
    {
      check(is_positive(value), what, value, "finite and positive");
    }

    /// x^y for x > 0.
    inline double power(const double x, const double y) { return std::exp2(y * std::log2(x)); }

    /// The double of these bits.
    inline double from_bits(const std::uint64_t bits)
    {
      double value;
      std::memcpy(&value, &bits, sizeof value);
      return value;
    }

    /// x^y of one y for many x > 0, without the latency of a logarithm: x = 2^e c (1 + r) with the
    /// nearest c = 1 + i/32. The powers of 2^e and of c stand in tables, and (1 + r)^y is its
    /// binomial series. The relative error is below 2⁻⁵⁰ for y ≤ 3 and 2⁻⁶⁴ ≤ x < 2⁶⁴; elsewhere
    /// the result is that of power().
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

    /// (√J₂ + α I₁)√3/P₀ on the axis at the depth u a under Hertz's pressure of peak P₀. It is
    /// regrouped so that nothing cancels, with t = u atan(1/u) and κ = 1 − √3 α: (3/2)(1/(1+u²) −
    /// 3(1−t)) + (3(½−ν) + 2κ(1+ν))(1−t). Deep down, for u² > 1/0.09, its series is summed.
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

    /// The derivative at x[i] of the polynomial through the points from `first` to `last`, both
    /// included.
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

    /// The C¹ piecewise cubic through given points. Its slopes are of fourth order and bounded
    /// (Hyman) so that the curve is monotone wherever its points are. It starts with the slope 0
    /// and goes on beyond its last point as a straight line.
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

      /// Value and slope at a place that is not below the first point.
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

    /// Lagrange's weights, for the value at `at`, of the `count` nodes of an axis from `first` on.
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

    /// The value at `at` of the C² cubic spline through all points. The slope at each end is that
    /// of the polynomial through the five points next to it.
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

    /// The weights of an axis' nodes in the interpolated value at `at`. They are those of the
    /// polynomial through all nodes where it does not swing (its Lebesgue constant is below 3, as
    /// for up to five nodes or Chebyshev–Lobatto points), otherwise those of the cubic spline. Both
    /// are exact at the nodes, and beyond an end the piece that stands there goes on.
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

    /// @throws std::runtime_error unless the axis of the universal table holds `at`.
    inline void check_within(const std::vector<double> &axis, const double at, const char *name)
    {
      std::ostringstream range;
      range << "within the universal table, from " << axis.front() << " to " << axis.back();
      check(at >= axis.front() && at <= axis.back(), name, at, range.str().c_str());
    }
  } // namespace contact_law_detail

  /// First yield of two like spheres: the strongest stress on the axis reaches the yield surface.
  /// @throws std::runtime_error naming what is out of range.
  inline YieldScales yield_scales(const ContactMaterial &material)
  {
    using namespace contact_law_detail;
    const double nu = material.poisson_ratio, phi = material.friction_angle_deg;
    check_positive("Young's modulus", material.youngs_modulus);
    check_positive("compressive strength", material.compressive_strength);
    check(is_finite(nu) && nu >= 0 && nu < 0.5, "Poisson's ratio", nu, "at least 0 and below 0.5");
    check(is_finite(phi) && phi >= 0 && phi < 90,
          "friction angle",
          phi,
          "at least 0 and below 90 degrees");
    const double sine = std::sin(phi * pi / 180), kappa = 1 - 2 * sine / (3 - sine);
    // The stress has one maximum over ln u. Golden section finds it, as closely as a maximum tells
    // where it is.
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

  /// The universal table: what finite elements give over ν, φ and the load level Λ = F/F_y. It
  /// holds for every radius, stiffness and strength.
  struct ContactTable
  {
    std::vector<double> nu, phi, load_level; ///< the axes, ascending; φ in degrees

    // Over (ν, φ, Λ), Λ fastest.
    std::vector<double> approach; ///< δ/δ_y when F first reaches Λ F_y
    std::vector<double> residual; ///< δ_res/δ_y after release from there
    std::vector<double> m, n;     ///< eq (17), of an unloading branch that goes through the peak

    /// Where the values of node (i, k, l) of the axes stand.
    std::size_t index(const std::size_t i, const std::size_t k, const std::size_t l) const
    {
      return (i * phi.size() + k) * load_level.size() + l;
    }

    /// Reads CSV with the columns nu, phi_deg, load_level, approach, residual_approach, m_law and
    /// n_law in any order; other columns are ignored, and lines that begin with '#' are comments.
    /// Every (ν, φ) must have every Λ once. Refused is what no contact does: an approach below
    /// Hertz's, one or a residual that falls with Λ, n_law outside [0.9, 1.7], m_law and n_law that
    /// do not lead from the peak to the residual, yielding below the onset; and a comment
    /// "#   COLUMN, UNIT, …" that says another unit than 1, of phi_deg deg.
    /// @throws std::runtime_error saying what is wrong and in which line.
    static ContactTable read(std::istream &stream);
  };

  namespace contact_law_detail
  {
    /// Takes the lines of a universal table one by one and makes the table of them.
    class TableReader
    {
    public:
      /// @throws std::runtime_error where the line is neither a comment, the header, nor a new node.
      void take(std::string line)
      {
        ++line_number;
        if (!line.empty() && line.back() == '\r')
          line.pop_back();
        if (line.empty() || line.front() == '#')
          return check_unit(line);
        std::vector<std::string> cells;
        std::istringstream       parts(line);
        for (std::string cell; std::getline(parts, cell, ',');)
          cells.push_back(cell);
        if (!has_header)
          read_header(cells);
        else
          {
            const Row row = read_row(cells);
            if (!rows.emplace(std::tuple(row[0], row[1], row[2]), row).second)
              fail("this nu, phi_deg and load_level stand there twice");
          }
      }

      /// The table of all lines so far.
      /// @throws std::runtime_error where a node is missing or the overlap does not increase with Λ.
      ContactTable table() const
      {
        ContactTable result;
        result.nu         = axis(0);
        result.phi        = axis(1);
        result.load_level = axis(2);
        if (result.load_level.size() < 5)
          fail("fewer than 5 load levels");
        for (const double i : result.nu)
          for (const double k : result.phi)
            {
              const double onset = yield_scales({1, i, k, 1e-9}).onset_level;
              for (const double l : result.load_level)
                {
                  const auto found = rows.find({i, k, l});
                  if (found == rows.end())
                    fail("there is no row for " + node({i, k, l}));
                  const Row &row = found->second;
                  if (l != result.load_level.front() && row[3] <= result.approach.back())
                    fail("the approach does not increase at " + node(row));
                  if (l != result.load_level.front() && row[4] < result.residual.back())
                    fail("the residual approach falls at " + node(row));
                  if (l <= onset && !is_elastic(row))
                    fail("nothing yields, but approach, m_law or n_law is not Hertz's at " +
                         node(row));
                  result.approach.push_back(row[3]);
                  result.residual.push_back(row[4]);
                  result.m.push_back(row[5]);
                  result.n.push_back(row[6]);
                }
            }
        return result;
      }

    private:
      static constexpr std::size_t columns = 7;
      static constexpr const char *names[columns] =
        {"nu", "phi_deg", "load_level", "approach", "residual_approach", "m_law", "n_law"};
      using Row = std::array<double, columns>; ///< in the order of the names

      [[noreturn]] void fail(const std::string &what) const
      {
        throw std::runtime_error("universal table, line " + std::to_string(line_number) + ": " +
                                 what);
      }

      void read_header(const std::vector<std::string> &cells)
      {
        for (std::size_t c = 0; c < columns; ++c)
          {
            const auto found = std::find(cells.begin(), cells.end(), names[c]);
            if (found == cells.end())
              fail("the header lacks the column '" + std::string(names[c]) + "'");
            place[c] = static_cast<std::size_t>(found - cells.begin());
          }
        has_header = true;
      }

      Row read_row(const std::vector<std::string> &cells) const
      {
        Row row{};
        for (std::size_t c = 0; c < columns; ++c)
          {
            std::istringstream cell(place[c] < cells.size() ? cells[place[c]] : "");
            cell.imbue(std::locale::classic());
            if (!(cell >> row[c]) || !(cell >> std::ws).eof() || !is_finite(row[c]))
              fail("'" + cell.str() + "' is no value of " + names[c]);
          }
        if (row[0] < 0 || row[0] >= 0.5 || row[1] < 0 || row[1] >= 90 || !(row[2] > 0))
          fail("nu, phi_deg or load_level is out of range");
        if (!(row[3] > 0) || !(std::abs(row[4]) < row[3]) || row[4] < -1e-3 * row[3] ||
            !(row[5] > 0) || !(row[6] > 0))
          fail("approach, m_law and n_law must be positive, residual_approach from 0 (but for "
               "rounding) to below approach");
        if (row[3] < 0.98 * std::pow(row[2], 2. / 3))
          fail("approach is below Hertz's");
        if (row[6] < 0.9 || row[6] > 1.7)
          fail("n_law must be from 0.9 to 1.7");
        const double recovered = std::pow(row[2] / row[5], 1 / row[6]);
        if (!(std::abs(row[3] - row[4] - recovered) <= 0.015 * row[3]))
          fail("m_law and n_law do not lead from approach to residual_approach");
        return row;
      }

      /// Whether a node is Hertz's contact, but for what discretisation leaves of it.
      static bool is_elastic(const Row &row)
      {
        const auto is_close = [](const double value, const double expected) {
          return std::abs(value - expected) <= 3e-3 * expected;
        };
        return is_close(row[3], std::pow(row[2], 2. / 3)) && is_close(row[5], 1) &&
               is_close(row[6], 1.5);
      }

      void check_unit(const std::string &comment) const
      {
        for (std::size_t c = 0; c < columns; ++c)
          {
            const std::string begin = "#   " + std::string(names[c]) + ", ";
            const std::string unit  = c == 1 ? "deg, " : "1, ";
            if (comment.compare(0, begin.size(), begin) == 0 &&
                comment.compare(begin.size(), unit.size(), unit) != 0)
              fail(std::string(names[c]) + " has another unit than " +
                   unit.substr(0, unit.size() - 2));
          }
      }

      /// The values that a column has in any row, ascending.
      std::vector<double> axis(const std::size_t c) const
      {
        std::vector<double> result;
        for (const auto &row : rows)
          result.push_back(row.second[c]);
        std::sort(result.begin(), result.end());
        result.erase(std::unique(result.begin(), result.end()), result.end());
        return result;
      }

      static std::string node(const Row &row)
      {
        std::ostringstream text;
        text << "nu " << row[0] << ", phi_deg " << row[1] << ", load_level " << row[2];
        return text.str();
      }

      std::map<std::tuple<double, double, double>, Row> rows;
      std::array<std::size_t, columns>                  place{}; ///< of each name in a line
      bool                                              has_header  = false;
      std::size_t                                       line_number = 0;
    };
  } // namespace contact_law_detail

  inline ContactTable ContactTable::read(std::istream &stream)
  {
    contact_law_detail::TableReader reader;
    for (std::string line; std::getline(stream, line);)
      reader.take(line);
    return reader.table();
  }

  /// The law at one peak overlap δ_p.
  struct ContactCoefficients
  {
    double force;    ///< F_p: the loading force at the peak
    double residual; ///< δ_res, where unloading ends: eq (18) of δ_p, F_p, m, n
    double m, n; ///< of eq (17); below the onset of yield 1 and 1.5 (universal) or a and b (row)
  };

  // The two laws that a ContactLaw can be. Both have one interface, and both are written in their
  // own units: ξ is the overlap over its value where the law ceases to be elastic, and a force is
  // over its value there. At ξ ≤ 1 nothing is left after unloading.
  //
  // A call takes 10 to 20 ns, so that it matters what is inlined. The attributes say what is best
  // by measurement; without them it depends on the calling code. Compilers that do not know them
  // ignore them.
  namespace contact_law_detail
  {
    /// The unloading curve of one peak ξ_p: F(ξ) = force ((ξ − residual)/(ξ_p −
    /// residual))^exponent.
    struct UnloadingBranch
    {
      double force, residual, exponent;

      [[gnu::always_inline]] double at(const double xi, const double peak) const
      {
        const double z = (xi - residual) / (peak - residual);
        return z > 0 ? force * power(z, exponent) : 0;
      }
    };

    /// Coefficients that stay what they are, whatever the peak: eqs (16)–(18). ξ = δ/δ_y.
    class RowLaw
    {
    public:
      explicit RowLaw(const ContactRow &row)
        : a(row.a)
        , b(row.b)
        , m(row.m)
        , n(row.n)
        , width(std::pow(row.a / row.m, 1 / row.n))
        , steepness(std::min(1., row.n / row.b))
        , powers(std::make_shared<Powers>(
            Powers{FixedPower(row.b), FixedPower(row.b / row.n), FixedPower(row.n)}))
      {}

      /// The force of loading at ξ > 0.
      [[gnu::always_inline]] double loading(const double xi) const
      {
        return a * powers->loading(xi);
      }

      /// The unloading curve of a peak. Its width is bounded so that unloading is not less steep
      /// than loading, and the residual overlap not negative.
      [[gnu::always_inline]] UnloadingBranch branch(const double xi) const
      {
        if (xi <= 1)
          return {xi > 0 ? loading(xi) : 0, 0, b};
        return {loading(xi), xi - std::min(width * powers->width(xi), xi * steepness), n};
      }

      /// The force at ξ > 0 below the peak.
      [[gnu::noinline]] double unloading(const double xi, const double peak) const
      {
        if (peak <= 1)
          return loading(xi);
        // Where no bound holds the force at the peak need not be known.
        const double w = width * powers->width(peak), least = xi - peak, bound = peak * steepness;
        if (w <= bound)
          return w + least > 0 ? m * powers->unloading(w + least) : 0;
        return UnloadingBranch{loading(peak), peak - bound, n}.at(xi, peak);
      }

      /// m of eq (17) below the onset of yield, where unloading goes back along loading.
      double elastic_m() const { return a; }

      /// The ξ from which on the law is extrapolated: a row has none.
      static constexpr double table_end() { return std::numeric_limits<double>::infinity(); }

    private:
      struct Powers
      {
        FixedPower loading, width, unloading; ///< ξ^b, ξ^(b/n), ξ^n
      };

      double                        a, b, m, n;
      double                        width; ///< δ_p − δ_res over δ_y is this times ξ_p^(b/n)
      double                        steepness; ///< the largest (δ_p − δ_res)/δ_p: min(1, n/b)
      std::shared_ptr<const Powers> powers;
    };

    /// What the universal table says of one material, over s = ln Λ from the onset of yield on.
    /// Hertz's overlap, over δ_y, is Λ^(2/3).
    struct MaterialCurves
    {
      double onset;     ///< s of the onset of yield
      double table_end; ///< the overlap of the last load level over that of the onset
      Cubic  overlap;   ///< ln of δ over Hertz's
      Cubic  width;     ///< ln of δ_p − δ_res over Hertz's δ
      Cubic  exponent;  ///< n of eq (17)

      /// Interpolates the table in (ν, φ). The curves begin at the onset with 0, 0 and 3/2.
      /// @throws std::runtime_error where ν or φ lies outside the table, or all of it is elastic.
      static MaterialCurves
      of(const ContactMaterial &material, const double onset, const ContactTable &table)
      {
        check_within(table.nu, material.poisson_ratio, "Poisson's ratio");
        check_within(table.phi, material.friction_angle_deg, "friction angle");
        const std::vector<double> in_i = weights(table.nu, material.poisson_ratio);
        const std::vector<double> in_k = weights(table.phi, material.friction_angle_deg);
        std::vector<double>       level{onset}, overlap{0.}, width{0.}, exponent{1.5};
        for (std::size_t l = 0; l < table.load_level.size(); ++l)
          {
            const double at = std::log(table.load_level[l]);
            if (at < onset + 0.02) // elastic, or indistinguishable from it
              continue;
            double x = 0, w = 0, n = 0;
            for (std::size_t i = 0; i < in_i.size(); ++i)
              for (std::size_t k = 0; k < in_k.size(); ++k)
                {
                  const std::size_t node   = table.index(i, k, l);
                  const double      weight = in_i[i] * in_k[k];
                  x += weight * (std::log(table.approach[node]) - 2. / 3. * at);
                  w += weight * ((at - std::log(table.m[node])) / table.n[node] - 2. / 3. * at);
                  n += weight * table.n[node];
                }
            level.push_back(at);
            overlap.push_back(x);
            width.push_back(w);
            exponent.push_back(n);
          }
        check(level.size() > 1,
              "the universal table's highest load level",
              table.load_level.back(),
              "plastic");
        return {onset,
                std::exp(2. / 3. * (level.back() - onset) + overlap.back()),
                {level, overlap},
                {level, width},
                {level, exponent}};
      }
    };

    /// One loading curve for every peak, and m and n as functions of the contact's own peak. ξ is
    /// the overlap over that of the onset of yield. Up to it the law is Hertz's; then bins of a
    /// sixteenth of an octave of ξ hold both curves, up to the end of the table.
    class UniversalLaw
    {
    public:
      /// @throws std::runtime_error where the curves are not those of a contact.
      explicit UniversalLaw(const MaterialCurves &curves)
        : last_level(curves.table_end)
      {
        const auto made = std::make_shared<std::vector<Bin>>();
        Node       node;
        while (node.xi < last_level)
          {
            Node next = node_after(node, curves);
            Bin  bin  = bin_between(node, next);
            raise_residual(bin, node, next);
            made->push_back(bin);
            node = next;
          }
        bins = std::shared_ptr<const Bin>(made, made->data());
        end  = {node.xi, node.force, node.slope, node.exponent, node.residual / node.xi};
      }

      /// The force of loading at ξ > 0. Beyond the table it goes on as a power.
      [[gnu::always_inline]] double loading(const double xi) const
      {
        if (xi <= 1)
          return xi * std::sqrt(xi);
        if (xi >= end.xi)
          return end.force * std::pow(xi / end.xi, end.slope);
        const auto [i, t] = place(xi);
        return bins.get()[i].force_at(t);
      }

      /// The unloading curve of a peak.
      [[gnu::always_inline]] UnloadingBranch branch(const double xi) const
      {
        if (xi <= 1)
          return {xi > 0 ? loading(xi) : 0, 0, 1.5};
        if (xi >= end.xi)
          return {loading(xi), end.residual_share * xi, end.exponent};
        const auto [i, t] = place(xi);
        const Bin &bin    = bins.get()[i];
        return {bin.force_at(t), bin.r0 + t * bin.r1, bin.n0 + t * bin.n1};
      }

      /// The force at ξ > 0 below the peak.
      [[gnu::always_inline]] double unloading(const double xi, const double peak) const
      {
        return peak <= 1 ? loading(xi) : branch(peak).at(xi, peak);
      }

      /// m of eq (17) below the onset of yield, where unloading goes back along loading.
      static constexpr double elastic_m() { return 1; }

      /// The ξ from which on the law is extrapolated.
      double table_end() const { return last_level; }

    private:
      static constexpr std::int64_t bins_per_octave = 16;
      static_assert(std::numeric_limits<double>::is_iec559,
                    "the bins are found by the bits of IEEE doubles");

      /// Over t from 0 to 1: the loading force as a cubic, and n and δ_res as straight lines.
      struct alignas(64) Bin
      {
        double f0, f1, f2, f3, n0, n1, r0, r1;

        double force_at(const double t) const { return f0 + t * (f1 + t * (f2 + t * f3)); }
      };

      /// An end of a bin; the first one is the onset of yield.
      struct Node
      {
        double xi = 1, log_force = 0, force = 1;
        double slope    = 1.5; ///< d ln F/d ln ξ
        double exponent = 1.5; ///< n
        double residual = 0;
      };

      /// Where the bins end, for what lies beyond.
      struct End
      {
        double xi, force, slope, exponent, residual_share; ///< the last one over ξ
      };

      /// The bin that ξ ≥ 1 lies in, and how far, from 0 to 1.
      static std::pair<std::int64_t, double> place(const double xi)
      {
        std::uint64_t bits;
        std::memcpy(&bits, &xi, sizeof bits);
        constexpr std::uint64_t one = 0x3FF0000000000000u, part = 0x0000FFFFFFFFFFFFu;
        return {static_cast<std::int64_t>((bits >> 48) - (one >> 48)),
                from_bits((bits & part) << 4 | one) - 1};
      }

      /// The end of the bin that begins at `node`, with the residual overlap that the table gives.
      static Node node_after(const Node &node, const MaterialCurves &curves)
      {
        Node next;
        next.xi = node.xi + std::exp2(std::floor(std::log2(node.xi) + 1e-9)) / bins_per_octave;
        next.log_force = node.log_force;
        for (int k = 0; k < 60; ++k) // Newton on ln ξ = 2/3 ln F + x(ln F)
          {
            const auto [x, dx] = curves.overlap(curves.onset + next.log_force);
            const double change =
              (std::log(next.xi) - 2. / 3. * next.log_force - x) / (2. / 3. + dx);
            next.log_force += change;
            if (std::abs(change) < 1e-14)
              break;
          }
        const double level = curves.onset + next.log_force;
        const auto [x, dx] = curves.overlap(level);
        next.force         = std::exp(next.log_force);
        next.slope         = 1 / (2. / 3. + dx);
        next.exponent      = curves.exponent(level).first;
        next.residual      = next.xi * (1 - std::exp(curves.width(level).first - x));
        return next;
      }

      /// The bin between two nodes, all but the slope of its residual overlap.
      static Bin bin_between(const Node &node, const Node &next)
      {
        const double step = next.xi - node.xi, rise = next.force - node.force;
        const double d0 = step * node.slope * node.force / node.xi,
                     d1 = step * next.slope * next.force / next.xi;
        return {node.force,
                d0,
                3 * rise - 2 * d0 - d1,
                d0 + d1 - 2 * rise,
                node.exponent,
                next.exponent - node.exponent,
                node.residual,
                0};
      }

      /// Raises the residual overlap at the end of the bin where (1)–(3) of ContactLaw ask for it.
      /// @throws std::runtime_error where the loading curve or the result is not that of a contact.
      static void raise_residual(Bin &bin, const Node &node, Node &next)
      {
        const double step = next.xi - node.xi, xi = node.xi, r = node.residual, n = node.exponent;
        next.residual = std::max(next.residual, r); // (1)
        if (next.exponent < n)                      // (3)
          next.residual = std::max(
            next.residual, r + (n - next.exponent) / next.exponent * std::max(xi - r, next.xi - r));
        for (double t = 0.125; t <= 1; t += 0.125) // (2), also between the ends of the bin
          {
            const double rise  = (bin.f1 + t * (2 * bin.f2 + t * 3 * bin.f3)) / step;
            const double least = xi + t * step - (n + t * bin.n1) * bin.force_at(t) / rise;
            next.residual      = std::max(next.residual, r + (least - r) / t);
          }
        check(next.slope > 0 && next.slope < 3,
              "the slope of ln F over ln delta in the universal table",
              next.slope,
              "between 0 and 3");
        check(next.residual < next.xi,
              "delta_res over delta after the fall of n in the universal table",
              next.residual / next.xi,
              "below 1");
        bin.r1 = next.residual - r;
      }

      double                     last_level; ///< ξ of the table's last load level
      End                        end{};
      std::shared_ptr<const Bin> bins; ///< the first of them
    };
  } // namespace contact_law_detail

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
  /// value at z = 1. Both laws raise δ_res where a row or a table violates one of the three by
  /// rounding or noise.
  ///
  /// A copy shares the tables of the original. Calls from several threads are safe.
  class ContactLaw
  {
  public:
    /// Coefficients that stay what they are, whatever the peak. The law is reversible up to δ_y;
    /// beyond, it is eqs (16)–(18).
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
      const double force   = row.force_yield / row.effective_radius / row.effective_radius;
      const double overlap = row.approach_yield / row.effective_radius;
      return ContactLaw(contact_law_detail::RowLaw(row), {force, overlap, force, overlap});
    }

    /// One loading curve for every peak, and m and n as functions of the contact's own peak. The
    /// table is interpolated in (ν, φ), smoothly, once.
    /// @throws std::runtime_error naming what is out of range.
    static ContactLaw universal(const ContactMaterial &material, const ContactTable &table)
    {
      using namespace contact_law_detail;
      const YieldScales scales = yield_scales(material);
      const double      onset  = std::log(scales.onset_level);
      return ContactLaw(UniversalLaw(MaterialCurves::of(material, onset, table)),
                        {scales.force,
                         scales.approach,
                         scales.force * scales.onset_level,
                         scales.approach * std::exp(2. / 3. * onset)});
    }

    /// R* of two radii.
    static double effective_radius(const double radius_1, const double radius_2)
    {
      return radius_1 * radius_2 / (radius_1 + radius_2);
    }

    /// The contact of two bodies of this R*, all scales computed once.
    /// @throws std::runtime_error unless R* is finite and positive.
    ContactPair pair(double effective_radius) const;

    /// Force of any contact of this material at this overlap, which follows those before. It takes
    /// a division more than ContactPair::evaluate. It allocates nothing and never throws.
    ContactResponse evaluate(const double  overlap,
                             const double  effective_radius,
                             ContactState &state) const noexcept
    {
      if (!is_length(effective_radius))
        return {0, contact_input_invalid};
      const double per_overlap = 1 / (scales.overlap_unit * effective_radius),
                   force_unit  = scales.force_unit * effective_radius * effective_radius;
      return evaluate(overlap, per_overlap, force_unit, state);
    }

    /// F_y for this R*.
    double force_yield(const double effective_radius) const
    {
      return scales.force_yield * effective_radius * effective_radius;
    }

    /// δ_y for this R*.
    double approach_yield(const double effective_radius) const
    {
      return scales.overlap_yield * effective_radius;
    }

    /// Force, residual overlap, m and n of the unloading curve that begins at this peak.
    ContactCoefficients coefficients(const double peak_overlap, const double effective_radius) const
    {
      const double xi    = peak_of(peak_overlap / (scales.overlap_unit * effective_radius));
      const auto   at    = branch(xi);
      const double force = at.force * scales.force_unit * effective_radius * effective_radius;
      if (xi <= 1)
        return {force, 0, with_law([](const auto &of) { return of.elastic_m(); }), at.exponent};
      const double w = (xi - at.residual) * scales.overlap_unit / scales.overlap_yield;
      return {force,
              at.residual * scales.overlap_unit * effective_radius,
              at.force * scales.force_unit / scales.force_yield / std::pow(w, at.exponent),
              at.exponent};
    }

    /// dF/dδ where unloading from this peak begins. It is the largest stiffness of a contact, which
    /// limits the time step, and 2E*a of its contact radius a.
    double stiffness(const double peak_overlap, const double effective_radius) const
    {
      return stiffness(peak_of(peak_overlap / (scales.overlap_unit * effective_radius))) *
             scales.force_unit / scales.overlap_unit * effective_radius;
    }

    /// The contact radius over 2R* at this peak, from the stiffness: in small strain that is exact
    /// for the law's own stiffness.
    double strain_measure(const double peak_overlap, const double effective_radius) const
    {
      return strain_measure(peak_of(peak_overlap / (scales.overlap_unit * effective_radius)));
    }

  private:
    friend class ContactPair;
    static constexpr double largest = 1e100; ///< an overlap ξ or an R* that is not below it is none

    /// An R*: its square and what is divided by it stay finite.
    static bool is_length(const double radius)
    {
      using namespace contact_law_detail;
      return is_positive(radius) && is_below(radius, largest) && radius > 1 / largest;
    }

    /// The ξ of a peak; 0 of what is none: negative, NaN, infinite.
    static double peak_of(const double xi)
    {
      using namespace contact_law_detail;
      return is_positive(xi) && is_below(xi, largest) ? xi : 0;
    }

    /// For R* = 1; a force grows with R*², an overlap with R*.
    struct Scales
    {
      double force_yield, overlap_yield; ///< F_y and δ_y
      double force_unit, overlap_unit;   ///< the units of the law: of F and ξ
    };

    template <typename Law>
    ContactLaw(Law law_, const Scales &scales_)
      : law(std::move(law_))
      , scales(scales_)
      , strain_limit(find_strain_limit())
    {
      using contact_law_detail::check_positive;
      check_positive("F_y over R*^2", scales.force_yield);
      check_positive("delta_y over R*", scales.overlap_yield);
      check_positive("the largest elastic F over R*^2", scales.force_unit);
      check_positive("the largest elastic delta over R*", scales.overlap_unit);
    }

    /// Calls with the law in its own class: a comparison, then code that the compiler knows.
    template <typename Act>
    auto with_law(const Act &act) const
      -> decltype(act(std::declval<const contact_law_detail::RowLaw &>()))
    {
      if (const auto *const row = std::get_if<contact_law_detail::RowLaw>(&law))
        return act(*row);
      return act(*std::get_if<contact_law_detail::UniversalLaw>(&law));
    }

    contact_law_detail::UnloadingBranch branch(const double xi) const
    {
      return with_law([xi](const auto &of) { return of.branch(xi); });
    }

    double stiffness(const double xi) const
    {
      const auto at = branch(xi);
      return xi > 0 ? at.exponent * at.force / (xi - at.residual) : 0;
    }

    /// a/(2R*): Hertz's (1/2)√(δ_y/R*) at F_y, and in proportion to the stiffness.
    double strain_measure(const double xi) const
    {
      return std::sqrt(scales.overlap_yield) / 3 * stiffness(xi) *
             (scales.force_unit / scales.force_yield) /
             (scales.overlap_unit / scales.overlap_yield);
    }

    /// The ξ at which a/(2R*) is 0.1, by bisection.
    double find_strain_limit() const
    {
      double low = -230, high = 230; // ln ξ
      for (int k = 0; k < 60; ++k)
        (strain_measure(std::exp((low + high) / 2)) > 0.1 ? high : low) = (low + high) / 2;
      return std::exp(high);
    }

    ContactResponse evaluate(const double  overlap,
                             const double  per_overlap,
                             const double  force_unit,
                             ContactState &state) const noexcept
    {
      return with_law(
        [&](const auto &of) { return respond(of, overlap, per_overlap, force_unit, state); });
    }

    template <typename Law>
    ContactResponse respond(const Law    &of,
                            const double  overlap,
                            const double  per_overlap,
                            const double  force_unit,
                            ContactState &state) const noexcept
    {
      const double xi = overlap * per_overlap;
      if (!contact_law_detail::is_below(xi, largest))
        return {0, contact_input_invalid};
      double peak = peak_of(state.peak_overlap * per_overlap);
      if (!contact_law_detail::is_positive(peak))
        state.peak_overlap = 0;
      double       force = 0;
      unsigned int flags = 0;
      // Not of ξ, for which a processor would wait before it knows the branch.
      if (overlap >= state.peak_overlap && overlap > 0)
        {
          peak               = xi;
          state.peak_overlap = overlap;
          force              = of.loading(xi);
          flags              = contact_loading;
        }
      else if (xi > 0)
        force = of.unloading(xi, peak);
      flags |= (force > 0 ? contact_pressed : 0u) | (peak > 1 ? contact_yielded : 0u) |
               (peak > strain_limit ? contact_strain_large : 0u) |
               (peak > of.table_end() ? contact_extrapolated : 0u);
      return {force * force_unit, flags};
    }

    std::variant<contact_law_detail::RowLaw, contact_law_detail::UniversalLaw> law;
    Scales                                                                     scales;
    double strain_limit; ///< the ξ beyond which contact_strain_large is raised
  };

  /// A law with one R*.
  class ContactPair
  {
  public:
    /// @throws std::runtime_error unless R* is finite and positive.
    ContactPair(const ContactLaw &law_, const double effective_radius_)
      : law(law_)
      , radius(effective_radius_)
    {
      contact_law_detail::check(ContactLaw::is_length(radius),
                                "the effective radius R*",
                                radius,
                                "finite, positive, and from 1e-100 to 1e100 m");
      per_overlap = 1 / (law.scales.overlap_unit * radius);
      force_unit  = law.scales.force_unit * radius * radius;
    }

    /// Force at this overlap, which follows those before. It allocates nothing and never throws.
    ContactResponse evaluate(const double overlap, ContactState &state) const noexcept
    {
      return law.evaluate(overlap, per_overlap, force_unit, state);
    }

    // As ContactLaw's, for this R*.

    double              force_yield() const { return law.force_yield(radius); }
    double              approach_yield() const { return law.approach_yield(radius); }
    ContactCoefficients coefficients(const double peak) const
    {
      return law.coefficients(peak, radius);
    }
    double stiffness(const double peak) const { return law.stiffness(peak, radius); }

  private:
    ContactLaw law;
    double     radius, per_overlap, force_unit;
  };

  inline ContactPair ContactLaw::pair(const double effective_radius) const
  {
    return {*this, effective_radius};
  }
} // namespace dpcontact

#endif
