/* A program that was written for Shewchuk's predicates.c. Only the include has changed. */
#include <stdio.h>

#include "predicament_predicates.h"

int main(void) {
    double pa[2] = {0, 0}, pb[2] = {1e-200, 0}, pc[2] = {0, 1e-200}, pd[2] = {1e-200, 1e-200};
    double qa[3] = {0, 0, 0}, qb[3] = {1, 0, 0}, qc[3] = {0, 1, 0}, qd[3] = {0, 0, 1}, qe[3] = {0.25, 0.25, 0.25};
    exactinit();
    /* A triangle of this size has a determinant that is smaller than any double. */
    printf("orient2d %.0f\n", orient2d(pa, pb, pc));
    printf("incircle %.0f\n", incircle(pa, pb, pc, pd));
    printf("orient3d %.0f\n", orient3d(qa, qb, qc, qd));
    printf("insphere %.0f\n", insphere(qa, qc, qb, qd, qe));
    pa[0] = NAN;
    printf("NaN is %s\n", isnan(orient2d(pa, pb, pc)) ? "NaN" : "a sign");
    return 0;
}
