//! The shipped predicates, compiled: their estimates, and the bounds of these.
//!
//! `write::compiled` has written the file, and a test holds the file to it. Values are those of the interpreted
//! programs, bit by bit. Bounds can differ in the last bit, as the slack is added up in another order.

use super::Compiled;

/// 2^-960, the unit of the slack for underflow.
const SIGMA: f64 = f64::from_bits(63 << 52);

/// The predicate with this name.
pub(super) fn named(name: &str) -> Option<Compiled> {
    Some(match name {
        "compare_distance2d" => Compiled { estimate: compare_distance2d, bounded: bounded_compare_distance2d },
        "side_of_bisector" => Compiled { estimate: side_of_bisector, bounded: bounded_side_of_bisector },
        "compare_slope" => Compiled { estimate: compare_slope, bounded: bounded_compare_slope },
        "compare_angle" => Compiled { estimate: compare_angle, bounded: bounded_compare_angle },
        "side_of_power_circle" => Compiled { estimate: side_of_power_circle, bounded: bounded_side_of_power_circle },
        "circumcentre_side" => Compiled { estimate: circumcentre_side, bounded: bounded_circumcentre_side },
        "compare_distance3d" => Compiled { estimate: compare_distance3d, bounded: bounded_compare_distance3d },
        "orient_on_sphere" => Compiled { estimate: orient_on_sphere, bounded: bounded_orient_on_sphere },
        "same_facing" => Compiled { estimate: same_facing, bounded: bounded_same_facing },
        "side_of_power_sphere" => Compiled { estimate: side_of_power_sphere, bounded: bounded_side_of_power_sphere },
        "orient4d" => Compiled { estimate: orient4d, bounded: bounded_orient4d },
        _ => return None,
    })
}

fn compare_distance2d(points: &[&[f64]]) -> f64 {
    let &[&[px, py], &[ax, ay], &[bx, by]] = points else {
        return f64::NAN;
    };
    let v4 = ax - px;
    let v5 = ay - py;
    let v6 = v4 * v4;
    let v7 = v5 * v5;
    let v8 = v6 + v7;
    let v11 = bx - px;
    let v12 = by - py;
    let v13 = v11 * v11;
    let v14 = v12 * v12;
    let v15 = v13 + v14;
    let v16 = v8 - v15;
    v16
}

fn bounded_compare_distance2d(points: &[&[f64]]) -> [f64; 2] {
    let &[&[px, py], &[ax, ay], &[bx, by]] = points else {
        return [0.0, f64::NAN];
    };
    let v4 = ax - px;
    let v5 = ay - py;
    let v6 = v4 * v4;
    let v7 = v5 * v5;
    let v8 = v6 + v7;
    let v11 = bx - px;
    let v12 = by - py;
    let v13 = v11 * v11;
    let v14 = v12 * v12;
    let v15 = v13 + v14;
    let v16 = v8 - v15;
    let m16 = v8 + v15;
    [v16, 4.440892098500632e-16 * m16 + SIGMA * 2.0]
}

fn side_of_bisector(points: &[&[f64]]) -> f64 {
    let &[&[ax, ay], &[bx, by], &[px, py]] = points else {
        return f64::NAN;
    };
    let v4 = bx - ax;
    let v5 = by - ay;
    let v8 = px - ax;
    let v9 = py - ay;
    let v10 = px - bx;
    let v11 = py - by;
    let v12 = v8 + v10;
    let v13 = v9 + v11;
    let v14 = v4 * v12;
    let v15 = v5 * v13;
    let v16 = v14 + v15;
    v16
}

fn bounded_side_of_bisector(points: &[&[f64]]) -> [f64; 2] {
    let &[&[ax, ay], &[bx, by], &[px, py]] = points else {
        return [0.0, f64::NAN];
    };
    let v4 = bx - ax;
    let v5 = by - ay;
    let v8 = px - ax;
    let v9 = py - ay;
    let v10 = px - bx;
    let v11 = py - by;
    let v12 = v8 + v10;
    let v13 = v9 + v11;
    let v14 = v4 * v12;
    let v15 = v5 * v13;
    let v16 = v14 + v15;
    let m12 = v8.abs() + v10.abs();
    let m13 = v9.abs() + v11.abs();
    let m14 = v4.abs() * m12;
    let m15 = v5.abs() * m13;
    let m16 = m14 + m15;
    [v16, 4.440892098500632e-16 * m16 + SIGMA * 2.0]
}

fn compare_slope(points: &[&[f64]]) -> f64 {
    let &[&[ax, ay], &[bx, by], &[cx, cy], &[dx, dy]] = points else {
        return f64::NAN;
    };
    let v4 = bx - ax;
    let v5 = by - ay;
    let v10 = dx - cx;
    let v11 = dy - cy;
    let v12 = v5 * v10;
    let v13 = v4 * v11;
    let v14 = v12 - v13;
    let v15 = v4 * v10;
    let v16 = v14 * v15;
    v16
}

