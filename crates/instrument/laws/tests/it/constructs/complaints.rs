//! Checks of how a backend constructs, compared with its declaration.

use predicament_predicates::{
    Backend, Construction, Constructs, Off, Predicates, QuerySet, Question, Scene, Sign, Vertex,
};

use super::cases::{CASES, Case};

/// The failed checks of a backend. Each begins with the name of its check: `declared`, `ids`, `interned`, `all or
/// nothing`, `degenerate`, `truth`, `prepared`, `batches`.
pub fn complaints<B: Backend>(backend: &B) -> Vec<String> {
    let mut complaints = Vec::new();
    for case in CASES.iter() {
        let mut session = match backend.prepare(&case.scene, Off) {
            Ok(session) => session,
            Err(declined) => {
                complaints.push(format!("declared: it declines a plain scene: {declined}"));
                continue;
            }
        };
        // As an algorithm may hold it.
        let session: &mut dyn Predicates = &mut session;
        let before = complaints.len();
        match backend.constructs() {
            Constructs::Declines => declines(case, session, &mut complaints),
            declared => constructs(backend, declared, case, session, &mut complaints),
        }
        complaints[before..]
            .iter_mut()
            .for_each(|complaint| complaint.push_str(&format!(" ({:?})", case.scene.dimension())));
    }
    complaints
}

fn declines(case: &Case, session: &mut dyn Predicates, complaints: &mut Vec<String>) {
    match session.construct(&case.first) {
        Err(refused) if refused.index().is_none() => {}
        other => complaints.push(format!("declared: it declines, and this came back: {other:?}")),
    }
    if *session.scene() != case.scene {
        complaints.push("declared: it declines and has a new scene".to_owned());
    }
}

fn constructs<B: Backend>(
    backend: &B,
    declared: Constructs,
    case: &Case,
    session: &mut dyn Predicates,
    complaints: &mut Vec<String>,
) {
    let mut expected = case.scene.clone();
    let mut must = |session: &mut dyn Predicates, definitions: &[Construction], complaints: &mut Vec<String>| {
        let vertices = expected.construct_all(definitions, |_, _| Ok(())).expect("vertices of the scene");
        match session.construct(definitions) {
            Err(refused) => complaints.push(format!("declared: {refused}")),
            Ok(found) if found != vertices => complaints.push(format!("ids: {found:?} for {vertices:?}")),
            Ok(_) => {}
        }
        if *session.scene() != expected {
            complaints.push("ids: the session's scene has other vertices".to_owned());
        }
    };
    must(session, &case.first[..2], complaints);
    refused_together(case, declared, session, complaints);
    must(session, &case.first, complaints);
    interned(case, session, complaints);
    truth(case, declared, session, 0..case.first.len(), complaints);
    if declared == Constructs::KeepsFirst {
        match session.construct(&[case.first[0], case.deep[0]]) {
            Err(refused) if refused.index() == Some(1) => {}
            other => complaints.push(format!("declared: one level, and of the second came back: {other:?}")),
        }
    } else {
        must(session, &case.deep, complaints);
        truth(case, declared, session, case.first.len()..case.first.len() + case.deep.len(), complaints);
    }
    prepared(case, backend, session, complaints);
    batches(case, session, complaints);
}

/// Checks that a batch with an invalid construction is refused as a whole, and so is one with a degenerate
/// construction.
fn refused_together(case: &Case, declared: Constructs, session: &mut dyn Predicates, complaints: &mut Vec<String>) {
    let before = session.scene().clone();
    let missing = Vertex::input(case.scene.len());
    let impossible = match case.first[0] {
        Construction::Ssi([line, _]) => Construction::Ssi([line, [line[0], missing]]),
        Construction::Lpi { plane, .. } | Construction::Tpi([plane, ..]) => {
            Construction::Lpi { line: [plane[0], missing], plane }
        }
        Construction::Ratio { ends: [a, _], share } => Construction::Ratio { ends: [a, missing], share },
    };
    let mut together = |check: &str, refused: Construction, session: &mut dyn Predicates| {
        match session.construct(&[case.first[2], refused, case.first[3]]) {
            Err(why) if why.index() == Some(1) => {}
            other => complaints.push(format!("{check}: {refused} came back as {other:?}")),
        }
        if *session.scene() != before {
            complaints.push(format!("all or nothing: something is left of a batch with {refused}"));
        }
    };
    together("all or nothing", impossible, session);
    if declared != Constructs::Rounds {
        together("degenerate", case.degenerate, session);
    }
}

