/* Signs of single queries and of arrays, a prepared scene, and constructed vertices. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "predicament.h"

/* Ends the program if a call failed. */
static void must(predicament_result result, const char *call) {
    if (result != PREDICAMENT_OK) {
        fprintf(stderr, "%s: %s\n", call, predicament_result_text(result));
        exit(EXIT_FAILURE);
    }
}

/* Vertices of a program have other data beside their coordinates. */
struct vertex {
    double xyz[3];
    float colour[3];
    int layer;
};

static void single(void) {
    const double a[2] = {0.5, 0x1.0000000000001p-1}, b[2] = {12, 12}, c[2] = {24, 24};
    const float e[2] = {0, 0}, f[2] = {1, 0}, g[2] = {0, 1};
    const int32_t p[2] = {-2147483647, -2147483647}, q[2] = {0, 0}, r[2] = {2147483647, 2147483646};
    int8_t sign = 0;
    must(predicament_orient2d(a, b, c, &sign), "orient2d");
    printf("orient2d of doubles: %d\n", sign);
    must(predicament_orient2d_f32(e, f, g, &sign), "orient2d_f32");
    printf("orient2d of floats: %d\n", sign);
    must(predicament_orient2d_i32(p, q, r, &sign), "orient2d_i32");
    printf("orient2d of integers: %d\n", sign);
    must(predicament_compare(PREDICAMENT_Y, a, b, &sign), "compare");
    printf("compare: %d\n", sign);
}

static void arrays(void) {
    /* The corners of a cube, and its centre. */
    struct vertex vertices[9] = {{{0, 0, 0}, {0, 0, 0}, 0}};
    const uint32_t spheres[3][5] = {{0, 1, 2, 4, 7}, {0, 1, 2, 4, 8}, {1, 0, 2, 4, 8}};
    const uint32_t planes[2][4] = {{0, 1, 2, 3}, {0, 1, 2, 4}};
    int8_t signs[3] = {0, 0, 0};
    size_t bad = 0, at;
    predicament_result result;
    for (at = 0; at < 8; at++) {
        vertices[at].xyz[0] = (double)(at & 1);
        vertices[at].xyz[1] = (double)(at >> 1 & 1);
        vertices[at].xyz[2] = (double)(at >> 2 & 1);
    }
    vertices[8].xyz[0] = vertices[8].xyz[1] = vertices[8].xyz[2] = 0.5;
    must(predicament_orient3d_batch(vertices[0].xyz, 9, sizeof *vertices, planes[0], 2, signs, &bad), "orient3d_batch");
    printf("orient3d of an array: %d %d\n", signs[0], signs[1]);
    must(predicament_insphere_batch(vertices[0].xyz, 9, sizeof *vertices, spheres[0], 3, signs, &bad), "insphere_batch");
    printf("insphere of an array: %d %d %d\n", signs[0], signs[1], signs[2]);
    vertices[8].xyz[1] = NAN;
    result = predicament_insphere_batch(vertices[0].xyz, 9, sizeof *vertices, spheres[0], 3, signs, &bad);
    printf("insphere with NaN: %s (query %lu)\n", predicament_result_text(result), (unsigned long)bad);
}

static void scene(void) {
    /* Two squares side by side. Their diagonals meet in 2 points. */
    const double points[6][2] = {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}};
    const uint32_t diagonals[3][4] = {{0, 4, 1, 3}, {1, 5, 2, 4}, {0, 1, 3, 4}};
    const uint32_t turns[2][3] = {{0, 1, 2}, {0, 2, 4}};
    uint32_t centres[3] = {0, 0, 0};
    int8_t signs[2] = {0, 0}, sign = 0;
    size_t bad = 0;
    int32_t backend;
    for (backend = PREDICAMENT_EXACT; backend <= PREDICAMENT_SOS; backend++) {
        predicament_scene *scene = NULL;
        must(predicament_scene_new(points[0], 6, sizeof *points, 2, backend, &scene, &bad), "scene_new");
        must(predicament_scene_orient2d_batch(scene, PREDICAMENT_XY, turns[0], 2, signs, &bad), "scene_orient2d_batch");
        printf("%s: orient2d %d %d", backend == PREDICAMENT_EXACT ? "exact" : "sos", signs[0], signs[1]);
        /* The last definition names parallel lines. */
        printf(", %s", predicament_result_text(predicament_scene_add_ssi(scene, diagonals[0], 3, centres, &bad)));
        printf(" (definition %lu)", (unsigned long)bad);
        must(predicament_scene_add_ssi(scene, diagonals[0], 2, centres, &bad), "scene_add_ssi");
        must(predicament_scene_compare(scene, PREDICAMENT_X, centres[0], centres[1], &sign), "scene_compare");
        printf(", compare of centres %d", sign);
        must(predicament_scene_orient2d(scene, PREDICAMENT_XY, 0, 4, centres[0], &sign), "scene_orient2d");
        printf(", centre on its diagonal %d\n", sign);
        predicament_scene_free(scene);
    }
}

/* Integers of 64 bits: three corners of a square far away, and a scene that is too wide. */
static void integers(void) {
    const int64_t far = INT64_C(9007199254740993); /* 2^53 + 1 is not a double */
    const int64_t points[4][2] = {{far, -far}, {far + 1, -far}, {far + 1, 1 - far}, {0, 0}};
    const int64_t wide[2][2] = {{INT64_MIN, 0}, {INT64_MAX, 0}};
    predicament_scene *scene = NULL;
    predicament_result result;
    int8_t sign = 0;
    size_t bad = 0;
    must(predicament_scene_new_i64(points[0], 4, sizeof *points, 2, PREDICAMENT_EXACT, &scene, &bad), "scene_new_i64");
    must(predicament_scene_orient2d(scene, PREDICAMENT_XY, 0, 1, 2, &sign), "scene_orient2d");
    printf("orient2d in a scene of 64-bit integers: %d\n", sign);
    predicament_scene_free(scene);
    result = predicament_scene_new_i64(wide[0], 2, sizeof *wide, 2, PREDICAMENT_EXACT, &scene, &bad);
    printf("too wide: %s (point %lu)\n", predicament_result_text(result), (unsigned long)bad);
}

int main(void) {
    printf("predicament %s, header %s\n", predicament_version(), PREDICAMENT_VERSION);
    single();
    arrays();
    scene();
    integers();
    return EXIT_SUCCESS;
}
