/*
 * The predicates of predicament for C and C++: exact signs of geometric determinants.
 *
 * Signs. A sign is -1, 0 or 1: the sign of the real determinant of the given numbers, without rounding. Overflow and
 * underflow do not happen. A scene of PREDICAMENT_SOS answers 1 or -1 where the determinant is 0.
 *
 * Results. Functions return a predicament_result. An output is written only if the result is PREDICAMENT_OK, unless the
 * comment of the function says otherwise.
 *
 * Ownership. The library borrows every pointer for the duration of the call, and keeps none. It owns what it returns: a
 * scene until predicament_scene_free(), strings for ever.
 *
 * Threads. Functions without a scene may run in any number of threads. Threads may query one scene at the same time. While
 * a function adds vertices to a scene or frees it, no other function may run on this scene.
 *
 * Errors. No function throws, exits or sets errno. The process ends if the system has not enough memory.
 *
 * This file is made by cbindgen; do not edit it.
 */

#ifndef PREDICAMENT_H
#define PREDICAMENT_H

#include <stddef.h>
#include <stdint.h>

/** The version of this header. */
#define PREDICAMENT_VERSION "0.1.0"

/** The bit that the ids of constructed vertices have, and the indices of points do not have. */
#define PREDICAMENT_CONSTRUCTED UINT32_C(0x80000000)

/**
 * The result of a call. Every function that returns one writes its outputs only if it returns PREDICAMENT_OK, unless
 * its comment says otherwise.
 */
typedef enum {
    /**
     * The call has done what it says.
     */
    PREDICAMENT_OK = 0,
    /**
     * A pointer is NULL that must not be NULL.
     */
    PREDICAMENT_NULL = 1,
    /**
     * A pointer to indices, definitions or vertices is not a multiple of four.
     */
    PREDICAMENT_MISALIGNED = 2,
    /**
     * A coordinate is NaN or infinite.
     */
    PREDICAMENT_NOT_FINITE = 3,
    /**
     * An index is not below the number of points, or names a constructed vertex that does not exist.
     */
    PREDICAMENT_INDEX = 4,
    /**
     * An axis, a plane, a dimension, a backend or a stride is not one that the function takes.
     */
    PREDICAMENT_ARGUMENT = 5,
    /**
     * A size is larger than the address space, or a scene has more than 2^31 points or constructed vertices.
     */
    PREDICAMENT_TOO_MANY = 6,
    /**
     * The scene does not answer this predicate or take this vertex: its dimension is another one, or its backend
     * refuses.
     */
    PREDICAMENT_UNSUPPORTED = 7,
    /**
     * A definition names a vertex twice in one line or plane.
     */
    PREDICAMENT_REPEATED = 8,
    /**
     * The lines and planes of a definition do not meet in a single point.
     */
    PREDICAMENT_NO_POINT = 9,
    /**
     * An internal error. The library has a defect; please report it. A scene that was being changed answers nothing
     * any more and can only be freed.
     */
    PREDICAMENT_INTERNAL = 10,
    /**
     * The 64-bit integers along one axis of a scene span more than 2^54 times the largest power of two that divides
     * all their differences.
     */
    PREDICAMENT_RANGE = 11,
} predicament_result;

/**
 * A coordinate axis.
 */
typedef enum {
    /**
     * The first coordinate.
     */
    PREDICAMENT_X = 0,
    /**
     * The second coordinate.
     */
    PREDICAMENT_Y = 1,
    /**
     * The third coordinate.
     */
    PREDICAMENT_Z = 2,
} predicament_axis;

/**
 * The two coordinates that orient2d uses of a point in space. A scene of the plane has PREDICAMENT_XY only.
 */
typedef enum {
    /**
     * The coordinates x and y.
     */
    PREDICAMENT_XY = 0,
    /**
     * The coordinates y and z.
     */
    PREDICAMENT_YZ = 1,
    /**
     * The coordinates z and x.
     */
    PREDICAMENT_ZX = 2,
} predicament_plane;

/**
 * The meaning of the signs of a scene.
 */
typedef enum {
    /**
     * The sign of the real determinant. Zero means exactly zero.
     */
    PREDICAMENT_EXACT = 0,
    /**
     * Simulation of Simplicity: ties are broken consistently, as if each vertex had moved by its own infinitesimal.
     * A sign about distinct input vertices is never zero. A vertex is identified by its index.
     */
    PREDICAMENT_SOS = 1,
} predicament_backend;

/**
 * The points of one scene, prepared for many queries, and the vertices that were constructed from them.
 *
 * The program owns a scene from predicament_scene_new() to predicament_scene_free(). Threads may query one scene at
 * the same time. While a thread adds vertices to it or frees it, no other thread may use it.
 */
typedef struct predicament_scene predicament_scene;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

/**
 * The version of the library, such as "0.1.0". PREDICAMENT_VERSION is the version of the header.
 *
 * @return a string that is never freed
 */
const char *predicament_version(void);

