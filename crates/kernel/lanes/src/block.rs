//! The points of a block of queries, coordinate by coordinate.
//!
//! For a query that the filter settles at once, most of the time goes into fetching its points by vertex id. So all ids
//! are checked together, and the points of eight queries at a time are loaded from memory and transposed in registers.

#![allow(unsafe_code)]
#![allow(clippy::needless_range_loop)]

use predicament_predicates::Vertex;

/// The number of queries of a block: each has one bit in a mask.
pub const BLOCK: usize = 64;

/// The `D` coordinates that a predicate takes from a point of `E`.
pub trait View<const E: usize, const D: usize> {
    /// The coordinates of the view, in the view's order.
    fn see<T: Copy>(point: [T; E]) -> [T; D];
}

/// The view of all coordinates.
pub struct Whole;
/// The projection along z.
pub struct Xy;
/// The projection along x.
pub struct Yz;
/// The projection along y.
pub struct Zx;

/// One coordinate.
pub struct Along<const AXIS: usize>;

impl<const E: usize, const AXIS: usize> View<E, 1> for Along<AXIS> {
    #[inline(always)]
    fn see<T: Copy>(point: [T; E]) -> [T; 1] {
        [point[AXIS]]
    }
}

impl<const D: usize> View<D, D> for Whole {
    #[inline(always)]
    fn see<T: Copy>(point: [T; D]) -> [T; D] {
        point
    }
}

impl View<3, 2> for Xy {
    #[inline(always)]
    fn see<T: Copy>([x, y, _]: [T; 3]) -> [T; 2] {
        [x, y]
    }
}

impl View<3, 2> for Yz {
    #[inline(always)]
    fn see<T: Copy>([_, y, z]: [T; 3]) -> [T; 2] {
        [y, z]
    }
}

impl View<3, 2> for Zx {
    #[inline(always)]
    fn see<T: Copy>([x, _, z]: [T; 3]) -> [T; 2] {
        [z, x]
    }
}

/// The coordinates of up to [`BLOCK`] queries of `N` points.
///
/// The indices are: place in the query, axis, query.
#[repr(align(64))]
pub struct Block<const D: usize, const N: usize>([[[f64; BLOCK]; D]; N]);

impl<const D: usize, const N: usize> Block<D, N> {
    /// A block of zeros.
    pub const EMPTY: Block<D, N> = Block([[[0.0; BLOCK]; D]; N]);

    /// The points of one query.
    #[inline(always)]
    pub fn query(&self, at: usize) -> [[f64; D]; N] {
        let mut points = [[0.0; D]; N];
        for row in 0..N {
            for axis in 0..D {
                points[row][axis] = self.0[row][axis][at];
            }
        }
        points
    }

    /// Fetches the points of at most [`BLOCK`] queries, and returns true if all vertices have one.
    ///
    /// A vertex without a point gets NaN coordinates.
    ///
    /// # Safety
    /// If `W` is true, the processor must have AVX-512F.
    #[inline(always)]
    pub unsafe fn fetch<V: View<E, D>, const E: usize, const W: bool>(
        &mut self,
        points: &[[f64; E]],
        queries: &[[Vertex; N]],
    ) -> bool {
        let of_all = |largest, &v| if v > largest { v } else { largest };
        let largest = queries.as_flattened().iter().fold(Vertex::input(0), of_all);
        let mut first = 0;
        #[cfg(target_arch = "x86_64")]
        if W {
            // The last point is excluded, since the registers read beyond the end of a point.
            if largest.index() + 1 < points.len() {
                let (eights, rest) = queries.as_chunks::<8>();
                for (eighth, queries) in eights.iter().enumerate() {
                    for row in 0..N {
                        let mut indices = [0; 8];
                        for lane in 0..8 {
                            indices[lane] = queries[lane][row].index();
                        }
                        // SAFETY: the caller guarantees AVX-512F, and `indices` are less than the index of the last
                        // point.
                        let lanes = V::see(unsafe { wide::transposed(points, indices) });
                        for axis in 0..D {
                            self.0[row][axis].as_chunks_mut::<8>().0[eighth] = lanes[axis];
                        }
                    }
                }
                first = queries.len() - rest.len();
            }
        }
        for at in first..queries.len() {
            for row in 0..N {
                let point = points.get(queries[at][row].index()).map_or([f64::NAN; D], |point| V::see(*point));
                for axis in 0..D {
                    self.0[row][axis][at] = point[axis];
                }
            }
        }
        largest.index() < points.len()
    }
}

