//! Cascades: vertices constructed from constructed ones while the session runs, level upon level, each level judged.

use predicament_exact::{Exact, Session, constructed::Constructed};
use predicament_predicates::{
    Backend, Construction, Dimension, NoPoint, Off, Plane, Predicates, Refused, Scene, Sign, Vertex,
};

use super::{
    WILD,
    judge::{Judge, PLANES},
    scenes::{Seen, check_approximations, check_one, distinct, scene, share},
};
use crate::common::Random;

/// The growth of a cascade.
struct Growth {
    depth: usize,
    /// The number of vertices of a level.
    width: usize,
    /// True if some vertices are of three planes: their rows grow fastest.
    planes: bool,
}

/// Distinct vertices, each from the first list or the second.
fn pick<const N: usize>(random: &mut Random, [last, all]: [&[Vertex]; 2]) -> [Vertex; N] {
    loop {
        let picked: [Vertex; N] = std::array::from_fn(|_| {
            let from = if random.below(3) > 0 { last } else { all };
            *random.pick(from)
        });
        if (1..N).all(|i| !picked[..i].contains(&picked[i])) {
            return picked;
        }
    }
}

fn definition(random: &mut Random, dimension: Dimension, planes: bool, from: [&[Vertex]; 2]) -> Construction {
    match dimension {
        _ if random.below(5) == 0 => Construction::Ratio { ends: pick(random, from), share: share(random) },
        Dimension::Two => Construction::Ssi([pick(random, from), pick(random, from)]),
        Dimension::Three if planes && random.below(2) == 0 => {
            Construction::Tpi([pick(random, from), pick(random, from), pick(random, from)])
        }
        Dimension::Three => Construction::Lpi { line: pick(random, from), plane: pick(random, from) },
    }
}

/// Checks that lines and planes go through the vertices constructed on them.
fn check_incidence(session: &Session<'_, Off>, construction: &Construction, x: Vertex) {
    for flat in construction.flats() {
        match (session.scene().dimension(), flat) {
            (Dimension::Two, &[p, q]) => assert_eq!(session.orient2d(Plane::Xy, p, x, q), Sign::Zero),
            (_, &[p, q]) => PLANES.iter().for_each(|&plane| assert_eq!(session.orient2d(plane, p, q, x), Sign::Zero)),
            (_, &[p, q, r]) => assert_eq!(session.orient3d(p, q, x, r), Sign::Zero),
            _ => unreachable!("a line or a plane"),
        }
    }
}

/// Constructs level after level, and queries the vertices of each.
///
/// The judge says which definitions have a point; the session must refuse the others.
fn cascade(random: &mut Random, base: &Scene, growth: &Growth, seen: &mut Seen) -> usize {
    let mut session = Exact.prepare(base, Off).expect("prepared");
    let mut judge = Judge::new(base);
    let mut all: Vec<Vertex> = base.vertices().collect();
    let mut last = all.clone();
    let (mut definitions, mut refused) = (Vec::new(), 0);
    for _ in 0..growth.depth {
        let mut level = Vec::new();
        for _ in 0..8 * growth.width {
            let definition = definition(random, base.dimension(), growth.planes, [&last, &all]);
            let (before, point) = (session.scene().constructions().len(), judge.meet(&definition));
            match session.construct(&[definition]) {
                Err(why) => {
                    assert_eq!((why.index(), point), (Some(0), None), "{definition} in {:?}", session.scene());
                    assert_eq!(session.scene().constructions().len(), before);
                    refused += 1;
                }
                Ok(vertices) if session.scene().constructions().len() > before => {
                    assert_eq!(vertices, [Vertex::constructed(before)]);
                    judge.add(point.unwrap_or_else(|| panic!("{definition} is not a point")));
                    check_incidence(&session, &definition, vertices[0]);
                    definitions.push(definition);
                    level.push(vertices[0]);
                }
                Ok(_) => {}
            }
            if level.len() == growth.width {
                break;
            }
        }
        all.extend_from_slice(&level);
        if level.len() > 3 {
            last = level;
        }
        check_approximations(session.scene(), &judge, session.constructed());
        for _ in 0..8 {
            let [a, b, c, d] = pick(random, [&last, &all]);
            check_one(&judge, session.constructed(), session.scene(), [a, b, c, d], seen);
        }
    }
    // The same definitions in other orders are the same vertices.
    let turned: Vec<Construction> = definitions.iter().rev().map(|&definition| turned(definition)).collect();
    let mut vertices = session.construct(&turned).expect("as before");
    vertices.reverse();
    assert_eq!(vertices, (0..definitions.len()).map(Vertex::constructed).collect::<Vec<_>>());
    check_prepared(random, &session, &all);
    refused
}