/**
 * The meaning of a result code, in a few words of English.
 *
 * @param result  a value of predicament_result, or any other number
 * @return a string that is never freed
 */
const char *predicament_result_text(int32_t result);

/**
 * The order of two points along an axis: the sign of a's coordinate minus b's.
 *
 * @param axis  a predicament_axis
 * @param a, b  the points: as many coordinates each as the axis needs; only the coordinate on the axis is read
 * @param sign  receives -1, 0 or 1
 * @return PREDICAMENT_OK, PREDICAMENT_NULL, PREDICAMENT_NOT_FINITE, or PREDICAMENT_ARGUMENT for another axis
 *
 * The pointers are borrowed for the call. Any thread may call at any time.
 */
predicament_result predicament_compare(int32_t axis,
                                       const double *a,
                                       const double *b,
                                       int8_t *sign);

/**
 * The turn a, b, c in the plane: 1 if counterclockwise, -1 if clockwise, 0 if the points are on one line.
 *
 * @param a, b, c  the points: two coordinates each
 * @param sign  receives -1, 0 or 1
 * @return PREDICAMENT_OK, PREDICAMENT_NULL or PREDICAMENT_NOT_FINITE
 *
 * The pointers are borrowed for the call. Any thread may call at any time.
 */
predicament_result predicament_orient2d(const double *a,
                                        const double *b,
                                        const double *c,
                                        int8_t *sign);

/**
 * The side of d on the plane through a, b, c: 1 if d is below, -1 if above, 0 if on the plane.
 *
 * Above is the side from which a, b, c are seen counterclockwise.
 *
 * @param a, b, c, d  the points: three coordinates each
 * @param sign  receives -1, 0 or 1
 * @return PREDICAMENT_OK, PREDICAMENT_NULL or PREDICAMENT_NOT_FINITE
 *
 * The pointers are borrowed for the call. Any thread may call at any time.
 */
predicament_result predicament_orient3d(const double *a,
                                        const double *b,
                                        const double *c,
                                        const double *d,
                                        int8_t *sign);

/**
 * The place of d at the circle through a, b, c: 1 if inside, -1 if outside, 0 if on the circle.
 *
 * This holds if a, b, c turn counterclockwise; otherwise the sign is the opposite.
 *
 * @param a, b, c, d  the points: two coordinates each
 * @param sign  receives -1, 0 or 1
 * @return PREDICAMENT_OK, PREDICAMENT_NULL or PREDICAMENT_NOT_FINITE
 *
 * The pointers are borrowed for the call. Any thread may call at any time.
 */
predicament_result predicament_incircle(const double *a,
                                        const double *b,
                                        const double *c,
                                        const double *d,
                                        int8_t *sign);

/**
 * The place of e at the sphere through a, b, c, d: 1 if inside, -1 if outside, 0 if on the sphere.
 *
 * This holds if predicament_orient3d() of a, b, c, d is 1; otherwise the sign is the opposite.
 *
 * @param a, b, c, d, e  the points: three coordinates each
 * @param sign  receives -1, 0 or 1
 * @return PREDICAMENT_OK, PREDICAMENT_NULL or PREDICAMENT_NOT_FINITE
 *
 * The pointers are borrowed for the call. Any thread may call at any time.
 */
predicament_result predicament_insphere(const double *a,
                                        const double *b,
                                        const double *c,
                                        const double *d,
                                        const double *e,
                                        int8_t *sign);

/**
 * predicament_compare() for many queries about the points of one array.
 *
 * @param axis  a predicament_axis
 * @param points  the points: as many coordinates each as the axis needs
 * @param count  the number of points
 * @param stride  the distance from one point to the next in bytes; at least the size of a point
 * @param indices  two indices of points for each query, below count
 * @param queries  the number of queries
 * @param signs  receives -1, 0 or 1 for each query; must not overlap the other arrays
 * @param bad  receives the index of the bad query after a failure; may be NULL
 * @return PREDICAMENT_OK; PREDICAMENT_INDEX or PREDICAMENT_NOT_FINITE for the first bad query: the signs of the
 * queries before it are written; PREDICAMENT_NULL, PREDICAMENT_MISALIGNED, PREDICAMENT_ARGUMENT or
 * PREDICAMENT_TOO_MANY
 *
 * The arrays are borrowed for the call. Any thread may call at any time. For many queries about the same points,
 * predicament_scene_compare_batch() is faster.
 */
predicament_result predicament_compare_batch(int32_t axis,
                                             const double *points,
                                             size_t count,
                                             size_t stride,
                                             const uint32_t *indices,
                                             size_t queries,
                                             int8_t *signs,
                                             size_t *bad);

