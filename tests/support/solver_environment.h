#ifndef DPCONTACT_TESTS_SUPPORT_SOLVER_ENVIRONMENT_H
#define DPCONTACT_TESTS_SUPPORT_SOLVER_ENVIRONMENT_H

#include "solver/parallel/environment.h"

#include <gtest/gtest.h>

#include <memory>

namespace dpcontact::tests
{
  /// Keeps the solver's libraries started while a test program runs. Once a program:
  /// `const auto *const solver = SolverEnvironment::install();`
  class SolverEnvironment : public ::testing::Environment
  {
  public:
    static const ::testing::Environment *install()
    {
      return ::testing::AddGlobalTestEnvironment(new SolverEnvironment);
    }
    void SetUp() override { environment = std::make_unique<dpcontact::Environment>(); }
    void TearDown() override { environment.reset(); }

  private:
    std::unique_ptr<dpcontact::Environment> environment;
  };
} // namespace dpcontact::tests

#endif