fn turned(definition: Construction) -> Construction {
    match definition {
        Construction::Ssi([[a, b], line]) => Construction::Ssi([line, [b, a]]),
        Construction::Lpi { line: [p, q], plane: [r, s, t] } => Construction::Lpi { line: [q, p], plane: [s, t, r] },
        Construction::Tpi([l, [p, q, r], n]) => Construction::Tpi([n, l, [r, q, p]]),
        Construction::Ratio { ends: [a, c], share } => Construction::Ratio { ends: [c, a], share: share.rest() },
    }
}

/// A scene prepared with all vertices answers the same, by the same stages, alone and in batches.
fn check_prepared(random: &mut Random, session: &Session<'_, Off>, all: &[Vertex]) {
    let scene = session.scene().clone();
    let prepared = Exact.prepare(&scene, Off).expect("points");
    let queries: Vec<[Vertex; 3]> = (0..20).map(|_| pick(random, [all, all])).collect();
    let mut batch = vec![Sign::Zero; queries.len()];
    session.orient2d_batch(Plane::Xy, &queries, &mut batch);
    for (&[a, b, c], sign) in queries.iter().zip(batch) {
        let decided = session.decide_orient2d(Plane::Xy, a, b, c);
        assert_eq!((decided, decided.0), (prepared.decide_orient2d(Plane::Xy, a, b, c), sign));
    }
}

#[test]
fn levels_upon_a_grid_are_full_of_ties() {
    let mut random = Random(101);
    for (dimension, depth) in [(Dimension::Two, 4), (Dimension::Three, 3)] {
        let (mut seen, mut refused) = (Seen::default(), 0);
        for _ in 0..12 {
            #[allow(clippy::cast_precision_loss)] // below 4
            let base = scene(&mut random, dimension, 10, |random| random.below(4) as f64);
            refused += cascade(&mut random, &base, &Growth { depth, width: 6, planes: true }, &mut seen);
        }
        assert!(seen.signs.iter().all(|&count| count > seen.all() / 20), "{dimension:?}: {seen:?}");
        assert!(refused > 20, "{dimension:?}: {refused} definitions of no point");
    }
}

#[test]
fn levels_upon_points_in_general_position() {
    let mut random = Random(102);
    for (dimension, depth, planes) in
        [(Dimension::Two, 4, false), (Dimension::Three, 3, false), (Dimension::Three, 2, true)]
    {
        let mut seen = Seen::default();
        for _ in 0..3 {
            let base = scene(&mut random, dimension, 9, Random::unit);
            cascade(&mut random, &base, &Growth { depth, width: 4, planes }, &mut seen);
        }
        assert!(seen.filtered > seen.all() / 2, "{dimension:?}: {seen:?}");
    }
}

/// The second level is longer than any that input vertices define: determinants leave the stack.
#[test]
fn levels_upon_every_exponent() {
    let mut random = Random(103);
    for (dimension, depth) in [(Dimension::Two, 3), (Dimension::Three, 2)] {
        let mut seen = Seen::default();
        for _ in 0..6 {
            let base = scene(&mut random, dimension, 9, |random| *random.pick(&WILD));
            cascade(&mut random, &base, &Growth { depth, width: 4, planes: false }, &mut seen);
        }
        assert!(seen.signs.iter().all(|&count| count > 0), "{dimension:?}: {seen:?}");
    }
}

