#ifndef DPCONTACT_TESTS_SUPPORT_FLOATING_POINT_TRAPS_H
#define DPCONTACT_TESTS_SUPPORT_FLOATING_POINT_TRAPS_H

#include <gtest/gtest.h>

#include <cfenv>

namespace dpcontact::tests
{
  /// While a test program runs, an invalid operation, a division by zero or an overflow ends it
  /// with SIGFPE. Once a program: `const auto *const traps = FloatingPointTraps::install();`
  class FloatingPointTraps : public ::testing::Environment
  {
  public:
    static const ::testing::Environment *install()
    {
      return ::testing::AddGlobalTestEnvironment(new FloatingPointTraps);
    }

    void SetUp() override
    {
      std::feclearexcept(FE_ALL_EXCEPT);
      before = feenableexcept(trapped);
      ASSERT_EQ(fegetexcept() & trapped, trapped) << "this machine cannot trap";
    }

    void TearDown() override
    {
      std::feclearexcept(FE_ALL_EXCEPT);
      fedisableexcept(trapped & ~before);
    }

  private:
    static constexpr int trapped = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
    int                  before  = 0;
  };
} // namespace dpcontact::tests

#endif