/**
 * predicament_orient2d() for many queries about the points of one array.
 *
 * @param points  the points: two coordinates each, one after another
 * @param count  the number of points
 * @param stride  the distance from one point to the next in bytes; at least the size of a point
 * @param indices  three indices of points for each query, below count
 * @param queries  the number of queries
 * @param signs  receives -1, 0 or 1 for each query; must not overlap the other arrays
 * @param bad  receives the index of the bad query after a failure; may be NULL
 * @return PREDICAMENT_OK; PREDICAMENT_INDEX or PREDICAMENT_NOT_FINITE for the first bad query: the signs of the
 * queries before it are written; PREDICAMENT_NULL, PREDICAMENT_MISALIGNED, PREDICAMENT_ARGUMENT or
 * PREDICAMENT_TOO_MANY
 *
 * The arrays are borrowed for the call. Any thread may call at any time. For many queries about the same points,
 * predicament_scene_orient2d_batch() is faster.
 */
predicament_result predicament_orient2d_batch(const double *points,
                                              size_t count,
                                              size_t stride,
                                              const uint32_t *indices,
                                              size_t queries,
                                              int8_t *signs,
                                              size_t *bad);

/**
 * predicament_orient3d() for many queries about the points of one array.
 *
 * @param points  the points: three coordinates each, one after another
 * @param count  the number of points
 * @param stride  the distance from one point to the next in bytes; at least the size of a point
 * @param indices  four indices of points for each query, below count
 * @param queries  the number of queries
 * @param signs  receives -1, 0 or 1 for each query; must not overlap the other arrays
 * @param bad  receives the index of the bad query after a failure; may be NULL
 * @return PREDICAMENT_OK; PREDICAMENT_INDEX or PREDICAMENT_NOT_FINITE for the first bad query: the signs of the
 * queries before it are written; PREDICAMENT_NULL, PREDICAMENT_MISALIGNED, PREDICAMENT_ARGUMENT or
 * PREDICAMENT_TOO_MANY
 *
 * The arrays are borrowed for the call. Any thread may call at any time. For many queries about the same points,
 * predicament_scene_orient3d_batch() is faster.
 */
predicament_result predicament_orient3d_batch(const double *points,
                                              size_t count,
                                              size_t stride,
                                              const uint32_t *indices,
                                              size_t queries,
                                              int8_t *signs,
                                              size_t *bad);

/**
 * predicament_incircle() for many queries about the points of one array.
 *
 * @param points  the points: two coordinates each, one after another
 * @param count  the number of points
 * @param stride  the distance from one point to the next in bytes; at least the size of a point
 * @param indices  four indices of points for each query, below count
 * @param queries  the number of queries
 * @param signs  receives -1, 0 or 1 for each query; must not overlap the other arrays
 * @param bad  receives the index of the bad query after a failure; may be NULL
 * @return PREDICAMENT_OK; PREDICAMENT_INDEX or PREDICAMENT_NOT_FINITE for the first bad query: the signs of the
 * queries before it are written; PREDICAMENT_NULL, PREDICAMENT_MISALIGNED, PREDICAMENT_ARGUMENT or
 * PREDICAMENT_TOO_MANY
 *
 * The arrays are borrowed for the call. Any thread may call at any time. For many queries about the same points,
 * predicament_scene_incircle_batch() is faster.
 */
predicament_result predicament_incircle_batch(const double *points,
                                              size_t count,
                                              size_t stride,
                                              const uint32_t *indices,
                                              size_t queries,
                                              int8_t *signs,
                                              size_t *bad);

/**
 * predicament_insphere() for many queries about the points of one array.
 *
 * @param points  the points: three coordinates each, one after another
 * @param count  the number of points
 * @param stride  the distance from one point to the next in bytes; at least the size of a point
 * @param indices  five indices of points for each query, below count
 * @param queries  the number of queries
 * @param signs  receives -1, 0 or 1 for each query; must not overlap the other arrays
 * @param bad  receives the index of the bad query after a failure; may be NULL
 * @return PREDICAMENT_OK; PREDICAMENT_INDEX or PREDICAMENT_NOT_FINITE for the first bad query: the signs of the
 * queries before it are written; PREDICAMENT_NULL, PREDICAMENT_MISALIGNED, PREDICAMENT_ARGUMENT or
 * PREDICAMENT_TOO_MANY
 *
 * The arrays are borrowed for the call. Any thread may call at any time. For many queries about the same points,
 * predicament_scene_insphere_batch() is faster.
 */
predicament_result predicament_insphere_batch(const double *points,
                                              size_t count,
                                              size_t stride,
                                              const uint32_t *indices,
                                              size_t queries,
                                              int8_t *signs,
                                              size_t *bad);

/**
 * The same as predicament_compare(), for points of floats.
 *
 * @copydetails predicament_compare
 */
predicament_result predicament_compare_f32(int32_t axis,
                                           const float *a,
                                           const float *b,
                                           int8_t *sign);

/**
 * The same as predicament_orient2d(), for points of floats.
 *
 * @copydetails predicament_orient2d
 */
predicament_result predicament_orient2d_f32(const float *a,
                                            const float *b,
                                            const float *c,
                                            int8_t *sign);

/**
 * The same as predicament_orient3d(), for points of floats.
 *
 * @copydetails predicament_orient3d
 */