/// A session that rounds the first level before the second differs from one that keeps it.
///
/// Most queries about incidence expose the difference.
#[test]
fn rounding_between_two_levels_is_caught() {
    let mut random = Random(104);
    let (mut asked, mut wrong) = (0, 0);
    for _ in 0..60 {
        let base = scene(&mut random, Dimension::Two, 8, Random::unit);
        let mut session = Exact.prepare(&base, Off).expect("prepared");
        let [a, b, c, d, e, f, g, h]: [Vertex; 8] = distinct(&mut random, 8);
        let first = [Construction::Ssi([[a, b], [c, d]]), Construction::Ssi([[a, b], [e, f]])];
        let Ok(first) = session.construct(&first) else { continue };
        // The line through two vertices of the line ab is that line.
        let Ok(second) = session.construct(&[Construction::Ssi([[first[0], first[1]], [g, h]])]) else { continue };
        assert_eq!(session.orient2d(Plane::Xy, a, b, second[0]), Sign::Zero);

        let rounded: Vec<f64> =
            first.iter().flat_map(|&v| session.constructed().approximation(v).iter().copied()).collect();
        let mut points = Scene::new(Dimension::Two, [base.coordinates(), &rounded].concat()).expect("finite");
        let line = [base.len(), base.len() + 1].map(Vertex::input);
        let x = points.construct(Construction::Ssi([line, [g, h]])).expect("input vertices");
        let faulty = Constructed::new(&points).expect("a point");
        asked += 1;
        wrong += usize::from(!faulty.orient2d(Plane::Xy, a, b, x).0.is_zero());
    }
    assert!(asked > 50 && wrong > asked * 3 / 4, "{wrong} of {asked}");
}

/// A refused definition refuses the whole batch, also if it is between valid ones.
///
/// The session continues as if the call had not happened.
#[test]
fn a_refused_batch_leaves_nothing() {
    let v = Vertex::input;
    let points = [[0.0, 0.0], [3.0, 0.0], [0.0, 1.0], [3.0, 1.0], [1.0, 0.0], [1.0, 5.0], [0.0, 7.0]];
    let base = Scene::from_points2(&points).expect("finite");
    let diagonals = Construction::Ssi([[v(0), v(3)], [v(1), v(2)]]);
    let parallel = Construction::Ssi([[v(0), v(1)], [v(2), v(3)]]);
    let c = Vertex::constructed;
    let upright = Construction::Ssi([[c(0), v(5)], [v(2), v(3)]]);
    let on_both = Construction::Ssi([[v(0), v(3)], [c(0), v(3)]]);
    for scene in [base.clone(), {
        let mut scene = base.clone();
        scene.construct(Construction::Ssi([[v(4), v(5)], [v(1), v(6)]])).expect("input vertices");
        scene
    }] {
        let start = scene.constructions().len();
        let mut session = Exact.prepare(&scene, Off).expect("points");
        let refused = session.construct(&[diagonals, parallel, upright]).unwrap_err();
        assert_eq!(refused.to_string(), "definition 1, SSI(0 1, 2 3), is refused: the lines are parallel");
        let reason = NoPoint::ParallelLines.into();
        assert_eq!(refused, Refused::Definition { index: 1, definition: parallel, reason });
        assert_eq!((session.scene(), session.constructed().approximation(v(0)).len()), (&scene, 2));
        let later = Construction::Ssi([[c(start + 1), v(0)], [v(1), v(2)]]);
        assert_eq!(
            session.construct(&[diagonals, later]).unwrap_err().to_string(),
            format!("definition 1, {later}, is refused: c{} is not constructed before", start + 1)
        );
        assert_eq!(session.construct(&[diagonals]), Ok(vec![c(start)]), "the id is free");
        assert_eq!(session.constructed().approximation(c(start)), [1.5, 0.5]);
        assert_eq!(session.orient2d(Plane::Xy, v(0), c(start), v(3)), Sign::Zero);
        assert_eq!(session.construct(&[]), Ok(Vec::new()));
        if start == 0 {
            let why = session.construct(&[upright, diagonals, on_both]).unwrap_err();
            assert_eq!((why.index(), session.scene().constructions()), (Some(2), &[diagonals.canonical()][..]));
            assert!(why.to_string().ends_with("the lines are parallel"), "one line, by two pairs of vertices: {why}");
        }
    }
}

/// The cost of construction does not depend on the scene: the points are shared, not copied.
#[test]
fn input_vertices_are_not_copied() {
    let v = Vertex::input;
    let base = Scene::from_points2(&[[0.0, 0.0], [3.0, 1.0], [3.0, 0.0], [0.0, 1.0]]).expect("finite");
    let mut session = Exact.prepare(&base, Off).expect("prepared");
    session.construct(&[Construction::Ssi([[v(0), v(1)], [v(2), v(3)]])]).expect("a point");
    assert_eq!(session.scene().coordinates().as_ptr(), base.coordinates().as_ptr());
    assert!(base.constructions().is_empty(), "the scene of the caller is as it was");
}
