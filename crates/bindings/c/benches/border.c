/*
 * The price of a call from C: loops over uniform points, timed. border.rs has the same loops in Rust, starts this
 * program, and prints both.
 */
#define _POSIX_C_SOURCE 199309L
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "predicament.h"

#define POINTS 1000000

static uint64_t state = 1;

/* SplitMix64. */
static double unit(void) {
    uint64_t x = state += 0x9e3779b97f4a7c15u;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return (double)((x ^ x >> 31) >> 11) * 0x1p-53;
}

static double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec * 1e9 + (double)time.tv_nsec;
}

static double p2[POINTS][2], p3[POINTS][3];
static uint32_t ids[POINTS * 5];
static int8_t signs[POINTS];

static void say(const char *name, double start, size_t queries, long sum) {
    printf("%s %.3f %ld\n", name, (now() - start) / (double)queries, sum);
}

/* The indices of queries of neighbours in the list; returns their number. */
static size_t neighbours(size_t arity) {
    size_t at, corner, queries = POINTS - arity + 1;
    for (at = 0; at < queries; at++) {
        for (corner = 0; corner < arity; corner++) {
            ids[at * arity + corner] = (uint32_t)(at + corner);
        }
    }
    return queries;
}

static long total(size_t queries) {
    long sum = 0;
    size_t at;
    for (at = 0; at < queries; at++) {
        sum += signs[at];
    }
    return sum;
}

#define SINGLE(name, arity, call)                                                                                      \
    do {                                                                                                               \
        long sum = 0;                                                                                                  \
        size_t i, queries = POINTS - (arity) + 1;                                                                      \
        double start = now();                                                                                          \
        for (i = 0; i < queries; i++) {                                                                                \
            int8_t sign = 0;                                                                                           \
            call;                                                                                                      \
            sum += sign;                                                                                               \
        }                                                                                                              \
        say("single " name, start, queries, sum);                                                                      \
    } while (0)

#define MANY(name, arity, call)                                                                                        \
    do {                                                                                                               \
        size_t queries = neighbours(arity);                                                                            \
        double start = now();                                                                                          \
        if ((call) != PREDICAMENT_OK) {                                                                                \
            return EXIT_FAILURE;                                                                                       \
        }                                                                                                              \
        say(name, start, queries, total(queries));                                                                     \
    } while (0)

int main(void) {
    predicament_scene *flat = NULL, *solid = NULL;
    size_t at;
    for (at = 0; at < POINTS; at++) {
        p2[at][0] = unit();
        p2[at][1] = unit();
    }
    for (at = 0; at < POINTS; at++) {
        p3[at][0] = unit();
        p3[at][1] = unit();
        p3[at][2] = unit();
    }
    if (predicament_scene_new(p2[0], POINTS, sizeof *p2, 2, PREDICAMENT_EXACT, &flat, NULL) != PREDICAMENT_OK ||
        predicament_scene_new(p3[0], POINTS, sizeof *p3, 3, PREDICAMENT_EXACT, &solid, NULL) != PREDICAMENT_OK) {
        return EXIT_FAILURE;
    }
    SINGLE("orient2d", 3, predicament_orient2d(p2[i], p2[i + 1], p2[i + 2], &sign));
    SINGLE("orient3d", 4, predicament_orient3d(p3[i], p3[i + 1], p3[i + 2], p3[i + 3], &sign));
    SINGLE("incircle", 4, predicament_incircle(p2[i], p2[i + 1], p2[i + 2], p2[i + 3], &sign));
    SINGLE("insphere", 5, predicament_insphere(p3[i], p3[i + 1], p3[i + 2], p3[i + 3], p3[i + 4], &sign));
    MANY("array orient2d", 3, predicament_orient2d_batch(p2[0], POINTS, sizeof *p2, ids, queries, signs, NULL));
    MANY("array orient3d", 4, predicament_orient3d_batch(p3[0], POINTS, sizeof *p3, ids, queries, signs, NULL));
    MANY("array incircle", 4, predicament_incircle_batch(p2[0], POINTS, sizeof *p2, ids, queries, signs, NULL));
    MANY("array insphere", 5, predicament_insphere_batch(p3[0], POINTS, sizeof *p3, ids, queries, signs, NULL));
    MANY("scene orient2d", 3, predicament_scene_orient2d_batch(flat, PREDICAMENT_XY, ids, queries, signs, NULL));
    MANY("scene orient3d", 4, predicament_scene_orient3d_batch(solid, ids, queries, signs, NULL));
    MANY("scene incircle", 4, predicament_scene_incircle_batch(flat, ids, queries, signs, NULL));
    MANY("scene insphere", 5, predicament_scene_insphere_batch(solid, ids, queries, signs, NULL));
    predicament_scene_free(flat);
    predicament_scene_free(solid);
    return EXIT_SUCCESS;
}
