//! The check that the volumes of the parts add up.

use rug::Rational;

use super::crossing::Near;
use super::{Check, Flaws, Piece, Slices};
use predicament_judge::sum::sum;

impl Slices {
    /// Compares the sum of the parts' volumes with the mesh's, face by face and plane by plane.
    pub(super) fn volumes(&self, near: &Near<'_>, flaws: &mut Flaws) {
        let of = |triangle| near.rows.volume(triangle);
        let mut by_face: Vec<Vec<Rational>> = vec![Vec::new(); self.faces.len()];
        let mut by_plane: Vec<Vec<Rational>> = vec![Vec::new(); self.planes.len() + 1];
        let (mut whole, mut parts) = (Vec::new(), Vec::new());
        for (corners, terms) in self.faces.iter().zip(&mut by_face) {
            for next in corners.windows(2).skip(1) {
                let term = of([corners[0], next[0], next[1]]);
                terms.push(Rational::from(-&term));
                whole.push(term);
            }
        }
        for part in &self.parts {
            for (&triangle, piece) in part.triangles.iter().zip(&part.pieces) {
                let terms = match *piece {
                    Piece::Face(face) => &mut by_face[face],
                    Piece::Cap(place) => &mut by_plane[place],
                    Piece::Cover => &mut by_plane[self.planes.len()],
                };
                terms.push(of(triangle));
            }
        }
        parts.extend(by_face.into_iter().map(sum));
        parts.extend(by_plane.into_iter().map(sum));
        let missing = sum(parts);
        if !missing.is_zero() {
            let [missing, whole] = [missing, sum(whole)].map(|six| six.to_f64() / 6.0);
            flaws.add(Check::Volume, &[], || {
                format!("the parts have about {missing:e} more volume than the mesh, which has {whole:e}")
            });
        }
    }
}