predicament_result predicament_orient3d_f32(const float *a,
                                            const float *b,
                                            const float *c,
                                            const float *d,
                                            int8_t *sign);

/**
 * The same as predicament_incircle(), for points of floats.
 *
 * @copydetails predicament_incircle
 */
predicament_result predicament_incircle_f32(const float *a,
                                            const float *b,
                                            const float *c,
                                            const float *d,
                                            int8_t *sign);

/**
 * The same as predicament_insphere(), for points of floats.
 *
 * @copydetails predicament_insphere
 */
predicament_result predicament_insphere_f32(const float *a,
                                            const float *b,
                                            const float *c,
                                            const float *d,
                                            const float *e,
                                            int8_t *sign);

/**
 * The same as predicament_compare_batch(), for points of floats.
 *
 * @copydetails predicament_compare_batch
 */
predicament_result predicament_compare_batch_f32(int32_t axis,
                                                 const float *points,
                                                 size_t count,
                                                 size_t stride,
                                                 const uint32_t *indices,
                                                 size_t queries,
                                                 int8_t *signs,
                                                 size_t *bad);

/**
 * The same as predicament_orient2d_batch(), for points of floats.
 *
 * @copydetails predicament_orient2d_batch
 */
predicament_result predicament_orient2d_batch_f32(const float *points,
                                                  size_t count,
                                                  size_t stride,
                                                  const uint32_t *indices,
                                                  size_t queries,
                                                  int8_t *signs,
                                                  size_t *bad);

/**
 * The same as predicament_orient3d_batch(), for points of floats.
 *
 * @copydetails predicament_orient3d_batch
 */
predicament_result predicament_orient3d_batch_f32(const float *points,
                                                  size_t count,
                                                  size_t stride,
                                                  const uint32_t *indices,
                                                  size_t queries,
                                                  int8_t *signs,
                                                  size_t *bad);

/**
 * The same as predicament_incircle_batch(), for points of floats.
 *
 * @copydetails predicament_incircle_batch
 */
predicament_result predicament_incircle_batch_f32(const float *points,
                                                  size_t count,
                                                  size_t stride,
                                                  const uint32_t *indices,
                                                  size_t queries,
                                                  int8_t *signs,
                                                  size_t *bad);

/**
 * The same as predicament_insphere_batch(), for points of floats.
 *
 * @copydetails predicament_insphere_batch
 */
predicament_result predicament_insphere_batch_f32(const float *points,
                                                  size_t count,
                                                  size_t stride,
                                                  const uint32_t *indices,
                                                  size_t queries,
                                                  int8_t *signs,
                                                  size_t *bad);

/**
 * The same as predicament_compare(), for points of 32-bit integers.
 *
 * @copydetails predicament_compare
 */
predicament_result predicament_compare_i32(int32_t axis,
                                           const int32_t *a,
                                           const int32_t *b,
                                           int8_t *sign);

/**
 * The same as predicament_orient2d(), for points of 32-bit integers.
 *
 * @copydetails predicament_orient2d
 */
predicament_result predicament_orient2d_i32(const int32_t *a,
                                            const int32_t *b,
                                            const int32_t *c,
                                            int8_t *sign);

/**
 * The same as predicament_orient3d(), for points of 32-bit integers.
 *
 * @copydetails predicament_orient3d
 */
predicament_result predicament_orient3d_i32(const int32_t *a,
                                            const int32_t *b,
                                            const int32_t *c,
                                            const int32_t *d,
                                            int8_t *sign);

/**
 * The same as predicament_incircle(), for points of 32-bit integers.
 *
 * @copydetails predicament_incircle
 */
predicament_result predicament_incircle_i32(const int32_t *a,
                                            const int32_t *b,
                                            const int32_t *c,
                                            const int32_t *d,
                                            int8_t *sign);

/**
 * The same as predicament_insphere(), for points of 32-bit integers.
 *
 * @copydetails predicament_insphere
 */
predicament_result predicament_insphere_i32(const int32_t *a,
                                            const int32_t *b,
                                            const int32_t *c,
                                            const int32_t *d,
                                            const int32_t *e,
                                            int8_t *sign);

/**
 * The same as predicament_compare_batch(), for points of 32-bit integers.
 *
 * @copydetails predicament_compare_batch
 */
predicament_result predicament_compare_batch_i32(int32_t axis,
                                                 const int32_t *points,
                                                 size_t count,
                                                 size_t stride,
                                                 const uint32_t *indices,
                                                 size_t queries,
                                                 int8_t *signs,
                                                 size_t *bad);

/**
 * The same as predicament_orient2d_batch(), for points of 32-bit integers.
 *
 * @copydetails predicament_orient2d_batch
 */
predicament_result predicament_orient2d_batch_i32(const int32_t *points,
                                                  size_t count,
                                                  size_t stride,
                                                  const uint32_t *indices,
                                                  size_t queries,
                                                  int8_t *signs,
                                                  size_t *bad);

/**
 * The same as predicament_orient3d_batch(), for points of 32-bit integers.
 *
 * @copydetails predicament_orient3d_batch
 */
