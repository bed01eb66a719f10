/* The contact law of database/contact_law.h for C and whatever calls C. Link contact_law_c.cc and
   the C++ standard library. Units, conventions and flags are those of the header. */
#ifndef DPCONTACT_DATABASE_CONTACT_LAW_C_H
#define DPCONTACT_DATABASE_CONTACT_LAW_C_H

#include <stddef.h>

#ifdef __cplusplus
extern "C"
{
#endif

  /* Bits of dpcontact_force's flags, ContactFlag of the header. */
  enum
  {
    DPCONTACT_PRESSED       = 1,
    DPCONTACT_LOADING       = 2,
    DPCONTACT_YIELDED       = 4,
    DPCONTACT_STRAIN_LARGE  = 8,
    DPCONTACT_EXTRAPOLATED  = 16,
    DPCONTACT_INPUT_INVALID = 32
  };

  typedef struct dpcontact_law dpcontact_law;

  /* A law from a row of the consistent convention, which belongs to spheres of this R*. NULL where
     a value is out of range; then `message`, of `message_size` characters with the closing 0, says
     which (it may be NULL). */
  dpcontact_law *dpcontact_law_from_row(double a,
                                        double b,
                                        double m,
                                        double n,
                                        double force_yield,
                                        double approach_yield,
                                        double effective_radius,
                                        char  *message,
                                        size_t message_size);

  /* Likewise from a row of the published convention: the yield approach is that of one sphere. */
  dpcontact_law *dpcontact_law_from_published_row(double a,
                                                  double b,
                                                  double m,
                                                  double n,
                                                  double force_yield,
                                                  double approach_yield_of_one_sphere,
                                                  double effective_radius,
                                                  char  *message,
                                                  size_t message_size);

  /* A universal law, with the table read from a CSV file (ContactTable::read). */
  dpcontact_law *dpcontact_law_universal(double      youngs_modulus,
                                         double      poisson_ratio,
                                         double      friction_angle_deg,
                                         double      compressive_strength,
                                         const char *table_file,
                                         char       *message,
                                         size_t      message_size);

  void dpcontact_law_free(dpcontact_law *law); /* NULL is allowed */

  /* R* of two radii. */
  double dpcontact_effective_radius(double radius_1, double radius_2);

  /* The force at this overlap, which follows those before. `peak_overlap` is all that the contact
     remembers: 0 when it begins, kept in restart files. `flags` may be NULL. Safe to call from
     several threads with states of their own. */
  double dpcontact_force(const dpcontact_law *law,
                         double               overlap,
                         double               effective_radius,
                         double              *peak_overlap,
                         unsigned            *flags);

  /* Residual overlap after release from this peak. */
  double dpcontact_residual_overlap(const dpcontact_law *law,
                                    double               peak_overlap,
                                    double               effective_radius);

  /* Stiffness where unloading from this peak begins, the largest that the contact has. */
  double
  dpcontact_stiffness(const dpcontact_law *law, double peak_overlap, double effective_radius);

#ifdef __cplusplus
}
#endif

#endif