/// The numbers of the vertices of up to [`BLOCK`] queries: they have the order of the vertices.
pub struct Numbers<const N: usize>([[f64; BLOCK]; N]);

impl<const N: usize> Numbers<N> {
    /// The numbers of these queries.
    #[inline(always)]
    pub fn of(queries: &[[Vertex; N]]) -> Numbers<N> {
        let mut numbers = [[0.0; BLOCK]; N];
        for (at, query) in queries.iter().enumerate() {
            for row in 0..N {
                #[allow(clippy::cast_precision_loss)] // 32 bits
                let number = query[row].index() as f64;
                numbers[row][at] = number;
            }
        }
        Numbers(numbers)
    }

    /// The numbers of one query.
    #[inline(always)]
    pub fn query(&self, at: usize) -> [f64; N] {
        let mut query = [0.0; N];
        for row in 0..N {
            query[row] = self.0[row][at];
        }
        query
    }
}

/// Registers of eight doubles.
#[cfg(target_arch = "x86_64")]
mod wide {
    use core::arch::x86_64::{
        __m256d, __m512d, _mm_loadu_pd, _mm256_castpd128_pd256, _mm256_insertf128_pd, _mm256_loadu_pd,
        _mm512_castpd256_pd512, _mm512_insertf64x4, _mm512_shuffle_f64x2, _mm512_storeu_pd, _mm512_unpackhi_pd,
        _mm512_unpacklo_pd,
    };

    /// The coordinates of eight points, axis by axis.
    ///
    /// # Safety
    /// The processor must have AVX-512F, and all indices must be less than the index of the last point.
    #[inline(always)]
    pub unsafe fn transposed<const E: usize>(points: &[[f64; E]], indices: [usize; 8]) -> [[f64; 8]; E] {
        let point = |lane: usize| points.as_ptr().wrapping_add(indices[lane]).cast::<f64>();
        // SAFETY: the caller guarantees that the processor has these operations. Each load is of the doubles of a
        // point, and in space of one more double, which the next point has.
        unsafe {
            let mut lanes = [[0.0; 8]; E];
            if E == 2 {
                // x0 y0 x2 y2 …, x1 y1 x3 y3 …
                let pair = |a: usize, b: usize| -> __m256d {
                    let low = _mm256_castpd128_pd256(_mm_loadu_pd(point(a)));
                    _mm256_insertf128_pd::<1>(low, _mm_loadu_pd(point(b)))
                };
                let even = join(pair(0, 2), pair(4, 6));
                let odd = join(pair(1, 3), pair(5, 7));
                store(_mm512_unpacklo_pd(even, odd), &mut lanes[0]);
                store(_mm512_unpackhi_pd(even, odd), &mut lanes[1]);
            } else {
                // x0 y0 z0 _ x2 y2 z2 _, and the same of points 1 and 3, 4 and 6, 5 and 7
                let pair = |a: usize, b: usize| join(_mm256_loadu_pd(point(a)), _mm256_loadu_pd(point(b)));
                let [p, q, r, s] = [pair(0, 2), pair(1, 3), pair(4, 6), pair(5, 7)];
                // x0 x1 z0 z1 x2 x3 z2 z3, …
                let [xz, zx] = [_mm512_unpacklo_pd(p, q), _mm512_unpacklo_pd(r, s)];
                let [y, yy] = [_mm512_unpackhi_pd(p, q), _mm512_unpackhi_pd(r, s)];
                store(_mm512_shuffle_f64x2::<0b10_00_10_00>(xz, zx), &mut lanes[0]);
                store(_mm512_shuffle_f64x2::<0b10_00_10_00>(y, yy), &mut lanes[1]);
                store(_mm512_shuffle_f64x2::<0b11_01_11_01>(xz, zx), &mut lanes[2]);
            }
            lanes
        }
    }

    #[inline(always)]
    unsafe fn join(low: __m256d, high: __m256d) -> __m512d {
        // SAFETY: the caller guarantees AVX-512F.
        unsafe { _mm512_insertf64x4::<1>(_mm512_castpd256_pd512(low), high) }
    }

    #[inline(always)]
    unsafe fn store(register: __m512d, lanes: &mut [f64; 8]) {
        // SAFETY: the caller guarantees AVX-512F, and there is space for eight doubles.
        unsafe { _mm512_storeu_pd(lanes.as_mut_ptr(), register) }
    }
}