predicament_result predicament_orient3d_batch_i32(const int32_t *points,
                                                  size_t count,
                                                  size_t stride,
                                                  const uint32_t *indices,
                                                  size_t queries,
                                                  int8_t *signs,
                                                  size_t *bad);

/**
 * The same as predicament_incircle_batch(), for points of 32-bit integers.
 *
 * @copydetails predicament_incircle_batch
 */
predicament_result predicament_incircle_batch_i32(const int32_t *points,
                                                  size_t count,
                                                  size_t stride,
                                                  const uint32_t *indices,
                                                  size_t queries,
                                                  int8_t *signs,
                                                  size_t *bad);

/**
 * The same as predicament_insphere_batch(), for points of 32-bit integers.
 *
 * @copydetails predicament_insphere_batch
 */
predicament_result predicament_insphere_batch_i32(const int32_t *points,
                                                  size_t count,
                                                  size_t stride,
                                                  const uint32_t *indices,
                                                  size_t queries,
                                                  int8_t *signs,
                                                  size_t *bad);

/**
 * The same as predicament_compare(), for points of 64-bit integers.
 *
 * @copydetails predicament_compare
 */
predicament_result predicament_compare_i64(int32_t axis,
                                           const int64_t *a,
                                           const int64_t *b,
                                           int8_t *sign);

/**
 * The same as predicament_orient2d(), for points of 64-bit integers.
 *
 * @copydetails predicament_orient2d
 */
predicament_result predicament_orient2d_i64(const int64_t *a,
                                            const int64_t *b,
                                            const int64_t *c,
                                            int8_t *sign);

/**
 * The same as predicament_orient3d(), for points of 64-bit integers.
 *
 * @copydetails predicament_orient3d
 */
predicament_result predicament_orient3d_i64(const int64_t *a,
                                            const int64_t *b,
                                            const int64_t *c,
                                            const int64_t *d,
                                            int8_t *sign);

/**
 * The same as predicament_incircle(), for points of 64-bit integers.
 *
 * @copydetails predicament_incircle
 */
predicament_result predicament_incircle_i64(const int64_t *a,
                                            const int64_t *b,
                                            const int64_t *c,
                                            const int64_t *d,
                                            int8_t *sign);

/**
 * The same as predicament_insphere(), for points of 64-bit integers.
 *
 * @copydetails predicament_insphere
 */
predicament_result predicament_insphere_i64(const int64_t *a,
                                            const int64_t *b,
                                            const int64_t *c,
                                            const int64_t *d,
                                            const int64_t *e,
                                            int8_t *sign);

/**
 * The same as predicament_compare_batch(), for points of 64-bit integers.
 *
 * @copydetails predicament_compare_batch
 */
predicament_result predicament_compare_batch_i64(int32_t axis,
                                                 const int64_t *points,
                                                 size_t count,
                                                 size_t stride,
                                                 const uint32_t *indices,
                                                 size_t queries,
                                                 int8_t *signs,
                                                 size_t *bad);

/**
 * The same as predicament_orient2d_batch(), for points of 64-bit integers.
 *
 * @copydetails predicament_orient2d_batch
 */
predicament_result predicament_orient2d_batch_i64(const int64_t *points,
                                                  size_t count,
                                                  size_t stride,
                                                  const uint32_t *indices,
                                                  size_t queries,
                                                  int8_t *signs,
                                                  size_t *bad);

/**
 * The same as predicament_orient3d_batch(), for points of 64-bit integers.
 *
 * @copydetails predicament_orient3d_batch
 */
predicament_result predicament_orient3d_batch_i64(const int64_t *points,
                                                  size_t count,
                                                  size_t stride,
                                                  const uint32_t *indices,
                                                  size_t queries,
                                                  int8_t *signs,
                                                  size_t *bad);

/**
 * The same as predicament_incircle_batch(), for points of 64-bit integers.
 *
 * @copydetails predicament_incircle_batch
 */
predicament_result predicament_incircle_batch_i64(const int64_t *points,
                                                  size_t count,
                                                  size_t stride,
                                                  const uint32_t *indices,
                                                  size_t queries,
                                                  int8_t *signs,
                                                  size_t *bad);

/**
 * The same as predicament_insphere_batch(), for points of 64-bit integers.
 *
 * @copydetails predicament_insphere_batch
 */
predicament_result predicament_insphere_batch_i64(const int64_t *points,
                                                  size_t count,
                                                  size_t stride,
                                                  const uint32_t *indices,
                                                  size_t queries,
                                                  int8_t *signs,
                                                  size_t *bad);

