//! The parallel projection from space to the plane of a picture: parallel lines stay parallel, and lengths can be
//! compared.

use super::Offset;

/// The view direction of a drawing in space.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Look {
    /// Degrees around the vertical axis, from the direction of -y.
    pub azimuth: f64,
    /// Degrees above the horizon.
    pub elevation: f64,
}

impl Default for Look {
    /// The view from the front, the right and above.
    fn default() -> Look {
        Look { azimuth: 30.0, elevation: 25.0 }
    }
}

impl Look {
    /// The unit vectors to the right, up and towards the eye.
    pub(super) fn axes(self) -> [Offset; 3] {
        let ((sa, ca), (se, ce)) = (self.azimuth.to_radians().sin_cos(), self.elevation.to_radians().sin_cos());
        let towards = [sa * ce, -ca * ce, se];
        let right = [ca, sa, 0.0];
        let up = [-sa * se, ca * se, ce];
        [right, up, towards]
    }
}

pub(super) fn dot(a: Offset, b: Offset) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The unit normal of three points; `None` if they are collinear.
pub(super) fn normal([a, b, c]: [Offset; 3]) -> Option<Offset> {
    let [u, v] = [b, c].map(|p| [p[0] - a[0], p[1] - a[1], p[2] - a[2]]);
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = dot(n, n).sqrt();
    (length > 0.0 && length.is_finite()).then(|| n.map(|x| x / length))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn right_up_and_towards_the_eye_are_a_right_handed_frame() {
        for look in [Look::default(), Look { azimuth: 0.0, elevation: 0.0 }, Look { azimuth: -110.0, elevation: 89.0 }]
        {
            let [right, up, towards] = look.axes();
            for (a, b) in [(right, up), (up, towards), (towards, right)] {
                assert!(dot(a, b).abs() < 1e-15, "{look:?}");
            }
            let across = normal([[0.0; 3], right, up]).unwrap();
            assert!((dot(across, towards) - 1.0).abs() < 1e-15, "{look:?}");
        }
        // From the front x is right and z is up.
        assert_eq!(Look { azimuth: 0.0, elevation: 0.0 }.axes()[..2], [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
    }

    #[test]
    fn points_in_a_line_have_no_normal() {
        assert_eq!(normal([[0.0; 3], [1.0, 1.0, 1.0], [3.0, 3.0, 3.0]]), None);
        assert_eq!(normal([[0.0; 3], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0]]), Some([0.0, 0.0, 1.0]));
    }
}
