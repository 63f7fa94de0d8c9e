//! Right answers with planted faults, which prove that the checks find faults that no backend has.

use crate::algorithm::pairs::Contact;
use predicament_mesh::Simplex;
use predicament_predicates::Scene;

use super::{Complexes, Contacts, Registered};
use predicament_tasks::{Class, Spoiled};

pub(super) fn all(task: Contacts) -> Vec<Spoiled<Contacts>> {
    let mut all = vec![
        Spoiled::new(
            "contacts-end-early",
            "the first pair of full dimension is replaced by the pair of its first vertices",
            "exact",
            &[(Class::Overreach, "ended early")],
            |scene: &Scene, content: &Complexes, answer: &mut Registered| {
                let full = |contact: &&mut Contact| is_full(scene, contact);
                if let Some(contact) = answer.registered.iter_mut().find(full) {
                    let first = [content.a.vertices_of(contact.a)[0], content.b.vertices_of(contact.b)[0]];
                    if let (Some(a), Some(b)) = (content.a.find(&first[..1]), content.b.find(&first[1..])) {
                        (contact.a, contact.b) = (a, b);
                    }
                }
            },
        ),
        Spoiled::new(
            "contacts-end-late",
            "the first registered vertex is replaced by an edge that has it",
            "exact",
            &[(Class::MissedZero, "not ended")],
            |_, content: &Complexes, answer: &mut Registered| {
                let found = answer.registered.iter_mut().filter(|contact| contact.a.rank == 0).find_map(|contact| {
                    let [v] = *content.a.vertices_of(contact.a) else { return None };
                    let edge = content.a.edges().iter().find(|edge| edge.contains(&v))?;
                    Some((content.a.find(edge)?, contact))
                });
                if let Some((edge, contact)) = found {
                    contact.a = edge;
                }
            },
        ),
        Spoiled::new(
            "contacts-lose-a-pair",
            "the most degenerate pair is not registered",
            "exact",
            &[(Class::MissedZero, "contact")],
            |scene: &Scene, _, answer: &mut Registered| {
                let ranks = |contact: &Contact| usize::from(contact.a.rank) + usize::from(contact.b.rank);
                if answer.registered.first().is_some_and(|first| ranks(first) < scene.dimension().count()) {
                    answer.registered.remove(0);
                }
            },
        ),
        Spoiled::new(
            "contacts-ask-again",
            "an edge of the first registered vertex is registered, too",
            "tolerance",
            &[(Class::Inconsistent, "unasked")],
            |_, content: &Complexes, answer: &mut Registered| {
                let found = answer.registered.iter().filter(|contact| contact.a.rank == 0).find_map(|contact| {
                    let [v] = *content.a.vertices_of(contact.a) else { return None };
                    let edge = content.a.edges().iter().find(|edge| edge.contains(&v))?;
                    Some(Contact { a: content.a.find(edge)?, ..*contact })
                });
                answer.registered.extend(found);
            },
        ),
        Spoiled::new(
            "contacts-weights-are-no-numbers",
            "the first weight of each pair is NaN",
            "exact",
            &[(Class::Nan, "weights")],
            |_, _, answer: &mut Registered| {
                answer.registered.iter_mut().for_each(|contact| contact.on_a[0] = f64::NAN);
            },
        ),
        Spoiled::new(
            "contacts-far-away",
            "the first vertex of the first complex and the last vertex of the second are registered",
            "tolerance",
            &[(Class::Overreach, "unasked")],
            |_, content: &Complexes, answer: &mut Registered| {
                let last = u32::try_from(content.b.vertices().len().saturating_sub(1)).unwrap_or(u32::MAX);
                let [a, b] = [0, last].map(|index| Simplex { rank: 0, index });
                if answer.registered.iter().all(|contact| (contact.a, contact.b) != (a, b)) {
                    let whole = [1.0, 0.0, 0.0, 0.0];
                    answer.registered.insert(0, Contact { a, b, on_a: whole, on_b: whole });
                }
            },
        ),
    ];
    if task == Contacts::IN_SPACE {
        all.push(Spoiled::new(
            "contacts-lose-a-piercing",
            "the first crossing of an edge and a triangle is not registered",
            "exact",
            &[(Class::Topology, "signed piercings")],
            |scene: &Scene, _, answer: &mut Registered| {
                let first = answer.registered.iter().position(|contact| is_full(scene, contact));
                first.map(|at| answer.registered.remove(at));
            },
        ));
    }
    all
}

/// True if a pair is of full dimension, with an edge or more on either side.
fn is_full(scene: &Scene, contact: &Contact) -> bool {
    let ranks = [contact.a.rank, contact.b.rank];
    ranks.iter().all(|&rank| rank > 0) && ranks.map(usize::from).iter().sum::<usize>() == scene.dimension().count()
}