fn bounded_compare_slope(points: &[&[f64]]) -> [f64; 2] {
    let &[&[ax, ay], &[bx, by], &[cx, cy], &[dx, dy]] = points else {
        return [0.0, f64::NAN];
    };
    let v4 = bx - ax;
    let v5 = by - ay;
    let v10 = dx - cx;
    let v11 = dy - cy;
    let v12 = v5 * v10;
    let v13 = v4 * v11;
    let v14 = v12 - v13;
    let v15 = v4 * v10;
    let v16 = v14 * v15;
    let m14 = v12.abs() + v13.abs();
    let m16 = m14 * v15.abs();
    let sum = (v4.abs() + v5.abs()) + (v10.abs() + v11.abs());
    [v16, 7.771561172376112e-16 * m16 + SIGMA * (1.0 + sum * sum)]
}

fn compare_angle(points: &[&[f64]]) -> f64 {
    let &[&[ax, ay], &[ox, oy], &[bx, by], &[cx, cy], &[qx, qy], &[dx, dy]] = points else {
        return f64::NAN;
    };
    let v4 = ax - ox;
    let v5 = ay - oy;
    let v8 = bx - ox;
    let v9 = by - oy;
    let v14 = cx - qx;
    let v15 = cy - qy;
    let v18 = dx - qx;
    let v19 = dy - qy;
    let v20 = v4 * v9;
    let v21 = v5 * v8;
    let v22 = v20 - v21;
    let v23 = v14 * v18;
    let v24 = v15 * v19;
    let v25 = v23 + v24;
    let v26 = v22 * v25;
    let v27 = v4 * v8;
    let v28 = v5 * v9;
    let v29 = v27 + v28;
    let v30 = v14 * v19;
    let v31 = v15 * v18;
    let v32 = v30 - v31;
    let v33 = v29 * v32;
    let v34 = v26 - v33;
    v34
}

fn bounded_compare_angle(points: &[&[f64]]) -> [f64; 2] {
    let &[&[ax, ay], &[ox, oy], &[bx, by], &[cx, cy], &[qx, qy], &[dx, dy]] = points else {
        return [0.0, f64::NAN];
    };
    let v4 = ax - ox;
    let v5 = ay - oy;
    let v8 = bx - ox;
    let v9 = by - oy;
    let v14 = cx - qx;
    let v15 = cy - qy;
    let v18 = dx - qx;
    let v19 = dy - qy;
    let v20 = v4 * v9;
    let v21 = v5 * v8;
    let v22 = v20 - v21;
    let v23 = v14 * v18;
    let v24 = v15 * v19;
    let v25 = v23 + v24;
    let v26 = v22 * v25;
    let v27 = v4 * v8;
    let v28 = v5 * v9;
    let v29 = v27 + v28;
    let v30 = v14 * v19;
    let v31 = v15 * v18;
    let v32 = v30 - v31;
    let v33 = v29 * v32;
    let v34 = v26 - v33;
    let m22 = v20.abs() + v21.abs();
    let m25 = v23.abs() + v24.abs();
    let m26 = m22 * m25;
    let m29 = v27.abs() + v28.abs();
    let m32 = v30.abs() + v31.abs();
    let m33 = m29 * m32;
    let m34 = m26 + m33;
    let sum = ((v4.abs() + v5.abs()) + (v8.abs() + v9.abs())) + ((v14.abs() + v15.abs()) + (v18.abs() + v19.abs()));
    [v34, 9.992007221626433e-16 * m34 + SIGMA * (1.0 + sum * sum)]
}

fn side_of_power_circle(points: &[&[f64]]) -> f64 {
    let &[&[ax, ay, aw], &[bx, by, bw], &[cx, cy, cw], &[dx, dy, dw]] = points else {
        return f64::NAN;
    };
    let v4 = ax - dx;
    let v5 = ay - dy;
    let v8 = bx - dx;
    let v9 = by - dy;
    let v12 = cx - dx;
    let v13 = cy - dy;
    let v14 = v4 * v4;
    let v15 = v5 * v5;
    let v16 = v14 + v15;
    let v19 = aw - dw;
    let v20 = v16 - v19;
    let v21 = v8 * v8;
    let v22 = v9 * v9;
    let v23 = v21 + v22;
    let v25 = bw - dw;
    let v26 = v23 - v25;
    let v27 = v12 * v12;
    let v28 = v13 * v13;
    let v29 = v27 + v28;
    let v31 = cw - dw;
    let v32 = v29 - v31;
    let v33 = v8 * v13;
    let v34 = v9 * v12;
    let v35 = v33 - v34;
    let v36 = v20 * v35;
    let v37 = v4 * v13;
    let v38 = v5 * v12;
    let v39 = v37 - v38;
    let v40 = v26 * v39;
    let v41 = v4 * v9;
    let v42 = v5 * v8;
    let v43 = v41 - v42;
    let v44 = v32 * v43;
    let v45 = v36 - v40;
    let v46 = v44 + v45;
    v46
}