/**
 * Makes a scene of points, which are copied.
 *
 * @param points  the points: two or three coordinates each, one after another
 * @param count  the number of points, at most 2^31
 * @param stride  the distance from one point to the next in bytes; at least the size of a point
 * @param dimension  2 or 3
 * @param backend  a predicament_backend
 * @param scene  receives the scene, or NULL after a failure
 * @param bad  receives the index of the bad point after a failure; may be NULL
 * @return PREDICAMENT_OK; PREDICAMENT_NOT_FINITE for the first bad point; PREDICAMENT_NULL, PREDICAMENT_ARGUMENT or
 * PREDICAMENT_TOO_MANY; PREDICAMENT_UNSUPPORTED if the library was built without PREDICAMENT_SOS
 *
 * The caller owns the scene and frees it by predicament_scene_free(). The arrays are borrowed for the call. A scene
 * takes memory of 8 bytes a coordinate. The process ends if the system has not enough memory.
 */
predicament_result predicament_scene_new(const double *points,
                                         size_t count,
                                         size_t stride,
                                         int32_t dimension,
                                         int32_t backend,
                                         predicament_scene **scene,
                                         size_t *bad);

/**
 * The same as predicament_scene_new(), for points of floats.
 *
 * @copydetails predicament_scene_new
 */
predicament_result predicament_scene_new_f32(const float *points,
                                             size_t count,
                                             size_t stride,
                                             int32_t dimension,
                                             int32_t backend,
                                             predicament_scene **scene,
                                             size_t *bad);

/**
 * The same as predicament_scene_new(), for points of 32-bit integers.
 *
 * @copydetails predicament_scene_new
 */
predicament_result predicament_scene_new_i32(const int32_t *points,
                                             size_t count,
                                             size_t stride,
                                             int32_t dimension,
                                             int32_t backend,
                                             predicament_scene **scene,
                                             size_t *bad);

/**
 * The same as predicament_scene_new(), for points of 64-bit integers. The result is PREDICAMENT_RANGE if the integers
 * along an axis span more than 2^54 times the largest power of two that divides all their differences.
 *
 * @copydetails predicament_scene_new
 */
predicament_result predicament_scene_new_i64(const int64_t *points,
                                             size_t count,
                                             size_t stride,
                                             int32_t dimension,
                                             int32_t backend,
                                             predicament_scene **scene,
                                             size_t *bad);

/**
 * Frees a scene and its constructed vertices.
 *
 * @param scene  a scene of predicament_scene_new() that is not freed, or NULL; no thread may use it then or later
 */
void predicament_scene_free(predicament_scene *scene);

/**
 * The number of points of a scene.
 *
 * @param scene  a scene; NULL gives 0
 */
size_t predicament_scene_points(const predicament_scene *scene);

/**
 * The number of constructed vertices of a scene. Their ids are PREDICAMENT_CONSTRUCTED + 0, 1, 2 and so on.
 *
 * @param scene  a scene; NULL gives 0
 */
size_t predicament_scene_constructed(const predicament_scene *scene);

/**
 * Adds vertices to a scene of the plane: each is the point where two lines meet.
 *
 * Queries are about the exact point, which is not rounded.
 *
 * @param scene  a scene
 * @param definitions  four vertices each: two of the first line, two of the second
 * @param count  the number of definitions
 * @param vertices  receives the id of each vertex, with the bit PREDICAMENT_CONSTRUCTED
 * @param bad  receives the index of the bad definition after a failure; may be NULL
 * @return PREDICAMENT_OK; for the first bad definition PREDICAMENT_INDEX, PREDICAMENT_REPEATED, PREDICAMENT_NO_POINT
 * or PREDICAMENT_UNSUPPORTED; PREDICAMENT_NULL, PREDICAMENT_MISALIGNED or PREDICAMENT_TOO_MANY
 *
 * All vertices are added, or none. Later definitions may name earlier vertices of the same call, except in a scene of
 * PREDICAMENT_SOS, whose definitions name points only. A definition that the scene has already gives the same id. The
 * arrays are borrowed for the call. While it runs, no other thread may use the scene.
 */
predicament_result predicament_scene_add_ssi(predicament_scene *scene,
                                             const uint32_t *definitions,
                                             size_t count,
                                             uint32_t *vertices,
                                             size_t *bad);

/**
 * Adds vertices to a scene of space: each is the point where a line meets a plane.
 *
 * Queries are about the exact point, which is not rounded.
 *
 * @param scene  a scene
 * @param definitions  five vertices each: two of the line, three of the plane
 * @param count  the number of definitions
 * @param vertices  receives the id of each vertex, with the bit PREDICAMENT_CONSTRUCTED
 * @param bad  receives the index of the bad definition after a failure; may be NULL
 * @return PREDICAMENT_OK; for the first bad definition PREDICAMENT_INDEX, PREDICAMENT_REPEATED, PREDICAMENT_NO_POINT
 * or PREDICAMENT_UNSUPPORTED; PREDICAMENT_NULL, PREDICAMENT_MISALIGNED or PREDICAMENT_TOO_MANY
 *
 * All vertices are added, or none. Later definitions may name earlier vertices of the same call, except in a scene of
 * PREDICAMENT_SOS, whose definitions name points only. A definition that the scene has already gives the same id. The
 * arrays are borrowed for the call. While it runs, no other thread may use the scene.
 */
