//! The vertices that a scene constructs.
//!
//! A list of constructions has each definition once. Definitions are checked and added in groups: a session constructs
//! millions of vertices in one call, and clones share the list until one of them adds to it.

use alloc::sync::Arc;
use alloc::vec::Vec;

use super::{Dimension, Scene};
use crate::{Construction, ConstructionError, DefinitionError, Refused, Vertex};

impl Scene {
    /// The vertex that this construction defines: a new vertex, or the existing vertex of the same definition.
    ///
    /// Definitions that differ only in order have the same vertex.
    ///
    /// # Errors
    /// [`ConstructionError`] if the construction is for another dimension, names a vertex that the scene lacks, names a
    /// vertex twice in one line or plane, or if there are too many constructions already.
    pub fn construct(&mut self, construction: Construction) -> Result<Vertex, ConstructionError> {
        let construction = self.checked(construction)?;
        match self.constructions.find(&construction) {
            Some(vertex) => Ok(vertex),
            None => Arc::make_mut(&mut self.constructions).push(construction).ok_or(ConstructionError::TooMany),
        }
    }

    /// Constructs many vertices, in order: all of them, or none.
    ///
    /// The method calls `admit` for each new vertex, in their order. There a session computes the point, or says why
    /// there is none. The scene that it gets has the vertex, and may have some of the later ones. Definitions may name
    /// vertices that earlier definitions of the call define.
    ///
    /// # Errors
    /// [`Refused::Definition`] for the first definition that the scene or `admit` does not take. The scene is then
    /// unchanged; the caller must remove whatever `admit` has stored for earlier vertices.
    pub fn construct_all(
        &mut self,
        definitions: &[Construction],
        mut admit: impl FnMut(&Scene, Vertex) -> Result<(), DefinitionError>,
    ) -> Result<Vec<Vertex>, Refused> {
        let before = self.constructions.list().len();
        let mut vertices = Vec::with_capacity(definitions.len());
        while vertices.len() < definitions.len() {
            let (done, mut next) = (vertices.len(), self.constructions.list().len());
            let mut error = self.add_some(&definitions[done..], &mut vertices).map_err(DefinitionError::from);
            for at in done..vertices.len() {
                if vertices[at].construction() == Some(next) {
                    next += 1;
                    if let Err(reason) = admit(self, vertices[at]) {
                        vertices.truncate(at);
                        error = Err(reason);
                        break;
                    }
                }
            }
            if let Err(reason) = error {
                if self.constructions.list().len() > before {
                    Arc::make_mut(&mut self.constructions).truncate(before);
                }
                let index = vertices.len();
                return Err(Refused::Definition { index, definition: definitions[index], reason });
            }
        }
        Ok(vertices)
    }

    /// Adds the vertices of the first definitions: those that exist already, then some of the others, or those before
    /// an error.
    fn add_some(&mut self, definitions: &[Construction], added: &mut Vec<Vertex>) -> Result<(), ConstructionError> {
        let mut left = definitions.iter();
        let first = loop {
            let Some(&definition) = left.next() else { return Ok(()) };
            let definition = self.checked(definition)?;
            match self.constructions.find(&definition) {
                Some(vertex) => added.push(vertex),
                None => break definition,
            }
        };
        let (dimension, inputs) = (self.dimension, self.len());
        let list = Arc::make_mut(&mut self.constructions);
        list.reserve(left.len() + 1);
        added.push(list.push(first).ok_or(ConstructionError::TooMany)?);
        for &definition in left.take(TOGETHER) {
            let definition = canonical(definition, dimension, [inputs, list.list().len()]);
            let Some(vertex) = definition.and_then(|definition| list.intern(definition)) else {
                break;
            };
            added.push(vertex);
        }
        Ok(())
    }

    /// The canonical form of a construction, if the scene can take it.
    #[inline]
    fn checked(&self, construction: Construction) -> Result<Construction, ConstructionError> {
        let counts = [self.len(), self.constructions.list().len()];
        canonical(construction, self.dimension, counts).ok_or_else(|| self.why_not(construction))
    }