fn bounded_side_of_power_circle(points: &[&[f64]]) -> [f64; 2] {
    let &[&[ax, ay, aw], &[bx, by, bw], &[cx, cy, cw], &[dx, dy, dw]] = points else {
        return [0.0, f64::NAN];
    };
    let v4 = ax - dx;
    let v5 = ay - dy;
    let v8 = bx - dx;
    let v9 = by - dy;
    let v12 = cx - dx;
    let v13 = cy - dy;
    let v14 = v4 * v4;
    let v15 = v5 * v5;
    let v16 = v14 + v15;
    let v19 = aw - dw;
    let v20 = v16 - v19;
    let v21 = v8 * v8;
    let v22 = v9 * v9;
    let v23 = v21 + v22;
    let v25 = bw - dw;
    let v26 = v23 - v25;
    let v27 = v12 * v12;
    let v28 = v13 * v13;
    let v29 = v27 + v28;
    let v31 = cw - dw;
    let v32 = v29 - v31;
    let v33 = v8 * v13;
    let v34 = v9 * v12;
    let v35 = v33 - v34;
    let v36 = v20 * v35;
    let v37 = v4 * v13;
    let v38 = v5 * v12;
    let v39 = v37 - v38;
    let v40 = v26 * v39;
    let v41 = v4 * v9;
    let v42 = v5 * v8;
    let v43 = v41 - v42;
    let v44 = v32 * v43;
    let v45 = v36 - v40;
    let v46 = v44 + v45;
    let m20 = v16 + v19.abs();
    let m26 = v23 + v25.abs();
    let m32 = v29 + v31.abs();
    let m35 = v33.abs() + v34.abs();
    let m36 = m20 * m35;
    let m39 = v37.abs() + v38.abs();
    let m40 = m26 * m39;
    let m43 = v41.abs() + v42.abs();
    let m44 = m32 * m43;
    let m45 = m36 + m40;
    let m46 = m44 + m45;
    let sum = (((v4.abs() + v5.abs()) + v8.abs()) + (v9.abs() + v12.abs())) + ((v13.abs() + v19.abs()) + (v25.abs() + v31.abs()));
    [v46, 1.2212453270876757e-15 * m46 + SIGMA * (1.0 + sum * sum)]
}

fn circumcentre_side(points: &[&[f64]]) -> f64 {
    let &[&[px, py], &[qx, qy], &[ax, ay], &[bx, by], &[cx, cy]] = points else {
        return f64::NAN;
    };
    let v4 = bx - ax;
    let v5 = by - ay;
    let v8 = cx - ax;
    let v9 = cy - ay;
    let v11 = v4 * v9;
    let v12 = v5 * v8;
    let v13 = v11 - v12;
    let v14 = 2.0 * v13;
    let v15 = v4 * v4;
    let v16 = v5 * v5;
    let v17 = v15 + v16;
    let v18 = v9 * v17;
    let v19 = v8 * v8;
    let v20 = v9 * v9;
    let v21 = v19 + v20;
    let v22 = v5 * v21;
    let v23 = v18 - v22;
    let v24 = v4 * v21;
    let v25 = v8 * v17;
    let v26 = v24 - v25;
    let v31 = qx - px;
    let v32 = qy - py;
    let v33 = ax - px;
    let v34 = ay - py;
    let v35 = v14 * v33;
    let v36 = v14 * v34;
    let v37 = v23 + v35;
    let v38 = v26 + v36;
    let v39 = v31 * v38;
    let v40 = v32 * v37;
    let v41 = v39 - v40;
    let v42 = v14 * v41;
    v42
}

