//! Results of all operations as surfaces in rationals, and their comparison.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use predicament_exact::Exact;
use predicament_mesh::MaterialMesh;
use predicament_mesh_intersect::algorithm::limit::limit;
use predicament_mesh_intersect::algorithm::overlay::{Zeros, mesh_overlay};
use predicament_mesh_intersect::checks::chains::Chain;
use predicament_mesh_intersect::truth;
use predicament_overlay::algorithm::overlay::Operation;
use predicament_predicates::{Backend, Off, Predicates, Scene, Vertex};
use predicament_sos::PerMesh;
use rug::{Integer, Rational};

use super::shapes::Shape;
use super::volumes::{Point, Surface, volume};

/// The result of each operation, in the order of [`Operation::ALL`].
pub type Results = [Surface; 4];

fn in_rationals(scene: &Scene, triangles: &[[Vertex; 3]]) -> Surface {
    let points = truth::points(scene, scene.constructions()).unwrap();
    let place = |v: Vertex| points[v.construction().map_or(v.index(), |at| scene.len() + at)].clone();
    triangles.iter().map(|triangle| triangle.map(place)).collect()
}

/// The results of a session with exact zeros.
pub fn exactly(scene: &Scene, meshes: &[Arc<MaterialMesh>; 2]) -> Result<Results, String> {
    let mut session = Exact.prepare(scene, Off).unwrap();
    let overlay = mesh_overlay(&mut session, meshes.clone(), Zeros::Zero).map_err(|why| format!("exact: {why}"))?;
    Ok(Operation::ALL.map(|operation| in_rationals(session.scene(), &overlay.solid(operation).triangles)))
}

/// The results of a session that moves the second mesh, then their limits as the move goes to zero.
pub fn in_the_limit(scene: &Scene, meshes: &[Arc<MaterialMesh>; 2]) -> Result<Results, String> {
    let mut moving = PerMesh.prepare(scene, Off).unwrap();
    let overlay = mesh_overlay(&mut moving, meshes.clone(), Zeros::Zero).map_err(|why| format!("sos: {why}"))?;
    let perturbed = moving.scene().clone();
    let of = |operation: Operation| {
        let mut session = Exact.prepare(&perturbed, Off).unwrap();
        let limit = limit(&mut session, &overlay, overlay.solid(operation)).map_err(|why| format!("limit: {why}"))?;
        Ok(in_rationals(session.scene(), &limit.solid.triangles))
    };
    let results: Result<Vec<Surface>, String> = Operation::ALL.into_iter().map(of).collect();
    Ok(results?.try_into().unwrap())
}

/// True if a sum of surfaces, each so many times, is zero.
pub fn cancel(surfaces: &[(&Surface, i64)]) -> bool {
    let mut chain = Chain::default();
    for (surface, times) in surfaces {
        surface.iter().for_each(|triangle| chain.add(triangle.each_ref(), *times));
    }
    chain.rest().is_none()
}

/// The first operation with different results.
pub fn difference(first: &Results, second: &Results) -> Option<&'static str> {
    let is_different = |(_, (a, b)): &(Operation, (&Surface, &Surface))| !cancel(&[(*a, 1), (*b, -1)]);
    Operation::ALL.into_iter().zip(first.iter().zip(second)).find(is_different).map(|(operation, _)| operation.name())
}

/// Two shapes in one scene, the second of which may move.
pub fn pair(first: &Shape, second: &Shape) -> (Scene, [Arc<MaterialMesh>; 2]) {
    let pair = super::overlaid::Pair::without_truth(first.clone(), second.clone());
    let meshes = pair.meshes();
    (pair.scene, meshes)
}

/// The surface of a shape of one region.
pub fn surface(shape: &Shape) -> Surface {
    shape.boundary(1)
}

/// Shapes of integer coordinates, scaled by one number from surfaces in rationals; `None` if an integer has more than
/// 53 bits, or a surface is empty.
pub fn scaled<const N: usize>(surfaces: [&Surface; N]) -> Option<[Shape; N]> {
    let all = || surfaces.iter().copied().flatten().flatten().flatten();
    let denominator = all().fold(Integer::from(1), |sum, x| sum.lcm(x.denom()));
    let is_double = |x: &Rational| Rational::from(x * &denominator).numer().significant_bits() <= 53;
    if surfaces.iter().any(|surface| surface.is_empty()) || !all().all(is_double) {
        return None;
    }
    Some(surfaces.map(|surface| {
        let different: BTreeSet<&Point> = surface.iter().flatten().collect();
        let numbers: BTreeMap<&Point, usize> = different.iter().copied().zip(0..).collect();
        let points = different.iter().map(|p| p.each_ref().map(|x| Rational::from(x * &denominator).to_f64()));
        Shape::solid(points.collect(), surface.iter().map(|triangle| triangle.each_ref().map(|p| numbers[p])).collect())
    }))
}

/// The sum of volumes, each so many times.
pub fn sum_of_volumes(surfaces: &[(&Surface, i32)]) -> Rational {
    surfaces.iter().map(|(surface, times)| volume(surface) * *times).sum()
}
