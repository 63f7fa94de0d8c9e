//! The share of features that survives, by size.

use predicament_corpus::Random;
use predicament_mesh::Complex;
use predicament_predicates::{Dimension, Scene};
use predicament_tasks::AnswerError;
use rayon::prelude::*;

use super::features::Feature;
use super::pose::Pose;
use super::{Ask, LENGTHS};
use crate::Precision;

/// The number of sizes per decade.
const STEPS: i32 = 20;
/// The decades of sizes: from sizes where everything is lost to the largest feature.
const DECADES: std::ops::RangeInclusive<i32> = -9..=0;

/// The share of one feature that survives, by size.
#[derive(Clone, PartialEq, Debug)]
pub struct Survey {
    /// Each size, in units of L, with the share of positions in which the feature survived.
    pub shares: Vec<(f64, f64)>,
}

impl Survey {
    /// The size from which on the feature survives everywhere; `None` if not even the largest did.
    #[must_use]
    pub fn safe(&self) -> Option<f64> {
        let kept = self.shares.iter().rev().take_while(|(_, share)| *share >= 1.0);
        kept.last().map(|&(size, _)| size)
    }

    /// The largest size at which it survives nowhere; `None` if some survived at every size.
    #[must_use]
    pub fn lost(&self) -> Option<f64> {
        self.shares.iter().rev().find(|(_, share)| *share <= 0.0).map(|&(size, _)| size)
    }
}

/// Queries a feature in `trials` positions at each size.
///
/// `length` is the backend's L if the primitives of the two meshes add up to 1.
///
/// # Errors
/// [`AnswerError`] if the backend declines.
pub fn survey(
    feature: &Feature,
    ask: &Ask,
    length: f64,
    precision: Precision,
    trials: u32,
    seed: u64,
) -> Result<Survey, AnswerError> {
    let sizes: Vec<(i32, f64)> = (DECADES.start() * STEPS..=DECADES.end() * STEPS)
        .map(|step| (step, 10_f64.powf(f64::from(step) / f64::from(STEPS))))
        .filter(|&(_, size)| size <= feature.most)
        .collect();
    let shares = sizes.par_iter().map(|&(step, size)| {
        let task = format!("{}-{step}", feature.dimension.count());
        let mut random = Random::new(feature.name, &task, seed);
        let mut survivors = 0_u32;
        for _ in 0..trials {
            let (scene, a, b) = place(feature, size * length, precision, &mut random);
            survivors += u32::from(feature.survives(&ask(&scene, &a, &b)?));
        }
        Ok((size, f64::from(survivors) / f64::from(trials)))
    });
    Ok(Survey { shares: shares.collect::<Result<_, AnswerError>>()? })
}

/// The feature, randomly rotated.
fn place(feature: &Feature, size: f64, precision: Precision, random: &mut Random) -> (Scene, Complex, Complex) {
    let shape = (feature.shape)(size);
    let scene = match feature.dimension {
        Dimension::Two => {
            let pose = Pose::of_plane(random);
            let points: Vec<[f64; 2]> =
                shape.points.iter().map(|&point| pose.turn(point, precision)).map(|[x, y, _]| [x, y]).collect();
            Scene::from_points2(&points)
        }
        Dimension::Three => {
            let pose = Pose::of_space(random);
            let points: Vec<[f64; 3]> = shape.points.iter().map(|&point| pose.turn(point, precision)).collect();
            Scene::from_points3(&points)
        }
    };
    let scene = scene.expect("features are finite").with_primitive_lengths(LENGTHS);
    let complex = |given| Complex::new(&scene, given).expect("features are complexes");
    let (a, b) = (complex(&shape.a), complex(&shape.b));
    let scene = scene.with_second_mesh(b.vertices().iter().copied());
    (scene, a, b)
}

#[cfg(test)]
mod tests {
    use predicament_contacts::algorithm::pairs::contacts;
    use predicament_exact::Exact;
    use predicament_predicates::{Backend, Off};

    use super::super::FEATURES;
    use super::*;

    fn exactly(
        scene: &Scene,
        a: &Complex,
        b: &Complex,
    ) -> Result<predicament_contacts::algorithm::pairs::Contacts, AnswerError> {
        Ok(contacts(&Exact.prepare(scene, Off).expect("a scene of doubles"), a, b))
    }

    #[test]
    fn exact_arithmetic_keeps_what_rounding_keeps() {
        for feature in FEATURES {
            let survey = survey(feature, &exactly, 1.0, Precision::Double, 4, 1).unwrap();
            assert_eq!(survey.safe(), Some(1e-9), "{} in {:?}", feature.name, feature.dimension);
            assert_eq!(survey.lost(), None);
        }
    }

    #[test]
    fn what_is_not_registered_as_itself_is_lost() {
        let tooth = FEATURES.iter().find(|feature| feature.name == "tooth through edge").unwrap();
        let nothing = |_: &Scene, _: &Complex, _: &Complex| Ok(Default::default());
        let lost = survey(tooth, &nothing, 1.0, Precision::Double, 2, 1).unwrap();
        assert_eq!((lost.safe(), lost.shares.iter().map(|s| s.1).sum::<f64>()), (None, 0.0));
        assert_eq!(lost.lost(), lost.shares.last().map(|share| share.0));
        let declined = |_: &Scene, _: &Complex, _: &Complex| Err(AnswerError::Stopped);
        assert_eq!(survey(tooth, &declined, 1.0, Precision::Double, 2, 1), Err(AnswerError::Stopped));
    }

    #[test]
    fn single_precision_loses_a_vertex_beside_an_edge_at_its_rounding() {
        let beside = FEATURES.iter().find(|feature| feature.name == "vertex beside edge").unwrap();
        let survey = survey(beside, &exactly, 1.0, Precision::Single, 50, 1).unwrap();
        assert_eq!(survey.safe(), Some(1e-9), "off the edge on either side is still off");
    }
}
