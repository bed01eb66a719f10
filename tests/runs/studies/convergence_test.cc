#include "runs/studies/convergence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
  using namespace dpcontact;

  TEST(Convergence, richardson_finds_limit_and_order_of_a_clean_series)
  {
    for (const double order : {1., 1.5, 2., 3.})
      {
        const auto value = [order](const double h) { return 2 - 0.3 * std::pow(h, order); };
        const auto [limit, found] = richardson(value(1), value(0.5), value(0.25));
        EXPECT_NEAR(limit, 2, 1e-13);
        EXPECT_NEAR(found, order, 1e-12);
      }
  }

  TEST(Convergence, richardson_keeps_the_finest_value_of_a_series_that_is_not_clean)
  {
    const double series[][3] = {{1, 1.1, 1.05}, // turns round
                                {1, 1.1, 1.2},  // does not settle
                                {1, 1.1, 1.1},  // has settled
                                {1, 1, 1}};
    for (const auto &values : series)
      {
        const auto [limit, order] = richardson(values[0], values[1], values[2]);
        EXPECT_EQ(limit, values[2]);
        EXPECT_TRUE(std::isnan(order));
      }
  }
} // namespace
