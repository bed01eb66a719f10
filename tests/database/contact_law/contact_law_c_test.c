/* The C interface, from C. Ends with 0 where everything holds. */
#include "database/contact_law/contact_law_c.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static int failures = 0;

static void expect(int holds, const char *what)
{
  if (!holds)
    {
      printf("FAILED: %s\n", what);
      ++failures;
    }
}

static void rows(void)
{
  char     message[200] = "";
  double   peak = 0, again = 0;
  unsigned flags  = 0;
  double   radius = dpcontact_effective_radius(0.1, 0.1);

  dpcontact_law *law = dpcontact_law_from_row(
    1.0148, 1.4729, 1.1829, 1.4643, 9.056, 3.2792e-6, radius, message, sizeof message);
  dpcontact_law *published = dpcontact_law_from_published_row(1.0148 * pow(2, -1.4729),
                                                              1.4729,
                                                              1.1829 * pow(2, -1.4643),
                                                              1.4643,
                                                              9.056,
                                                              1.6396e-6,
                                                              radius,
                                                              message,
                                                              sizeof message);
  double         up, down, residual;
  expect(law != NULL && published != NULL && message[0] == '\0', "rows are accepted");
  up = dpcontact_force(law, 1.66e-5, radius, &peak, &flags);
  expect(fabs(up / (9.056 * 1.0148 * pow(1.66e-5 / 3.2792e-6, 1.4729)) - 1) < 1e-12, "eq (16)");
  expect(flags == (DPCONTACT_PRESSED | DPCONTACT_LOADING | DPCONTACT_YIELDED), "flags of loading");
  expect(peak == 1.66e-5, "the peak is remembered");
  residual = dpcontact_residual_overlap(law, peak, radius);
  down     = dpcontact_force(law, 1e-5, radius, &peak, NULL);
  expect(fabs(down / (9.056 * 1.1829 * pow((1e-5 - residual) / 3.2792e-6, 1.4643)) - 1) < 1e-9,
         "eq (17)");
  dpcontact_force(published, 1.66e-5, radius, &again, NULL);
  expect(fabs(dpcontact_force(published, 1e-5, radius, &again, NULL) / down - 1) < 1e-12,
         "the published convention");
  expect(dpcontact_force(law, 0.9 * residual, radius, &peak, &flags) == 0, "separation");
  expect(flags == DPCONTACT_YIELDED, "flags of separation");
  expect(dpcontact_force(law, NAN, radius, &peak, &flags) == 0 && flags == DPCONTACT_INPUT_INVALID,
         "NaN is flagged");
  expect(peak == 1.66e-5, "and leaves the state alone");
  expect(fabs(dpcontact_stiffness(law, peak, radius) * (peak - residual) / (1.4643 * up) - 1) <
           1e-12,
         "stiffness");
  dpcontact_law_free(law);
  dpcontact_law_free(published);
  dpcontact_law_free(NULL);

  law = dpcontact_law_from_row(1, 1.5, -1, 1.5, 1, 1e-6, radius, message, sizeof message);
  expect(law == NULL && strstr(message, "m is -1") != NULL, "a bad row is refused");
  law = dpcontact_law_from_row(1, 1.5, -1, 1.5, 1, 1e-6, radius, message, 8);
  expect(law == NULL && strlen(message) == 7, "the message is cut to its size");
  expect(dpcontact_law_from_row(1, 1.5, -1, 1.5, 1, 1e-6, radius, NULL, 0) == NULL, "no message");
}

static void universal(const char *table)
{
  char           message[200] = "";
  double         peak         = 0;
  dpcontact_law *law =
    dpcontact_law_universal(10e9, 0.15, 25, 15e6, table, message, sizeof message);
  expect(law != NULL, message);
  /* dpcontact solve: 100 N at this approach; a coarse table's 0.3 %. */
  expect(law != NULL && fabs(dpcontact_force(law, 1.6602e-5, 0.05, &peak, NULL) / 100 - 1) < 3e-3,
         "the universal law");
  dpcontact_law_free(law);
  law = dpcontact_law_universal(10e9, 0.15, 25, 15e6, "nowhere.csv", message, sizeof message);
  expect(law == NULL && strstr(message, "nowhere.csv") != NULL, "a missing table is named");
  law = dpcontact_law_universal(10e9, 0.6, 25, 15e6, table, message, sizeof message);
  expect(law == NULL && strstr(message, "Poisson") != NULL, "a bad material is refused");
}

int main(int argc, char **argv)
{
  rows();
  if (argc > 1)
    universal(argv[1]);
  else
    expect(0, "usage: contact_law_c_test TABLE.csv");
  if (failures == 0)
    printf("the C interface holds\n");
  return failures;
}
