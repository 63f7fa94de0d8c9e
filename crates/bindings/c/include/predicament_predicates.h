/*
 * The names of Shewchuk's predicates.c, for programs that move to predicament without a change of their calls.
 *
 * Include this header in place of the declarations of predicates.c, link predicament in place of predicates.c, and keep
 * the calls. Two things differ:
 *
 *   - The result is -1.0, 0.0 or 1.0: the sign of the determinant. In predicates.c it is an approximation of the
 *     determinant. A program that uses the magnitude needs another function for it.
 *   - The sign is right for all finite numbers. In predicates.c determinants may overflow or underflow.
 *
 * NaN or infinity in an argument, or NULL, gives NaN.
 *
 * The names orient2dfast, orient2dexact and orient2dslow, and those of the other predicates, are not here.
 */
#ifndef PREDICAMENT_PREDICATES_H
#define PREDICAMENT_PREDICATES_H

#include <math.h>

#include "predicament.h"

/** Does nothing. The library needs no initialization. */
static inline void exactinit(void) {}

/** The turn pa, pb, pc: 1.0 if counterclockwise, -1.0 if clockwise, 0.0 if the points are on one line. */
static inline double orient2d(const double *pa, const double *pb, const double *pc) {
    int8_t sign;
    return predicament_orient2d(pa, pb, pc, &sign) == PREDICAMENT_OK ? (double)sign : (double)NAN;
}

/** The side of pd on the plane through pa, pb, pc: 1.0 if pd is below, -1.0 if above, 0.0 if on the plane. */
static inline double orient3d(const double *pa, const double *pb, const double *pc, const double *pd) {
    int8_t sign;
    return predicament_orient3d(pa, pb, pc, pd, &sign) == PREDICAMENT_OK ? (double)sign : (double)NAN;
}

/** The place of pd at the circle through pa, pb, pc: 1.0 if inside, -1.0 if outside, 0.0 if on the circle. */
static inline double incircle(const double *pa, const double *pb, const double *pc, const double *pd) {
    int8_t sign;
    return predicament_incircle(pa, pb, pc, pd, &sign) == PREDICAMENT_OK ? (double)sign : (double)NAN;
}

/** The place of pe at the sphere through pa, pb, pc, pd: 1.0 if inside, -1.0 if outside, 0.0 if on the sphere. */
static inline double insphere(const double *pa, const double *pb, const double *pc, const double *pd, const double *pe) {
    int8_t sign;
    return predicament_insphere(pa, pb, pc, pd, pe, &sign) == PREDICAMENT_OK ? (double)sign : (double)NAN;
}

#endif /* PREDICAMENT_PREDICATES_H */
