// What a call of the contact law takes beside a call of Hertz's, by Google Benchmark. The first
// argument is a universal table. The overlaps are drawn beforehand; 4096 contacts, each with a
// state of its own, stand for a bed, in which loading and unloading follow each other at random.
#include "database/contact_law/contact_law.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <optional>
#include <random>

namespace
{
  using namespace dpcontact;

  constexpr std::size_t contacts = 4096, rounds = 16;
  constexpr double      radius = 0.05; // R*

  std::optional<ContactLaw> universal, row;

  /// How the overlaps of a contact follow each other.
  enum Pattern
  {
    loading,   ///< every contact is new
    unloading, ///< all lie below the peak so far
    bed        ///< a random walk
  };

  /// Overlaps of all contacts in all rounds, `contacts` in each round.
  std::vector<double> overlaps(const ContactLaw &of, const Pattern pattern)
  {
    std::mt19937_64                        random(7);
    std::uniform_real_distribution<double> uniform;
    const double                           unit = of.approach_yield(radius);
    std::vector<double>                    result(contacts * rounds);
    for (std::size_t i = 0; i < result.size(); ++i)
      switch (pattern)
        {
          case loading:
            result[i] = unit * std::exp(std::log(100.) * uniform(random));
            break;
          case unloading:
            result[i] = unit * (95 + 5 * uniform(random));
            break;
          case bed:
            result[i] = i < contacts
                          ? 20 * unit * uniform(random)
                          : std::abs(result[i - contacts] + unit * (6 * uniform(random) - 2.9));
            break;
        }
    return result;
  }

  void hertz(benchmark::State &state)
  {
    const std::vector<double> delta    = overlaps(*universal, bed);
    const double              approach = universal->approach_yield(radius);
    const std::vector<double> k(contacts,
                                universal->force_yield(radius) / approach / std::sqrt(approach));
    for (auto _ : state)
      {
        double sum = 0;
        for (std::size_t i = 0; i < delta.size(); ++i)
          sum += delta[i] > 0 ? k[i % contacts] * delta[i] * std::sqrt(delta[i]) : 0;
        benchmark::DoNotOptimize(sum);
      }
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(delta.size()));
  }

  /// Where the constants of a contact come from.
  enum Constants
  {
    one_pair,   ///< one for all
    own_pairs,  ///< a ContactPair for each
    own_radius, ///< computed in the call from R*
  };

  void contact(benchmark::State &state,
               const ContactLaw &of,
               const Pattern     pattern,
               const Constants   constants)
  {
    const ContactPair         one   = of.pair(radius);
    const std::vector<double> delta = overlaps(of, pattern);
    const ContactState        start{pattern == unloading ? 100 * of.approach_yield(radius) : 0};
    std::vector<ContactState> states(contacts, start);
    // Vectors, as the compiler must not know the values.
    const std::vector<double>      radii(contacts, radius);
    const std::vector<ContactPair> pairs(constants == own_pairs ? contacts : 0, one);
    const auto                     run = [&](const auto &force) {
      for (auto _ : state)
        {
          double sum = 0;
          for (std::size_t i = 0; i < delta.size(); ++i)
            {
              ContactState &own = states[i % contacts];
              if (pattern == loading || (pattern == bed && i < contacts))
                own = start;
              sum += force(i % contacts, delta[i], own);
            }
          benchmark::DoNotOptimize(sum);
        }
    };
    if (constants == one_pair)
      run(
        [&](std::size_t, const double x, ContactState &own) { return one.evaluate(x, own).force; });
    else if (constants == own_pairs)
      run([&](const std::size_t i, const double x, ContactState &own) {
        return pairs[i].evaluate(x, own).force;
      });
    else
      run([&](const std::size_t i, const double x, ContactState &own) {
        return of.evaluate(x, radii[i], own).force;
      });
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(delta.size()));
  }

  void construction(benchmark::State &state, const ContactTable &table)
  {
    for (auto _ : state)
      benchmark::DoNotOptimize(ContactLaw::universal({10e9, 0.17, 26, 10e6}, table));
  }
} // namespace

int main(int argc, char **argv)
{
  benchmark::Initialize(&argc, argv);
  std::ifstream file(argc == 2 ? argv[1] : "");
  if (!file)
    {
      std::fprintf(stderr, "usage: dpcontact_law_benchmark TABLE.csv [--benchmark_…]\n");
      return 2;
    }
  const ContactTable table = ContactTable::read(file);
  universal                = ContactLaw::universal({10e9, 0.17, 26, 10e6}, table);
  row = ContactLaw::from_row({1.0997, 1.435, 2.4076, 1.3686, 0.3354, 3.6436e-7, radius});
  benchmark::RegisterBenchmark("hertz", hertz);
  for (const ContactLaw *const law : {&*universal, &*row})
    {
      const std::string name = law == &*universal ? "universal/" : "row/";
      const auto        add  = [&](const char *what, const Pattern pattern, const Constants from) {
        benchmark::RegisterBenchmark(
          (name + what).c_str(), contact, std::cref(*law), pattern, from);
      };
      add("loading", loading, one_pair);
      add("unloading", unloading, one_pair);
      add("bed", bed, one_pair);
      add("bed_of_own_pairs", bed, own_pairs);
      add("bed_of_any_radii", bed, own_radius);
    }
  benchmark::RegisterBenchmark("construction", construction, table);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