    /// The error of a construction.
    #[cold]
    #[inline(never)]
    fn why_not(&self, construction: Construction) -> ConstructionError {
        if let Some(of) = construction.dimension()
            && of != self.dimension
        {
            return ConstructionError::Dimension { scene: self.dimension, construction: of };
        }
        let construction = construction.canonical();
        let faults = construction.flats().find_map(|flat| {
            let missing = flat.iter().find(|&&vertex| !self.has(vertex));
            let repeated = flat.windows(2).find(|pair| pair[0] == pair[1]);
            match (missing, repeated) {
                (Some(&vertex), _) => Some(ConstructionError::Missing { vertex }),
                (None, Some(pair)) => Some(ConstructionError::Repeated { vertex: pair[0] }),
                (None, None) => None,
            }
        });
        faults.expect("its lines and planes do not have vertices of the scene, each once")
    }
}

/// The number of new vertices that are added together.
const TOGETHER: usize = 256;

/// The canonical form of a construction, if it is one of a scene with these counts of input and constructed vertices.
#[inline(always)]
fn canonical(construction: Construction, dimension: Dimension, counts: [usize; 2]) -> Option<Construction> {
    if construction.dimension().is_some_and(|of| of != dimension) {
        return None;
    }
    let construction = construction.canonical();
    let is_spanned = match &construction {
        Construction::Ssi([first, second]) => spans(first, counts) & spans(second, counts),
        Construction::Lpi { line, plane } => spans(line, counts) & spans(plane, counts),
        Construction::Tpi([p, q, r]) => spans(p, counts) & spans(q, counts) & spans(r, counts),
        Construction::Ratio { ends, .. } => spans(ends, counts),
    };
    is_spanned.then_some(construction)
}

/// Returns true if the vertices are in range for these counts of input and constructed vertices, distinct and sorted.
#[inline(always)]
fn spans<const N: usize>(flat: &[Vertex; N], [inputs, constructed]: [usize; 2]) -> bool {
    let known = flat.iter().all(|v| match v.construction() {
        None => v.index() < inputs,
        Some(index) => index < constructed,
    });
    // Sorted, so equal vertices would be adjacent.
    known & (1..N).all(|i| flat[i - 1] < flat[i])
}

#[cfg(test)]
mod tests {
    use alloc::string::ToString;
    use alloc::{vec, vec::Vec};

    use super::*;
    use crate::NoPoint;

    #[test]
    fn constructions_are_interned_by_definition() {
        let mut scene = Scene::from_points2(&[[0.0, 0.0], [2.0, 2.0], [0.0, 2.0], [2.0, 0.0], [1.0, 1.0]]).unwrap();
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(Vertex::input);
        let x = scene.construct(Construction::Ssi([[a, b], [c, d]])).unwrap();
        let y = scene.construct(Construction::Ssi([[a, e], [c, d]])).unwrap();
        assert_eq!([x, y], [0, 1].map(Vertex::constructed), "the same point, by other lines");
        assert_eq!(scene.construct(Construction::Ssi([[d, c], [b, a]])), Ok(x));
        assert_eq!(scene.construction(x), Some(&Construction::Ssi([[a, b], [c, d]])));
        assert_eq!(scene.constructions().len(), 2);
        assert_eq!((scene.construction(a), scene.construction(Vertex::constructed(2))), (None, None));
        assert_eq!((scene.len(), scene.vertices().len()), (5, 5), "constructed vertices are not input");
    }