predicament_result predicament_scene_add_lpi(predicament_scene *scene,
                                             const uint32_t *definitions,
                                             size_t count,
                                             uint32_t *vertices,
                                             size_t *bad);

/**
 * Adds vertices to a scene of space: each is the point where three planes meet.
 *
 * Queries are about the exact point, which is not rounded.
 *
 * @param scene  a scene
 * @param definitions  nine vertices each: three of each plane
 * @param count  the number of definitions
 * @param vertices  receives the id of each vertex, with the bit PREDICAMENT_CONSTRUCTED
 * @param bad  receives the index of the bad definition after a failure; may be NULL
 * @return PREDICAMENT_OK; for the first bad definition PREDICAMENT_INDEX, PREDICAMENT_REPEATED, PREDICAMENT_NO_POINT
 * or PREDICAMENT_UNSUPPORTED; PREDICAMENT_NULL, PREDICAMENT_MISALIGNED or PREDICAMENT_TOO_MANY
 *
 * All vertices are added, or none. Later definitions may name earlier vertices of the same call, except in a scene of
 * PREDICAMENT_SOS, whose definitions name points only. A definition that the scene has already gives the same id. The
 * arrays are borrowed for the call. While it runs, no other thread may use the scene.
 */
predicament_result predicament_scene_add_tpi(predicament_scene *scene,
                                             const uint32_t *definitions,
                                             size_t count,
                                             uint32_t *vertices,
                                             size_t *bad);

/**
 * The order of two vertices of a scene along an axis.
 *
 * The sign is that of predicament_compare().
 *
 * @param scene  a scene
 * @param axis  a predicament_axis that the scene has
 * @param a, b  indices of points, or ids of constructed vertices
 * @param sign  receives -1, 0 or 1
 * @return PREDICAMENT_OK, PREDICAMENT_NULL, PREDICAMENT_INDEX, PREDICAMENT_ARGUMENT, or PREDICAMENT_UNSUPPORTED if
 * the scene lacks the axis
 *
 * The pointers are borrowed for the call. Any thread may call while no thread changes the scene.
 */
predicament_result predicament_scene_compare(const predicament_scene *scene,
                                             int32_t axis,
                                             uint32_t a,
                                             uint32_t b,
                                             int8_t *sign);

/**
 * The turn of three vertices of a scene in a coordinate plane.
 *
 * The sign is that of predicament_orient2d().
 *
 * @param scene  a scene
 * @param plane  a predicament_plane that the scene has
 * @param a, b, c  indices of points, or ids of constructed vertices
 * @param sign  receives -1, 0 or 1
 * @return PREDICAMENT_OK, PREDICAMENT_NULL, PREDICAMENT_INDEX, PREDICAMENT_ARGUMENT, or PREDICAMENT_UNSUPPORTED if
 * the scene lacks the plane
 *
 * The pointers are borrowed for the call. Any thread may call while no thread changes the scene.
 */
predicament_result predicament_scene_orient2d(const predicament_scene *scene,
                                              int32_t plane,
                                              uint32_t a,
                                              uint32_t b,
                                              uint32_t c,
                                              int8_t *sign);

/**
 * The side of vertex d on the plane of three vertices, in a scene of space.
 *
 * The sign is that of predicament_orient3d().
 *
 * @param scene  a scene
 * @param a, b, c, d  indices of points, or ids of constructed vertices
 * @param sign  receives -1, 0 or 1
 * @return PREDICAMENT_OK, PREDICAMENT_NULL, PREDICAMENT_INDEX, or PREDICAMENT_UNSUPPORTED in a scene of the plane
 *
 * The pointers are borrowed for the call. Any thread may call while no thread changes the scene.
 */
predicament_result predicament_scene_orient3d(const predicament_scene *scene,
                                              uint32_t a,
                                              uint32_t b,
                                              uint32_t c,
                                              uint32_t d,
                                              int8_t *sign);

/**
 * The place of vertex d at the circle through three vertices, in a scene of the plane.
 *
 * The sign is that of predicament_incircle().
 *
 * @param scene  a scene
 * @param a, b, c, d  indices of points, or ids of constructed vertices
 * @param sign  receives -1, 0 or 1
 * @return PREDICAMENT_OK, PREDICAMENT_NULL, PREDICAMENT_INDEX, or PREDICAMENT_UNSUPPORTED in a scene of space, or in
 * a scene of PREDICAMENT_SOS with constructed vertices
 *
 * The pointers are borrowed for the call. Any thread may call while no thread changes the scene.
 */
predicament_result predicament_scene_incircle(const predicament_scene *scene,
                                              uint32_t a,
                                              uint32_t b,
                                              uint32_t c,
                                              uint32_t d,
                                              int8_t *sign);