fn bounded_circumcentre_side(points: &[&[f64]]) -> [f64; 2] {
    let &[&[px, py], &[qx, qy], &[ax, ay], &[bx, by], &[cx, cy]] = points else {
        return [0.0, f64::NAN];
    };
    let v4 = bx - ax;
    let v5 = by - ay;
    let v8 = cx - ax;
    let v9 = cy - ay;
    let v11 = v4 * v9;
    let v12 = v5 * v8;
    let v13 = v11 - v12;
    let v14 = 2.0 * v13;
    let v15 = v4 * v4;
    let v16 = v5 * v5;
    let v17 = v15 + v16;
    let v18 = v9 * v17;
    let v19 = v8 * v8;
    let v20 = v9 * v9;
    let v21 = v19 + v20;
    let v22 = v5 * v21;
    let v23 = v18 - v22;
    let v24 = v4 * v21;
    let v25 = v8 * v17;
    let v26 = v24 - v25;
    let v31 = qx - px;
    let v32 = qy - py;
    let v33 = ax - px;
    let v34 = ay - py;
    let v35 = v14 * v33;
    let v36 = v14 * v34;
    let v37 = v23 + v35;
    let v38 = v26 + v36;
    let v39 = v31 * v38;
    let v40 = v32 * v37;
    let v41 = v39 - v40;
    let v42 = v14 * v41;
    let m13 = v11.abs() + v12.abs();
    let m14 = 2.0 * m13;
    let m23 = v18.abs() + v22.abs();
    let m26 = v24.abs() + v25.abs();
    let m35 = m14 * v33.abs();
    let m36 = m14 * v34.abs();
    let m37 = m23 + m35;
    let m38 = m26 + m36;
    let m39 = v31.abs() * m38;
    let m40 = v32.abs() * m37;
    let m41 = m39 + m40;
    let m42 = m14 * m41;
    let sum = ((v4.abs() + v5.abs()) + (v8.abs() + v9.abs())) + ((v31.abs() + v32.abs()) + (v33.abs() + v34.abs()));
    [v42, 1.6653345369377411e-15 * m42 + SIGMA * (1.0 + sum * sum * sum * sum)]
}

fn compare_distance3d(points: &[&[f64]]) -> f64 {
    let &[&[px, py, pz], &[ax, ay, az], &[bx, by, bz]] = points else {
        return f64::NAN;
    };
    let v6 = ax - px;
    let v7 = ay - py;
    let v8 = az - pz;
    let v9 = v6 * v6;
    let v10 = v7 * v7;
    let v11 = v8 * v8;
    let v12 = v9 + v10;
    let v13 = v11 + v12;
    let v17 = bx - px;
    let v18 = by - py;
    let v19 = bz - pz;
    let v20 = v17 * v17;
    let v21 = v18 * v18;
    let v22 = v19 * v19;
    let v23 = v20 + v21;
    let v24 = v22 + v23;
    let v25 = v13 - v24;
    v25
}

fn bounded_compare_distance3d(points: &[&[f64]]) -> [f64; 2] {
    let &[&[px, py, pz], &[ax, ay, az], &[bx, by, bz]] = points else {
        return [0.0, f64::NAN];
    };
    let v6 = ax - px;
    let v7 = ay - py;
    let v8 = az - pz;
    let v9 = v6 * v6;
    let v10 = v7 * v7;
    let v11 = v8 * v8;
    let v12 = v9 + v10;
    let v13 = v11 + v12;
    let v17 = bx - px;
    let v18 = by - py;
    let v19 = bz - pz;
    let v20 = v17 * v17;
    let v21 = v18 * v18;
    let v22 = v19 * v19;
    let v23 = v20 + v21;
    let v24 = v22 + v23;
    let v25 = v13 - v24;
    let m25 = v13 + v24;
    [v25, 5.551115123125792e-16 * m25 + SIGMA * 2.0]
}

fn orient_on_sphere(points: &[&[f64]]) -> f64 {
    let &[&[ax, ay, az], &[bx, by, bz], &[cx, cy, cz]] = points else {
        return f64::NAN;
    };
    let v9 = bx * cy;
    let v10 = by * cx;
    let v11 = v9 - v10;
    let v12 = az * v11;
    let v13 = ax * cy;
    let v14 = ay * cx;
    let v15 = v13 - v14;
    let v16 = bz * v15;
    let v17 = ax * by;
    let v18 = ay * bx;
    let v19 = v17 - v18;
    let v20 = cz * v19;
    let v21 = v12 - v16;
    let v22 = v20 + v21;
    v22
}

fn bounded_orient_on_sphere(points: &[&[f64]]) -> [f64; 2] {
    let &[&[ax, ay, az], &[bx, by, bz], &[cx, cy, cz]] = points else {
        return [0.0, f64::NAN];
    };
    let v9 = bx * cy;
    let v10 = by * cx;
    let v11 = v9 - v10;
    let v12 = az * v11;
    let v13 = ax * cy;
    let v14 = ay * cx;
    let v15 = v13 - v14;
    let v16 = bz * v15;
    let v17 = ax * by;
    let v18 = ay * bx;
    let v19 = v17 - v18;
    let v20 = cz * v19;
    let v21 = v12 - v16;
    let v22 = v20 + v21;
    let m11 = v9.abs() + v10.abs();
    let m12 = az.abs() * m11;
    let m15 = v13.abs() + v14.abs();
    let m16 = bz.abs() * m15;
    let m19 = v17.abs() + v18.abs();
    let m20 = cz.abs() * m19;
    let m21 = m12 + m16;
    let m22 = m20 + m21;
    let sum = (((ax.abs() + ay.abs()) + az.abs()) + (bx.abs() + by.abs())) + ((bz.abs() + cx.abs()) + (cy.abs() + cz.abs()));
    [v22, 4.440892098500632e-16 * m22 + SIGMA * (1.0 + sum)]
}

