// The contact law over histories of overlaps: branches, continuity, energy, unusual input.
#include "tests/support/floating_point_traps.h"
#include "tests/support/small_table.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <random>

namespace
{
  std::atomic<long> allocations{0};
}

// Not inlined, where GCC would see free() of what new has given.
[[gnu::noinline]] void *operator new(const std::size_t size)
{
  ++allocations;
  if (void *const memory = std::malloc(size))
    return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void *memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void *memory, std::size_t) noexcept { std::free(memory); }

namespace
{
  using namespace dpcontact;
  using tests::half_radius;
  using tests::laws;

  const auto *const traps = tests::FloatingPointTraps::install();

  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan_     = std::numeric_limits<double>::quiet_NaN();

  /// Force at the end of a history of overlaps in units of δ_y, in units of F_y.
  class Contact
  {
  public:
    explicit Contact(const ContactLaw &law)
      : pair(law.pair(half_radius))
    {}
    double operator()(const double x)
    {
      response = pair.evaluate(x * pair.approach_yield(), state);
      return response.force / pair.force_yield();
    }
    double residual() const
    {
      return pair.coefficients(state.peak_overlap).residual / pair.approach_yield();
    }

    ContactPair     pair;
    ContactState    state;
    ContactResponse response{};
  };

  TEST(ContactLawHistory, branches_of_every_history)
  {
    for (const auto &[name, law] : laws())
      {
        SCOPED_TRACE(name);
        const auto virgin = [&law = law](const double x) { return Contact(law)(x); };
        Contact    contact(law);
        EXPECT_EQ(contact(5), virgin(5));
        EXPECT_TRUE(contact.response.flags & contact_loading);
        const double at_4 = contact(4), at_3 = contact(3);
        EXPECT_LE(at_4, virgin(4) * (1 + 1e-12)) << "unloading is below loading";
        EXPECT_LT(at_3, at_4);
        EXPECT_FALSE(contact.response.flags & contact_loading);
        EXPECT_EQ(contact(4), at_4) << "reloading below the peak follows unloading back";
        EXPECT_EQ(contact(3), at_3);
        EXPECT_EQ(contact(5), virgin(5)) << "and reaches the peak";
        EXPECT_EQ(contact(8), virgin(8)) << "beyond it loading goes on as if nothing had been";
        const double residual = contact.residual();
        EXPECT_GE(residual, 0);
        EXPECT_LT(residual, 8);
        if (residual > 0)
          {
            EXPECT_EQ(contact(residual * (1 - 1e-9)), 0) << "separated, with an overlap left";
            EXPECT_FALSE(contact.response.flags & contact_pressed);
            EXPECT_TRUE(contact.response.flags & contact_yielded);
          }
        EXPECT_EQ(contact(-1), 0);
        EXPECT_EQ(contact(0), 0);
        EXPECT_EQ(contact(8), virgin(8)) << "the dent is remembered through separation";
        const ContactState saved = contact.state; // a restart file
        const double       next  = contact(7);
        contact.state            = saved;
        EXPECT_EQ(contact(7), next) << "the state is all there is to remember";
      }
  }

  TEST(ContactLawHistory, peak_is_eq_18s_and_its_force_the_loading_curves)
  {
    for (const auto &[name, law] : laws())
      for (double x = 0.01; x < 2000; x *= 1.13)
        {
          Contact      contact(law);
          const double force = contact(x);
          const auto   at    = contact.pair.coefficients(contact.state.peak_overlap);
          EXPECT_NEAR(at.force / contact.pair.force_yield(), force, 1e-14 * force) << name;
          const double eq_18 = x - std::pow(force / at.m, 1 / at.n);
          EXPECT_NEAR(at.residual / contact.pair.approach_yield(), eq_18, 1e-12 * x) << name;
          // Eq (17) on the way down.
          const double y = 0.3 * contact.residual() + 0.7 * x;
          if (!(contact.response.flags & contact_yielded))
            continue;
          EXPECT_NEAR(contact(y), at.m * std::pow(y - contact.residual(), at.n), 1e-11 * force)
            << name << " at " << x;
        }
  }

  TEST(ContactLawHistory, nothing_is_left_below_yield)
  {
    for (const auto &[name, law] : laws())
      {
        const bool row = name.find("nu") != 0;
        // A row is reversible up to δ_y; a universal law up to where the ring yields.
        const double onset =
          row ? 1
              : std::pow(yield_scales(tests::rock_of(std::stod(name.substr(3)),
                                                     std::stod(name.substr(name.find("phi") + 4))))
                           .onset_level,
                         2. / 3);
        for (const double x : {0.01, 0.3, 0.9999})
          {
            Contact      contact(law);
            const double up = contact(x * onset), down = contact(x * onset / 2);
            EXPECT_EQ(contact.residual(), 0) << name;
            EXPECT_EQ(down, Contact(law)(x * onset / 2)) << name << ": down as up";
            EXPECT_FALSE(contact.response.flags & contact_yielded);
            if (!row)
              {
                EXPECT_NEAR(up, std::pow(x * onset, 1.5), 1e-14 * up) << name << ": Hertz";
                EXPECT_NEAR(down, std::pow(x * onset / 2, 1.5), 1e-14 * up) << name;
              }
          }
        Contact beyond(law);
        beyond(1.0001 * onset);
        EXPECT_TRUE(beyond.response.flags & contact_yielded) << name;
      }
  }

