/* The contact law of contact_law.h for C and whatever calls C. Copy contact_law.h, contact_law_c.h
   and contact_law_c.cc into one folder, and link contact_law_c.cc and the C++ standard library.
   Units, conventions and flags are those of contact_law.h. There is no global state: laws may be
   used from several threads, as long as each contact is computed by one thread at a time. */
#ifndef DPCONTACT_DATABASE_CONTACT_LAW_CONTACT_LAW_C_H
#define DPCONTACT_DATABASE_CONTACT_LAW_CONTACT_LAW_C_H

#include <stddef.h>

#ifdef __cplusplus
extern "C"
{
#endif

  /* Bits of dpcontact_force's flags: ContactFlag of contact_law.h says what they mean. */
  enum
  {
    DPCONTACT_PRESSED       = 1,
    DPCONTACT_LOADING       = 2,
    DPCONTACT_YIELDED       = 4,
    DPCONTACT_STRAIN_LARGE  = 8,
    DPCONTACT_EXTRAPOLATED  = 16,
    DPCONTACT_INPUT_INVALID = 32
  };

  /* A law of one material. Whoever makes one frees it. */
  typedef struct dpcontact_law dpcontact_law;

  /* The functions that make a law give NULL where a value is out of range or a table cannot be
     read. Then `message`, which has room for `message_size` characters with the closing 0, says
     what was wrong; `message` may be NULL. */

  /* The law of a row in the consistent convention (ContactRow), whose F_y and delta_y belong to
     spheres of this R*. */
  dpcontact_law *dpcontact_law_from_row(double a,
                                        double b,
                                        double m,
                                        double n,
                                        double force_yield,
                                        double approach_yield,
                                        double effective_radius,
                                        char  *message,
                                        size_t message_size);

  /* The law of a row in the published convention (ContactRow::published), whose yield approach is
     that of one sphere. */
  dpcontact_law *dpcontact_law_from_published_row(double a,
                                                  double b,
                                                  double m,
                                                  double n,
                                                  double force_yield,
                                                  double approach_yield_of_one_sphere,
                                                  double effective_radius,
                                                  char  *message,
                                                  size_t message_size);

  /* The universal law of a material (ContactMaterial), with the table read from a CSV file
     (ContactTable::read). The friction angle is in degrees. */
  dpcontact_law *dpcontact_law_universal(double      youngs_modulus,
                                         double      poisson_ratio,
                                         double      friction_angle_deg,
                                         double      compressive_strength,
                                         const char *table_file,
                                         char       *message,
                                         size_t      message_size);

  /* Frees a law, which must not be used afterwards. NULL is allowed. */
  void dpcontact_law_free(dpcontact_law *law);

  /* R* = R1 R2/(R1 + R2) of two radii. */
  double dpcontact_effective_radius(double radius_1, double radius_2);

  /* The force at this overlap, which follows those before. `peak_overlap` is all that the contact
     remembers: it is 0 when a contact begins, the call updates it, and a restart file must keep it.
     `flags` may be NULL. */
  double dpcontact_force(const dpcontact_law *law,
                         double               overlap,
                         double               effective_radius,
                         double              *peak_overlap,
                         unsigned            *flags);

  /* The residual overlap after release from this peak, at which the force has become 0. */
  double dpcontact_residual_overlap(const dpcontact_law *law,
                                    double               peak_overlap,
                                    double               effective_radius);

  /* dF/d(overlap) where unloading from this peak begins: the largest stiffness of the contact. */
  double
  dpcontact_stiffness(const dpcontact_law *law, double peak_overlap, double effective_radius);

#ifdef __cplusplus
}
#endif

#endif