    #[test]
    fn constructions_that_make_no_sense_are_refused() {
        let mut scene = Scene::from_points3(&[[0.0; 3]; 6]).unwrap();
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(Vertex::input);
        let lpi = |line, plane| Construction::Lpi { line, plane };
        let outside = Vertex::input(6);
        assert_eq!(scene.construct(lpi([a, a], [b, c, d])), Err(ConstructionError::Repeated { vertex: a }));
        assert_eq!(scene.construct(lpi([a, b], [d, c, d])), Err(ConstructionError::Repeated { vertex: d }));
        assert_eq!(scene.construct(lpi([a, outside], [b, c, d])), Err(ConstructionError::Missing { vertex: outside }));
        let later = Vertex::constructed(0);
        assert_eq!(scene.construct(lpi([a, later], [b, c, d])), Err(ConstructionError::Missing { vertex: later }));
        assert!(matches!(
            scene.construct(Construction::Ssi([[a, b], [c, d]])),
            Err(ConstructionError::Dimension { .. })
        ));
        let x = scene.construct(lpi([a, b], [c, d, e])).expect("whether they meet is not the scene's business");
        assert_eq!(x, later);
        let on_itself = lpi([a, Vertex::constructed(1)], [b, c, d]);
        let missing = scene.construct(on_itself).unwrap_err();
        assert_eq!(missing.to_string(), "c1 is not constructed before");
        assert_eq!(scene.constructions().len(), 1);
    }

    #[test]
    fn constructions_stand_on_earlier_ones() {
        let mut scene = Scene::from_points3(&[[0.0; 3]; 6]).unwrap();
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(Vertex::input);
        let x = scene.construct(Construction::Lpi { line: [a, b], plane: [c, d, e] }).unwrap();
        let y = scene.construct(Construction::Tpi([[x, b, a], [a, b, d], [c, d, x]])).unwrap();
        assert_eq!([x, y], [0, 1].map(Vertex::constructed));
        assert_eq!(scene.constructions().iter().map(Construction::is_of_inputs).collect::<Vec<_>>(), [true, false]);
        assert_eq!(scene.constructions()[1].to_string(), "TPI(0 1 3, 0 1 c0, 2 3 c0)");
        assert!(scene.has(y) && scene.has(e) && !scene.has(Vertex::constructed(2)) && !scene.has(Vertex::input(6)));
    }

    #[test]
    fn many_are_constructed_in_order_or_none_of_them() {
        let mut scene = Scene::from_points2(&[[0.0, 0.0], [2.0, 2.0], [0.0, 2.0], [2.0, 0.0], [1.0, 1.0]]).unwrap();
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(Vertex::input);
        let [x, y, z] = [0, 1, 2].map(Vertex::constructed);
        let ssi = |p, q| Construction::Ssi([p, q]);
        assert_eq!(scene.construct(ssi([a, b], [c, d])), Ok(x));
        let copy = scene.clone();
        let definitions = [ssi([a, e], [c, d]), ssi([c, d], [b, a]), ssi([x, e], [y, a]), ssi([e, a], [d, c])];
        let mut admitted = Vec::new();
        let vertices = scene.construct_all(&definitions, |scene, vertex| {
            assert!(scene.has(vertex));
            admitted.push(vertex);
            Ok(())
        });
        assert_eq!((vertices, admitted), (Ok(vec![y, x, z, y]), vec![y, z]));
        assert_eq!(copy.constructions().len(), 1, "a clone keeps its own");

        let mut again = copy.clone();
        let refused =
            again.construct_all(
                &definitions,
                |_, vertex| {
                    if vertex == z { Err(NoPoint::ParallelLines.into()) } else { Ok(()) }
                },
            );
        let refused = refused.unwrap_err();
        assert_eq!(
            refused,
            Refused::Definition { index: 2, definition: definitions[2], reason: NoPoint::ParallelLines.into() }
        );
        assert_eq!(again, copy);
        assert_eq!(again.construct_all(&definitions[2..], |_, _| Ok(())).unwrap_err().index(), Some(0), "c1 is gone");
        assert_eq!(again.construct(ssi([x, b], [c, d])), Ok(y), "its id is free");
        assert_eq!(again.construct_all(&definitions[..2], |_, _| Ok(())), Ok(vec![z, x]), "so is its definition");
    }
}