  TEST(ContactLawHistory, residual_never_decreases_and_unloading_branches_never_cross)
  {
    // The three conditions of the header's proof, by differences: at every overlap the force of a
    // branch does not increase with the branch's peak. 1e-12: rounding of the force over the
    // peak's.
    for (const auto &[name, law] : laws())
      {
        double last_residual = 0, last_peak = 0;
        for (double peak = 0.05; peak < 3000; last_peak = peak, peak *= 1.003)
          {
            Contact      contact(law);
            const double force = contact(peak);
            EXPECT_GE(contact.residual(), last_residual) << name << " at " << peak;
            last_residual = contact.residual();
            if (last_peak == 0)
              continue;
            Contact before(law);
            before(last_peak);
            for (const double share : {0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 0.99, 0.9999})
              {
                const double x = contact.residual() + share * (last_peak - contact.residual());
                EXPECT_LE(contact(x), before(x) + 1e-12 * force)
                  << name << " at " << x << " of " << peak;
              }
          }
      }
  }

  TEST(ContactLawHistory, loading_is_monotone_and_smooth)
  {
    // Slopes from either side of any overlap agree: C¹. Universal laws only; a row is a power.
    for (const auto &[name, law] : laws())
      {
        double last = 0;
        for (double x = 0.05; x < 1500; x *= 1.0007)
          {
            const double force = Contact(law)(x);
            ASSERT_GT(force, last) << name << " at " << x;
            last            = force;
            const double h  = 1e-5 * x;
            const double up = Contact(law)(x + h) - force, down = force - Contact(law)(x - h);
            ASSERT_NEAR(up / down, 1, 2e-5) << name << " at " << x;
          }
      }
  }

  /// Moves the contact from overlap `from` to `to` and returns the work ∫F dδ: Gauss's five points
  /// on pieces that end where the force has a kink, at the peak so far and at the residual overlap,
  /// over the root of δ − δ_res, in which the force is smooth there.
  double work_of_move(Contact &contact, const double from, const double to)
  {
    constexpr double nodes[] = {
      -0.9061798459386640, -0.5384693101056831, 0, 0.5384693101056831, 0.9061798459386640};
    constexpr double    weights[] = {0.2369268850561891,
                                     0.4786286704993665,
                                     0.5688888888888889,
                                     0.4786286704993665,
                                     0.2369268850561891};
    const double        peak      = contact.state.peak_overlap / contact.pair.approach_yield();
    const double        residual  = contact.residual();
    std::vector<double> ends{from, to};
    for (const double kink : {residual, peak})
      if ((kink - from) * (to - kink) > 0)
        ends.push_back(kink);
    std::sort(ends.begin(), ends.end());
    if (to < from)
      std::reverse(ends.begin(), ends.end());
    double work = 0;
    for (std::size_t i = 1; i < ends.size(); ++i)
      {
        const double a = std::sqrt(std::max(ends[i - 1] - residual, 0.)),
                     b = std::sqrt(std::max(ends[i] - residual, 0.));
        // The overlaps follow each other in order: a history like any other.
        for (int k = 0; k < 5; ++k)
          {
            const double root = (a + b + nodes[k] * (b - a)) / 2;
            work += weights[k] * (b - a) * root * contact(residual + root * root);
          }
        contact(ends[i]);
      }
    return work;
  }

