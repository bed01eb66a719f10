// Where the time of whole curves goes: the processor-time timer interrupts the solver, and every
// sample is booked on the stage whose function stands deepest in its stack. Run: dpcontact_profile
// E ν φ σc RESOLUTION (GPa, °, MPa).
#include "fitting/curve_fit.h"
#include "solver/parallel/environment.h"
#include "solver/path/solution.h"
#include "solver/path/solve.h"

#include <nlohmann/json.hpp>

#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cxxabi.h>
#include <dlfcn.h>
#include <execinfo.h>
#include <iostream>
#include <string>
#include <sys/time.h>
#include <unordered_map>
#include <vector>

namespace
{
  constexpr double      least_seconds = 4; ///< whole curves are repeated until then
  constexpr int         depth         = 64;
  constexpr std::size_t most_samples  = 100000;
  constexpr suseconds_t period        = 1000; ///< µs asked for; the kernel's tick is the least

  struct Sample
  {
    std::array<void *, depth> frames;
    int                       n;
  };
  std::vector<Sample>  samples(most_samples);
  volatile std::size_t taken = 0;

  void take_sample(int)
  {
    if (taken < most_samples)
      {
        Sample &sample = samples[taken];
        sample.n       = backtrace(sample.frames.data(), depth);
        taken          = taken + 1;
      }
  }

  void set_timer(const suseconds_t microseconds)
  {
    const itimerval timer{{0, microseconds}, {0, microseconds}};
    setitimer(ITIMER_PROF, &timer, nullptr);
  }

  struct Stage
  {
    const char *function, *name;
  };

  /// The first of these that a stack holds, from its top.
  constexpr std::array<Stage, 12> stages{{{"CholeskySolver::factorize", "factorise"},
                                          {"CholeskySolver::solve", "solve"},
                                          {"make_direct_solver", "core"},
                                          {"CondensedSubdomain<2>::CondensedSubdomain", "core"},
                                          {"ContactSystem<2>::correction", "assemble"},
                                          {"ContactSystem<2>::residual", "residual"},
                                          {"ContactSystem<2>::complete", "rest after a step"},
                                          {"make_zoned_mesh", "mesh"},
                                          {"dpcontact::assess", "mesh"},
                                          {"Discretisation<2>::Discretisation", "discretisation"},
                                          {"ContactSystem<2>::ContactSystem", "elastic stiffness"},
                                          {"fit_curve", "fit"}}};

  std::string function_at(void *address)
  {
    Dl_info info{};
    if (dladdr(address, &info) == 0 || info.dli_sname == nullptr)
      return "";
    int         status    = 0;
    char       *demangled = abi::__cxa_demangle(info.dli_sname, nullptr, nullptr, &status);
    std::string name      = demangled != nullptr ? demangled : info.dli_sname;
    std::free(demangled);
    return name;
  }

  struct Booking
  {
    std::string stage;
    bool        in_pilot; ///< loading of a coarse run that sizes the mesh
    bool        complete; ///< the stack reaches back to the program's start
  };

  Booking book(const Sample &sample)
  {
    static std::unordered_map<void *, std::string> names;
    Booking                                        result{"other", false, false};
    bool                                           condensing = false;
    for (int k = 0; k < sample.n; ++k)
      {
        void *address     = sample.frames[static_cast<std::size_t>(k)];
        auto [name, made] = names.try_emplace(address);
        if (made)
          name->second = function_at(address);
        for (const Stage &stage : stages)
          if (result.stage == "other" && name->second.find(stage.function) != std::string::npos)
            result.stage = stage.name;
        // Condensation factorises and solves as well.
        condensing = condensing || name->second.find("CondensedSubdomain<2>::CondensedSubdomain") !=
                                     std::string::npos;
        result.in_pilot = result.in_pilot || name->second.find("run_to_peak") != std::string::npos;
        result.complete = result.complete || name->second == "main";
      }
    if (condensing)
      result.stage = "core";
    return result;
  }
} // namespace

int main(int argc, char **argv)
{
  using namespace dpcontact;
  if (argc != 6)
    {
      std::cerr << "usage: dpcontact_profile E_GPa nu phi_degrees sigma_c_MPa resolution\n";
      return 2;
    }
  const Environment environment;
  const Material    material{1e9 * std::atof(argv[1]),
                          std::atof(argv[2]),
                          Angle(std::atof(argv[3])),
                          1e6 * std::atof(argv[4])};
  SolverOptions     options;
  options.resolution = static_cast<unsigned int>(std::atoi(argv[5]));

  Sample warm_up{}; // the first backtrace() loads a library, which no signal handler may
  warm_up.n = backtrace(warm_up.frames.data(), depth);
  std::signal(SIGPROF, take_sample);

  const auto   start  = std::chrono::steady_clock::now();
  double       passed = 0;
  unsigned int curves = 0;
  while (passed < least_seconds)
    {
      set_timer(period);
      const Solution solution = solve_contact(material, Scene(), options);
      fit_curve(solution.curve, solution.yield.force, solution.yield.approach);
      set_timer(0);
      ++curves;
      passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }

  std::unordered_map<std::string, double> share;
  double                                  pilots = 0, incomplete = 0;
  const double                            one = 1. / static_cast<double>(taken);
  for (std::size_t k = 0; k < taken; ++k)
    {
      const Booking booking = book(samples[k]);
      share[booking.stage] += one;
      pilots += booking.in_pilot ? one : 0;
      incomplete += booking.complete ? 0 : one;
    }
  std::cout << nlohmann::json{{"curves", curves},
                              {"seconds", passed / curves},
                              {"samples", static_cast<std::size_t>(taken)},
                              {"share", share},
                              {"share_in_pilots", pilots},
                              {"share_of_cut_stacks", incomplete}}
            << '\n';
}