fn same_facing(points: &[&[f64]]) -> f64 {
    let &[&[ux, uy, uz], &[vx, vy, vz], &[bx, by, bz], &[cx, cy, cz]] = points else {
        return f64::NAN;
    };
    let v6 = bx - cx;
    let v7 = by - cy;
    let v8 = bz - cz;
    let v12 = ux - cx;
    let v13 = uy - cy;
    let v14 = uz - cz;
    let v15 = v8 * v13;
    let v16 = v7 * v14;
    let v17 = v15 - v16;
    let v18 = v6 * v14;
    let v19 = v8 * v12;
    let v20 = v18 - v19;
    let v21 = v7 * v12;
    let v22 = v6 * v13;
    let v23 = v21 - v22;
    let v27 = vx - cx;
    let v28 = vy - cy;
    let v29 = vz - cz;
    let v30 = v8 * v28;
    let v31 = v7 * v29;
    let v32 = v30 - v31;
    let v33 = v6 * v29;
    let v34 = v8 * v27;
    let v35 = v33 - v34;
    let v36 = v7 * v27;
    let v37 = v6 * v28;
    let v38 = v36 - v37;
    let v39 = v17 * v32;
    let v40 = v20 * v35;
    let v41 = v23 * v38;
    let v42 = v39 + v40;
    let v43 = v41 + v42;
    v43
}

fn bounded_same_facing(points: &[&[f64]]) -> [f64; 2] {
    let &[&[ux, uy, uz], &[vx, vy, vz], &[bx, by, bz], &[cx, cy, cz]] = points else {
        return [0.0, f64::NAN];
    };
    let v6 = bx - cx;
    let v7 = by - cy;
    let v8 = bz - cz;
    let v12 = ux - cx;
    let v13 = uy - cy;
    let v14 = uz - cz;
    let v15 = v8 * v13;
    let v16 = v7 * v14;
    let v17 = v15 - v16;
    let v18 = v6 * v14;
    let v19 = v8 * v12;
    let v20 = v18 - v19;
    let v21 = v7 * v12;
    let v22 = v6 * v13;
    let v23 = v21 - v22;
    let v27 = vx - cx;
    let v28 = vy - cy;
    let v29 = vz - cz;
    let v30 = v8 * v28;
    let v31 = v7 * v29;
    let v32 = v30 - v31;
    let v33 = v6 * v29;
    let v34 = v8 * v27;
    let v35 = v33 - v34;
    let v36 = v7 * v27;
    let v37 = v6 * v28;
    let v38 = v36 - v37;
    let v39 = v17 * v32;
    let v40 = v20 * v35;
    let v41 = v23 * v38;
    let v42 = v39 + v40;
    let v43 = v41 + v42;
    let m17 = v15.abs() + v16.abs();
    let m20 = v18.abs() + v19.abs();
    let m23 = v21.abs() + v22.abs();
    let m32 = v30.abs() + v31.abs();
    let m35 = v33.abs() + v34.abs();
    let m38 = v36.abs() + v37.abs();
    let m39 = m17 * m32;
    let m40 = m20 * m35;
    let m41 = m23 * m38;
    let m42 = m39 + m40;
    let m43 = m41 + m42;
    let sum = (((v6.abs() + v7.abs()) + v8.abs()) + (v12.abs() + v13.abs())) + ((v14.abs() + v27.abs()) + (v28.abs() + v29.abs()));
    [v43, 1.1102230246251595e-15 * m43 + SIGMA * (1.0 + sum * sum)]
}