  TEST(ContactLawHistory, random_walk_of_a_million_overlaps)
  {
    // Steps of all sizes, long excursions, separations. Work − what unloading would give back is
    // what has been dissipated: it never falls, so that no cycle gains. 1e-6 of the work so far is
    // left to the integration. No force steps by more than the largest stiffness times the step.
    constexpr int   steps = 1000000;
    std::mt19937_64 random(20180612);
    const auto      everything = laws();
    for (std::size_t i = 0; i < everything.size(); ++i)
      {
        SCOPED_TRACE(everything[i].name);
        Contact                                contact(everything[i].law);
        std::normal_distribution<double>       normal;
        std::uniform_real_distribution<double> uniform;
        const double unit = contact.pair.approach_yield(), force_unit = contact.pair.force_yield();
        double       x = 0, force = 0, work = 0, scale = 0.01, dissipated = 0, gain = 0, jump = 0;
        bool         numbers = true;
        // One law of each kind walks a million, the others 50000 each.
        const int count = i == 0 || i + 1 == everything.size() ? steps : steps / 20;
        for (int k = 0; k < count; ++k)
          {
            if (uniform(random) < 1e-3)
              scale = std::exp(uniform(random) * 5 - 6);
            const double centre = k < count / 2 ? 2. : 60.;
            const double next   = x + scale * normal(random) + 1e-3 * scale * (centre - x);
            work += work_of_move(contact, x, next);
            const double now       = contact(next);
            numbers                = numbers && std::isfinite(now) && now >= 0;
            const double peak      = std::max(contact.state.peak_overlap, unit);
            const double stiffness = 1.5 * contact.pair.stiffness(peak) * unit / force_unit;
            jump  = std::max(jump, std::abs(now - force) / (stiffness * std::abs(next - x)));
            x     = next;
            force = now;
            const auto   at   = contact.pair.coefficients(contact.state.peak_overlap);
            const double w    = std::max(x - at.residual / unit, 0.);
            const double lost = work - force * w / (at.n + 1);
            gain              = std::max(gain, (dissipated - lost) / (1 + work));
            dissipated        = std::max(dissipated, lost);
          }
        EXPECT_TRUE(numbers);
        EXPECT_LE(jump, 1);
        EXPECT_LE(gain, 1e-6);
        EXPECT_GT(contact.state.peak_overlap, 5 * unit) << "the walk went somewhere";
      }
  }

  TEST(ContactLawHistory, closed_cycles_take_work_exactly)
  {
    // By closed form: ∫U = F_p w/(n + 1) from δ_res up to the peak; ∫L by Gauss's rule on short
    // pieces.
    const auto loading_work = [](const ContactLaw &law, const double from, const double to) {
      const double  root   = std::sqrt(0.6) / 2;
      double        sum    = 0;
      constexpr int pieces = 2000;
      for (int i = 0; i < pieces; ++i)
        {
          const double a = from * std::pow(to / from, static_cast<double>(i) / pieces);
          const double h = from * std::pow(to / from, (i + 1.) / pieces) - a;
          sum += h / 18 *
                 (5 * Contact(law)(a + h * (0.5 - root)) + 8 * Contact(law)(a + h / 2) +
                  5 * Contact(law)(a + h * (0.5 + root)));
        }
      return sum;
    };
    for (const auto &[name, law] : laws())
      {
        const auto given_back = [&law = law](const double peak) {
          Contact      contact(law);
          const double force = contact(peak);
          const auto   at    = contact.pair.coefficients(contact.state.peak_overlap);
          return force * (peak - contact.residual()) / (at.n + 1);
        };
        double before = 0.2, kept = 0;
        for (double peak = 0.22; peak < 400; before = peak, peak *= 1.1)
          {
            const double put_in = loading_work(law, before, peak);
            const double stored = given_back(peak) - given_back(before);
            kept += put_in - stored;
            EXPECT_GE(put_in - stored, -1e-7 * put_in)
              << name << " from " << before << " to " << peak;
          }
        EXPECT_GE(kept, -1e-7) << name;
      }
  }

  TEST(ContactLawHistory, unusual_overlaps_and_states)
  {
    for (const auto &[name, law] : laws())
      {
        SCOPED_TRACE(name);
        Contact contact(law);
        contact(5);
        const double peak = contact.state.peak_overlap;
        for (const double bad : {nan_, infinity, -infinity, 1e200})
          {
            const ContactResponse response = contact.pair.evaluate(bad, contact.state);
            EXPECT_EQ(response.force, 0);
            EXPECT_EQ(response.flags, contact_input_invalid);
            EXPECT_EQ(contact.state.peak_overlap, peak) << "the state is left alone";
          }
        for (const double none : {0., -0., -1e-300, -1., -1e90})
          {
            EXPECT_EQ(contact(none), 0);
            EXPECT_EQ(contact.response.flags & (contact_pressed | contact_loading), 0u);
            EXPECT_EQ(contact.state.peak_overlap, peak);
          }
        for (const double tiny : {1e-300, 5e-324})
          EXPECT_GE(Contact(law)(tiny), 0);
        for (const double damaged : {nan_, infinity, -infinity, -1.})
          {
            contact.state.peak_overlap = damaged;
            EXPECT_EQ(contact(3), Contact(law)(3)) << "a damaged state counts as a new contact";
          }
        ContactState state;
        for (const double radius : {0., -1., nan_})
          {
            const ContactResponse response = law.evaluate(1e-6, radius, state);
            EXPECT_EQ(response.force, 0);
            EXPECT_EQ(response.flags, contact_input_invalid);
          }
      }
  }

  TEST(ContactLawHistory, allocates_nothing_per_call)
  {
    for (const auto &[name, law] : laws())
      {
        Contact    contact(law);
        const long before = allocations;
        double     sum    = 0;
        for (int i = 0; i < 1000; ++i)
          sum +=
            contact(20 * std::sin(0.01 * i)) + law.evaluate(1e-6 * i, 0.03, contact.state).force;
        EXPECT_EQ(allocations, before) << name;
        EXPECT_GT(sum, 0);
      }
  }
} // namespace