/**
 * The place of vertex e at the sphere through four vertices, in a scene of space. They are points, not constructed
 * vertices.
 *
 * The sign is that of predicament_insphere().
 *
 * @param scene  a scene
 * @param a, b, c, d, e  indices of points, or ids of constructed vertices
 * @param sign  receives -1, 0 or 1
 * @return PREDICAMENT_OK, PREDICAMENT_NULL, PREDICAMENT_INDEX, or PREDICAMENT_UNSUPPORTED in a scene of the plane or
 * about a constructed vertex
 *
 * The pointers are borrowed for the call. Any thread may call while no thread changes the scene.
 */
predicament_result predicament_scene_insphere(const predicament_scene *scene,
                                              uint32_t a,
                                              uint32_t b,
                                              uint32_t c,
                                              uint32_t d,
                                              uint32_t e,
                                              int8_t *sign);

/**
 * predicament_scene_compare() for many queries.
 *
 * @param scene  a scene
 * @param axis  a predicament_axis that the scene has
 * @param vertices  two vertices for each query: indices of points, or ids of constructed vertices
 * @param queries  the number of queries
 * @param signs  receives -1, 0 or 1 for each query; must not overlap the other array
 * @param bad  receives the index of the bad query after a failure; may be NULL
 * @return as predicament_scene_compare(), for the first bad query; PREDICAMENT_MISALIGNED or PREDICAMENT_TOO_MANY
 *
 * After a failure the signs mean nothing. The pointers are borrowed for the call. Any thread may call while no thread
 * changes the scene.
 */
predicament_result predicament_scene_compare_batch(const predicament_scene *scene,
                                                   int32_t axis,
                                                   const uint32_t *vertices,
                                                   size_t queries,
                                                   int8_t *signs,
                                                   size_t *bad);

/**
 * predicament_scene_orient2d() for many queries.
 *
 * @param scene  a scene
 * @param plane  a predicament_plane that the scene has
 * @param vertices  three vertices for each query: indices of points, or ids of constructed vertices
 * @param queries  the number of queries
 * @param signs  receives -1, 0 or 1 for each query; must not overlap the other array
 * @param bad  receives the index of the bad query after a failure; may be NULL
 * @return as predicament_scene_orient2d(), for the first bad query; PREDICAMENT_MISALIGNED or PREDICAMENT_TOO_MANY
 *
 * After a failure the signs mean nothing. The pointers are borrowed for the call. Any thread may call while no thread
 * changes the scene.
 */
predicament_result predicament_scene_orient2d_batch(const predicament_scene *scene,
                                                    int32_t plane,
                                                    const uint32_t *vertices,
                                                    size_t queries,
                                                    int8_t *signs,
                                                    size_t *bad);

/**
 * predicament_scene_orient3d() for many queries.
 *
 * @param scene  a scene
 * @param vertices  four vertices for each query: indices of points, or ids of constructed vertices
 * @param queries  the number of queries
 * @param signs  receives -1, 0 or 1 for each query; must not overlap the other array
 * @param bad  receives the index of the bad query after a failure; may be NULL
 * @return as predicament_scene_orient3d(), for the first bad query; PREDICAMENT_MISALIGNED or PREDICAMENT_TOO_MANY
 *
 * After a failure the signs mean nothing. The pointers are borrowed for the call. Any thread may call while no thread
 * changes the scene.
 */
predicament_result predicament_scene_orient3d_batch(const predicament_scene *scene,
                                                    const uint32_t *vertices,
                                                    size_t queries,
                                                    int8_t *signs,
                                                    size_t *bad);

/**
 * predicament_scene_incircle() for many queries.
 *
 * @param scene  a scene
 * @param vertices  four vertices for each query: indices of points, or ids of constructed vertices
 * @param queries  the number of queries
 * @param signs  receives -1, 0 or 1 for each query; must not overlap the other array
 * @param bad  receives the index of the bad query after a failure; may be NULL
 * @return as predicament_scene_incircle(), for the first bad query; PREDICAMENT_MISALIGNED or PREDICAMENT_TOO_MANY
 *
 * After a failure the signs mean nothing. The pointers are borrowed for the call. Any thread may call while no thread
 * changes the scene.
 */
predicament_result predicament_scene_incircle_batch(const predicament_scene *scene,
                                                    const uint32_t *vertices,
                                                    size_t queries,
                                                    int8_t *signs,
                                                    size_t *bad);

/**
 * predicament_scene_insphere() for many queries.
 *
 * @param scene  a scene
 * @param vertices  five vertices for each query: indices of points, or ids of constructed vertices
 * @param queries  the number of queries
 * @param signs  receives -1, 0 or 1 for each query; must not overlap the other array
 * @param bad  receives the index of the bad query after a failure; may be NULL
 * @return as predicament_scene_insphere(), for the first bad query; PREDICAMENT_MISALIGNED or PREDICAMENT_TOO_MANY
 *
 * After a failure the signs mean nothing. The pointers are borrowed for the call. Any thread may call while no thread
 * changes the scene.
 */
predicament_result predicament_scene_insphere_batch(const predicament_scene *scene,
                                                    const uint32_t *vertices,
                                                    size_t queries,
                                                    int8_t *signs,
                                                    size_t *bad);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus

#endif  /* PREDICAMENT_H */