fn side_of_power_sphere(points: &[&[f64]]) -> f64 {
    let &[&[ax, ay, az, aw], &[bx, by, bz, bw], &[cx, cy, cz, cw], &[dx, dy, dz, dw], &[ex, ey, ez, ew]] = points else {
        return f64::NAN;
    };
    let v6 = ax - ex;
    let v7 = ay - ey;
    let v8 = az - ez;
    let v12 = bx - ex;
    let v13 = by - ey;
    let v14 = bz - ez;
    let v18 = cx - ex;
    let v19 = cy - ey;
    let v20 = cz - ez;
    let v24 = dx - ex;
    let v25 = dy - ey;
    let v26 = dz - ez;
    let v27 = v6 * v6;
    let v28 = v7 * v7;
    let v29 = v8 * v8;
    let v30 = v27 + v28;
    let v31 = v29 + v30;
    let v34 = aw - ew;
    let v35 = v31 - v34;
    let v36 = v12 * v12;
    let v37 = v13 * v13;
    let v38 = v14 * v14;
    let v39 = v36 + v37;
    let v40 = v38 + v39;
    let v42 = bw - ew;
    let v43 = v40 - v42;
    let v44 = v18 * v18;
    let v45 = v19 * v19;
    let v46 = v20 * v20;
    let v47 = v44 + v45;
    let v48 = v46 + v47;
    let v50 = cw - ew;
    let v51 = v48 - v50;
    let v52 = v24 * v24;
    let v53 = v25 * v25;
    let v54 = v26 * v26;
    let v55 = v52 + v53;
    let v56 = v54 + v55;
    let v58 = dw - ew;
    let v59 = v56 - v58;
    let v60 = v18 * v25;
    let v61 = v19 * v24;
    let v62 = v60 - v61;
    let v63 = v14 * v62;
    let v64 = v12 * v25;
    let v65 = v13 * v24;
    let v66 = v64 - v65;
    let v67 = v20 * v66;
    let v68 = v12 * v19;
    let v69 = v13 * v18;
    let v70 = v68 - v69;
    let v71 = v26 * v70;
    let v72 = v63 - v67;
    let v73 = v71 + v72;
    let v74 = v35 * v73;
    let v75 = v8 * v62;
    let v76 = v6 * v25;
    let v77 = v7 * v24;
    let v78 = v76 - v77;
    let v79 = v20 * v78;
    let v80 = v6 * v19;
    let v81 = v7 * v18;
    let v82 = v80 - v81;
    let v83 = v26 * v82;
    let v84 = v75 - v79;
    let v85 = v83 + v84;
    let v86 = v43 * v85;
    let v87 = v8 * v66;
    let v88 = v14 * v78;
    let v89 = v6 * v13;
    let v90 = v7 * v12;
    let v91 = v89 - v90;
    let v92 = v26 * v91;
    let v93 = v87 - v88;
    let v94 = v92 + v93;
    let v95 = v51 * v94;
    let v96 = v8 * v70;
    let v97 = v14 * v82;
    let v98 = v20 * v91;
    let v99 = v96 - v97;
    let v100 = v98 + v99;
    let v101 = v59 * v100;
    let v102 = v86 - v74;
    let v103 = v101 - v95;
    let v104 = v102 + v103;
    v104
}

