//! Scenes of directions on the sphere: their lengths, their ties, and their turns by another predicate.

use predicament_corpus::{Level, Library};
use predicament_formats::Cache;
use predicament_judge as judge;
use predicament_predicates::{Dimension, Question, Scene, Sign, Vertex};

use crate::common::queries;

/// The turn of three directions as the side of the origin below their plane, by the judge of orient3d.
fn below(scene: &Scene, args: &[Vertex]) -> Sign {
    let corners = args.iter().flat_map(|v| scene.point(*v)).copied();
    let with_origin = Scene::new(Dimension::Three, corners.chain([0.0; 3]).collect()).unwrap();
    judge::sign(&with_origin, Question::Orient3d, &[0, 1, 2, 3].map(Vertex::input))
}

#[test]
fn turns_on_the_sphere_are_sides_of_the_origin() {
    let suite = Library::embedded(predicament_bundle::vocabulary()).unwrap().suite("sphere").unwrap();
    let mut ties = Vec::new();
    for def in &suite.scenes {
        let loaded = def.load(Level::Quick, &Cache::new("nowhere")).unwrap();
        let (scene, queries) = (&loaded.scene, queries(&loaded));
        for v in scene.vertices() {
            let length = scene.point(v).iter().map(|x| x * x).sum::<f64>().sqrt();
            assert!((length - 1.0).abs() < 16.0 * f64::EPSILON, "{}: {v} is {length} long", loaded.name);
        }
        let mut zeros = 0;
        for query in 0..queries.len() {
            let args = queries.args(query);
            let sign = judge::sign(scene, queries.question(), args);
            assert_eq!(sign, below(scene, args), "{} {args:?}", loaded.name);
            let turned = [args[1], args[0], args[2]];
            assert!(sign.is_zero() || sign != below(scene, &turned), "a turn the other way is another sign");
            zeros += usize::from(sign.is_zero());
        }
        ties.push((loaded.name.clone(), zeros * 100 / queries.len()));
    }
    let share =
        |figure: &str| ties.iter().find(|(name, _)| name.contains(figure)).unwrap_or_else(|| panic!("{ties:?}")).1;
    assert_eq!((share("great-circle"), share("general")), (100, 0));
    assert!((40..70).contains(&share("antipodal")) && share("midpoint") < 20 && share("axes") > 30, "{ties:?}");
}