/// Checks that the lines and planes of known vertices, in other orders and in a reversed batch, give those vertices.
fn interned(case: &Case, session: &mut dyn Predicates, complaints: &mut Vec<String>) {
    let turn = |&definition: &Construction| match definition {
        Construction::Ssi([[a, b], line]) => Construction::Ssi([line, [b, a]]),
        Construction::Lpi { line: [p, q], plane: [r, s, t] } => Construction::Lpi { line: [q, p], plane: [t, r, s] },
        Construction::Tpi([l, [p, q, r], n]) => Construction::Tpi([n, [r, p, q], l]),
        Construction::Ratio { ends: [a, c], share } => Construction::Ratio { ends: [c, a], share: share.rest() },
    };
    let before = session.scene().clone();
    let turned: Vec<Construction> = case.first.iter().rev().map(turn).collect();
    let known: Vec<Vertex> = (0..case.first.len()).rev().map(Vertex::constructed).collect();
    match session.construct(&turned) {
        Ok(vertices) if vertices == known && *session.scene() == before => {}
        other => complaints.push(format!("interned: {other:?} for {known:?}")),
    }
}

/// Checks that kept vertices have the exact signs, and that the rounding of rounded vertices is detected.
fn truth(
    case: &Case,
    declared: Constructs,
    session: &dyn Predicates,
    constructed: std::ops::Range<usize>,
    complaints: &mut Vec<String>,
) {
    if constructed.end > session.scene().constructions().len() {
        return;
    }
    let mut wrong = Vec::new();
    for &(question, ref args, truth) in case.asked(constructed) {
        let sign = question.ask(session, args);
        // Backends that break ties are only compared where the exact sign is not zero.
        if sign != truth && (declared != Constructs::KeepsFirst || !truth.is_zero()) {
            wrong.push(format!("truth: {} is {truth:?}, not {sign:?}", question.query(args)));
        }
    }
    match declared {
        Constructs::Rounds if wrong.is_empty() => complaints.push("truth: nothing was rounded".to_owned()),
        Constructs::Rounds => {}
        _ => complaints.extend(wrong),
    }
}

/// Checks that a scene that has all vertices from the start gets the same answers.
fn prepared<B: Backend>(case: &Case, backend: &B, session: &dyn Predicates, complaints: &mut Vec<String>) {
    let scene: Scene = session.scene().clone();
    match backend.prepare(&scene, Off) {
        Err(declined) => complaints.push(format!("prepared: {declined}")),
        Ok(prepared) => {
            for (question, args, _) in case.asked(case.known(session)) {
                let [now, later] = [question.ask(&prepared, args), question.ask(session, args)];
                if now != later {
                    complaints.push(format!("prepared: {} is {now:?}, later {later:?}", question.query(args)));
                }
            }
        }
    }
}

/// Checks that batches, lines and planes answer as single calls do.
fn batches(case: &Case, session: &dyn Predicates, complaints: &mut Vec<String>) {
    for &(question, ref args, _) in case.asked(case.known(session)) {
        let single = question.ask(session, args);
        let mut batch = [Sign::Zero; 3];
        QuerySet::new(question, args.repeat(3)).ask_batch(session, 0..3, &mut batch);
        let mut swept = [single];
        match (question, args.as_slice()) {
            (Question::Orient2d(plane), &[a, b, c]) => session.orient2d_line(plane, [a, b], &[c], &mut swept),
            (Question::Orient3d, &[a, b, c, d]) => session.orient3d_plane([a, b, c], &[d], &mut swept),
            _ => {}
        }
        if batch != [single; 3] || swept != [single] {
            complaints.push(format!("batches: {} is {single:?}: {batch:?} {swept:?}", question.query(args)));
        }
    }
}