fn bounded_side_of_power_sphere(points: &[&[f64]]) -> [f64; 2] {
    let &[&[ax, ay, az, aw], &[bx, by, bz, bw], &[cx, cy, cz, cw], &[dx, dy, dz, dw], &[ex, ey, ez, ew]] = points else {
        return [0.0, f64::NAN];
    };
    let v6 = ax - ex;
    let v7 = ay - ey;
    let v8 = az - ez;
    let v12 = bx - ex;
    let v13 = by - ey;
    let v14 = bz - ez;
    let v18 = cx - ex;
    let v19 = cy - ey;
    let v20 = cz - ez;
    let v24 = dx - ex;
    let v25 = dy - ey;
    let v26 = dz - ez;
    let v27 = v6 * v6;
    let v28 = v7 * v7;
    let v29 = v8 * v8;
    let v30 = v27 + v28;
    let v31 = v29 + v30;
    let v34 = aw - ew;
    let v35 = v31 - v34;
    let v36 = v12 * v12;
    let v37 = v13 * v13;
    let v38 = v14 * v14;
    let v39 = v36 + v37;
    let v40 = v38 + v39;
    let v42 = bw - ew;
    let v43 = v40 - v42;
    let v44 = v18 * v18;
    let v45 = v19 * v19;
    let v46 = v20 * v20;
    let v47 = v44 + v45;
    let v48 = v46 + v47;
    let v50 = cw - ew;
    let v51 = v48 - v50;
    let v52 = v24 * v24;
    let v53 = v25 * v25;
    let v54 = v26 * v26;
    let v55 = v52 + v53;
    let v56 = v54 + v55;
    let v58 = dw - ew;
    let v59 = v56 - v58;
    let v60 = v18 * v25;
    let v61 = v19 * v24;
    let v62 = v60 - v61;
    let v63 = v14 * v62;
    let v64 = v12 * v25;
    let v65 = v13 * v24;
    let v66 = v64 - v65;
    let v67 = v20 * v66;
    let v68 = v12 * v19;
    let v69 = v13 * v18;
    let v70 = v68 - v69;
    let v71 = v26 * v70;
    let v72 = v63 - v67;
    let v73 = v71 + v72;
    let v74 = v35 * v73;
    let v75 = v8 * v62;
    let v76 = v6 * v25;
    let v77 = v7 * v24;
    let v78 = v76 - v77;
    let v79 = v20 * v78;
    let v80 = v6 * v19;
    let v81 = v7 * v18;
    let v82 = v80 - v81;
    let v83 = v26 * v82;
    let v84 = v75 - v79;
    let v85 = v83 + v84;
    let v86 = v43 * v85;
    let v87 = v8 * v66;
    let v88 = v14 * v78;
    let v89 = v6 * v13;
    let v90 = v7 * v12;
    let v91 = v89 - v90;
    let v92 = v26 * v91;
    let v93 = v87 - v88;
    let v94 = v92 + v93;
    let v95 = v51 * v94;
    let v96 = v8 * v70;
    let v97 = v14 * v82;
    let v98 = v20 * v91;
    let v99 = v96 - v97;
    let v100 = v98 + v99;
    let v101 = v59 * v100;
    let v102 = v86 - v74;
    let v103 = v101 - v95;
    let v104 = v102 + v103;
    let m35 = v31 + v34.abs();
    let m43 = v40 + v42.abs();
    let m51 = v48 + v50.abs();
    let m59 = v56 + v58.abs();
    let m62 = v60.abs() + v61.abs();
    let m63 = v14.abs() * m62;
    let m66 = v64.abs() + v65.abs();
    let m67 = v20.abs() * m66;
    let m70 = v68.abs() + v69.abs();
    let m71 = v26.abs() * m70;
    let m72 = m63 + m67;
    let m73 = m71 + m72;
    let m74 = m35 * m73;
    let m75 = v8.abs() * m62;
    let m78 = v76.abs() + v77.abs();
    let m79 = v20.abs() * m78;
    let m82 = v80.abs() + v81.abs();
    let m83 = v26.abs() * m82;
    let m84 = m75 + m79;
    let m85 = m83 + m84;
    let m86 = m43 * m85;
    let m87 = v8.abs() * m66;
    let m88 = v14.abs() * m78;
    let m91 = v89.abs() + v90.abs();
    let m92 = v26.abs() * m91;
    let m93 = m87 + m88;
    let m94 = m92 + m93;
    let m95 = m51 * m94;
    let m96 = v8.abs() * m70;
    let m97 = v14.abs() * m82;
    let m98 = v20.abs() * m91;
    let m99 = m96 + m97;
    let m100 = m98 + m99;
    let m101 = m59 * m100;
    let m102 = m86 + m74;
    let m103 = m101 + m95;
    let m104 = m102 + m103;
    let sum = (((v6.abs() + v7.abs()) + (v8.abs() + v12.abs())) + ((v13.abs() + v14.abs()) + (v18.abs() + v19.abs()))) + (((v20.abs() + v24.abs()) + (v25.abs() + v26.abs())) + ((v34.abs() + v42.abs()) + (v50.abs() + v58.abs())));
    [v104, 1.7763568394002576e-15 * m104 + SIGMA * (1.0 + sum * sum * sum)]
}

fn orient4d(points: &[&[f64]]) -> f64 {
    let &[&[ax, ay, az, aw], &[bx, by, bz, bw], &[cx, cy, cz, cw], &[dx, dy, dz, dw], &[ex, ey, ez, ew]] = points else {
        return f64::NAN;
    };
    let v6 = ax - ex;
    let v7 = ay - ey;
    let v8 = az - ez;
    let v11 = aw - ew;
    let v15 = bx - ex;
    let v16 = by - ey;
    let v17 = bz - ez;
    let v19 = bw - ew;
    let v23 = cx - ex;
    let v24 = cy - ey;
    let v25 = cz - ez;
    let v27 = cw - ew;
    let v31 = dx - ex;
    let v32 = dy - ey;
    let v33 = dz - ez;
    let v35 = dw - ew;
    let v36 = v23 * v32;
    let v37 = v24 * v31;
    let v38 = v36 - v37;
    let v39 = v17 * v38;
    let v40 = v15 * v32;
    let v41 = v16 * v31;
    let v42 = v40 - v41;
    let v43 = v25 * v42;
    let v44 = v15 * v24;
    let v45 = v16 * v23;
    let v46 = v44 - v45;
    let v47 = v33 * v46;
    let v48 = v39 - v43;
    let v49 = v47 + v48;
    let v50 = v11 * v49;
    let v51 = v8 * v38;
    let v52 = v6 * v32;
    let v53 = v7 * v31;
    let v54 = v52 - v53;
    let v55 = v25 * v54;
    let v56 = v6 * v24;
    let v57 = v7 * v23;
    let v58 = v56 - v57;
    let v59 = v33 * v58;
    let v60 = v51 - v55;
    let v61 = v59 + v60;
    let v62 = v19 * v61;
    let v63 = v8 * v42;
    let v64 = v17 * v54;
    let v65 = v6 * v16;
    let v66 = v7 * v15;
    let v67 = v65 - v66;
    let v68 = v33 * v67;
    let v69 = v63 - v64;
    let v70 = v68 + v69;
    let v71 = v27 * v70;
    let v72 = v8 * v46;
    let v73 = v17 * v58;
    let v74 = v25 * v67;
    let v75 = v72 - v73;
    let v76 = v74 + v75;
    let v77 = v35 * v76;
    let v78 = v62 - v50;
    let v79 = v77 - v71;
    let v80 = v78 + v79;
    v80
}

