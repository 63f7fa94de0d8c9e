//! The planes of the faces along one axis, from comparisons alone.

use predicament_predicates::{Axis, Sign};

use crate::algorithm::order::{Face, Order};

/// The planes along one axis, ascending.
pub(super) struct Levels {
    /// The faces in each plane.
    pub(super) faces: Vec<Vec<Face>>,
    /// For each cube, the numbers of the planes of its lower and its upper face.
    pub(super) of: Vec<[u32; 2]>,
}

impl Levels {
    /// Sorts the faces of this number of cubes. Faces that compare as equal are in one plane.
    ///
    /// Each face is looked up among the planes of the faces before it. So an order that contradicts itself makes wrong
    /// planes, but does not disturb the search.
    pub(super) fn new<O: Order>(order: &O, axis: Axis, cubes: u32) -> Levels {
        let mut faces: Vec<Vec<Face>> = Vec::new();
        for face in (0..cubes).flat_map(|cube| [false, true].map(|upper| Face { cube, upper })) {
            let [mut low, mut high] = [0, faces.len()];
            let mut plane = None;
            while low < high && plane.is_none() {
                let middle = usize::midpoint(low, high);
                match order.compare(axis, face, faces[middle][0]) {
                    Sign::Negative => high = middle,
                    Sign::Zero => plane = Some(middle),
                    Sign::Positive => low = middle + 1,
                }
            }
            match plane {
                Some(plane) => faces[plane].push(face),
                None => faces.insert(low, vec![face]),
            }
        }
        let mut of = vec![[0; 2]; cubes as usize];
        for (plane, faces) in (0..).zip(&faces) {
            faces.iter().for_each(|face| of[face.cube as usize][usize::from(face.upper)] = plane);
        }
        Levels { faces, of }
    }

    /// The number of planes. (The tables of the general algorithm, which comes first, do not hold 2^31 cubes.)
    pub(super) fn count(&self) -> u32 {
        u32::try_from(self.faces.len()).unwrap_or_else(|_| unreachable!("two faces for each cube"))
    }

    /// True if the cube's upper face is beyond its lower one.
    pub(super) fn is_solid(&self, cube: u32) -> bool {
        let [lower, upper] = self.of[cube as usize];
        lower < upper
    }

    /// True if the plane meets the cube, ends included.
    #[inline]
    pub(super) fn meets(&self, cube: u32, plane: u32) -> bool {
        let [lower, upper] = self.of[cube as usize];
        lower <= plane && plane <= upper
    }

    /// The sides of a plane on which the cube is: bit 0 for the lower side, bit 1 for the upper one.
    #[inline]
    pub(super) fn sides(&self, cube: u32, plane: u32) -> u8 {
        let [lower, upper] = self.of[cube as usize];
        u8::from(lower < plane) | u8::from(plane < upper) << 1
    }

    /// The cubes by their lower faces (end 0) or by their upper ones (end 1).
    pub(super) fn sorted(&self, cubes: &[u32], end: usize) -> Vec<u32> {
        let mut sorted = cubes.to_vec();
        sorted.sort_by_key(|&cube| self.of[cube as usize][end]);
        sorted
    }

    /// Takes the first of these cubes, as long as their face at this end is in the plane.
    pub(super) fn take<'c>(&self, cubes: &mut &'c [u32], end: usize, plane: u32) -> &'c [u32] {
        let count = cubes.iter().take_while(|&&cube| self.of[cube as usize][end] == plane).count();
        let (taken, left) = cubes.split_at(count);
        *cubes = left;
        taken
    }

    /// The first and the last plane of the cubes; of no cubes, a last plane before the first.
    pub(super) fn hull<'c>(&self, cubes: impl Iterator<Item = &'c u32>) -> [u32; 2] {
        let join = |[first, last]: [u32; 2], [lower, upper]: [u32; 2]| [first.min(lower), last.max(upper)];
        cubes.map(|&cube| self.of[cube as usize]).fold([u32::MAX, 0], join)
    }
}