fn bounded_orient4d(points: &[&[f64]]) -> [f64; 2] {
    let &[&[ax, ay, az, aw], &[bx, by, bz, bw], &[cx, cy, cz, cw], &[dx, dy, dz, dw], &[ex, ey, ez, ew]] = points else {
        return [0.0, f64::NAN];
    };
    let v6 = ax - ex;
    let v7 = ay - ey;
    let v8 = az - ez;
    let v11 = aw - ew;
    let v15 = bx - ex;
    let v16 = by - ey;
    let v17 = bz - ez;
    let v19 = bw - ew;
    let v23 = cx - ex;
    let v24 = cy - ey;
    let v25 = cz - ez;
    let v27 = cw - ew;
    let v31 = dx - ex;
    let v32 = dy - ey;
    let v33 = dz - ez;
    let v35 = dw - ew;
    let v36 = v23 * v32;
    let v37 = v24 * v31;
    let v38 = v36 - v37;
    let v39 = v17 * v38;
    let v40 = v15 * v32;
    let v41 = v16 * v31;
    let v42 = v40 - v41;
    let v43 = v25 * v42;
    let v44 = v15 * v24;
    let v45 = v16 * v23;
    let v46 = v44 - v45;
    let v47 = v33 * v46;
    let v48 = v39 - v43;
    let v49 = v47 + v48;
    let v50 = v11 * v49;
    let v51 = v8 * v38;
    let v52 = v6 * v32;
    let v53 = v7 * v31;
    let v54 = v52 - v53;
    let v55 = v25 * v54;
    let v56 = v6 * v24;
    let v57 = v7 * v23;
    let v58 = v56 - v57;
    let v59 = v33 * v58;
    let v60 = v51 - v55;
    let v61 = v59 + v60;
    let v62 = v19 * v61;
    let v63 = v8 * v42;
    let v64 = v17 * v54;
    let v65 = v6 * v16;
    let v66 = v7 * v15;
    let v67 = v65 - v66;
    let v68 = v33 * v67;
    let v69 = v63 - v64;
    let v70 = v68 + v69;
    let v71 = v27 * v70;
    let v72 = v8 * v46;
    let v73 = v17 * v58;
    let v74 = v25 * v67;
    let v75 = v72 - v73;
    let v76 = v74 + v75;
    let v77 = v35 * v76;
    let v78 = v62 - v50;
    let v79 = v77 - v71;
    let v80 = v78 + v79;
    let m38 = v36.abs() + v37.abs();
    let m39 = v17.abs() * m38;
    let m42 = v40.abs() + v41.abs();
    let m43 = v25.abs() * m42;
    let m46 = v44.abs() + v45.abs();
    let m47 = v33.abs() * m46;
    let m48 = m39 + m43;
    let m49 = m47 + m48;
    let m50 = v11.abs() * m49;
    let m51 = v8.abs() * m38;
    let m54 = v52.abs() + v53.abs();
    let m55 = v25.abs() * m54;
    let m58 = v56.abs() + v57.abs();
    let m59 = v33.abs() * m58;
    let m60 = m51 + m55;
    let m61 = m59 + m60;
    let m62 = v19.abs() * m61;
    let m63 = v8.abs() * m42;
    let m64 = v17.abs() * m54;
    let m67 = v65.abs() + v66.abs();
    let m68 = v33.abs() * m67;
    let m69 = m63 + m64;
    let m70 = m68 + m69;
    let m71 = v27.abs() * m70;
    let m72 = v8.abs() * m46;
    let m73 = v17.abs() * m58;
    let m74 = v25.abs() * m67;
    let m75 = m72 + m73;
    let m76 = m74 + m75;
    let m77 = v35.abs() * m76;
    let m78 = m62 + m50;
    let m79 = m77 + m71;
    let m80 = m78 + m79;
    let sum = (((v6.abs() + v7.abs()) + (v8.abs() + v11.abs())) + ((v15.abs() + v16.abs()) + (v17.abs() + v19.abs()))) + (((v23.abs() + v24.abs()) + (v25.abs() + v27.abs())) + ((v31.abs() + v32.abs()) + (v33.abs() + v35.abs())));
    [v80, 1.2212453270876757e-15 * m80 + SIGMA * (1.0 + sum * sum)]
}
