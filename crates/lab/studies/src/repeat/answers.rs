//! The answers of a backend to a scene, to be compared.

use predicament_corpus::{LoadedScene, Random};
use predicament_predicates::{Class, QuerySet, Scene, Sign, Vertex};
use predicament_tasks::signs::{Answers, SignQueries};
use predicament_tasks::{AnyTask, Contestant, Purpose, caught};

use super::Way;

/// The characters of a whole answer that are shown, at most.
const LONGEST: usize = 60;

/// The answers to a scene: signs one by one, other answers as a digest.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Given {
    /// The signs of all queries.
    Signs(Vec<Sign>),
    /// The digest of a whole answer.
    Whole(u64),
    /// No answer, and why.
    None { class: Class, why: String },
}

impl Given {
    /// The answers as one word of a file.
    pub fn text(&self) -> String {
        match self {
            Given::Signs(signs) => signs.iter().map(|sign| sign.symbol()).collect(),
            Given::Whole(digest) => format!("{digest:016x}"),
            Given::None { class, why } => format!("{class}: {why}"),
        }
    }

    /// The number of answers, the number of differing ones, and the first of them with both texts.
    pub fn differences(&self, other: &Given) -> (u64, u64, Option<(usize, String, String)>) {
        if let (Given::Signs(first), Given::Signs(second)) = (self, other)
            && first.len() == second.len()
        {
            let mut differ = (0..first.len()).filter(|&at| first[at] != second[at]).peekable();
            let shown = |&at: &usize| (at, first[at].symbol().to_string(), second[at].symbol().to_string());
            let at = differ.peek().map(shown);
            return (first.len() as u64, differ.count() as u64, at);
        }
        let is_equal = match (self, other) {
            // The message of a failure may have a number of the process.
            (Given::None { class: first, .. }, Given::None { class: second, .. }) => first == second,
            _ => self == other,
        };
        let short = |given: &Given| given.text().chars().take(LONGEST).collect::<String>();
        (1, u64::from(!is_equal), (!is_equal).then(|| (0, short(self), short(other))))
    }
}

/// The answers of a backend to a scene, asked as at first.
pub(super) fn given(task: &dyn AnyTask, loaded: &LoadedScene, backend: &dyn Contestant) -> Given {
    asked(task, &loaded.scene, loaded.content.as_ref(), backend)
}

fn asked(
    task: &dyn AnyTask,
    scene: &Scene,
    content: &dyn predicament_corpus::Content,
    backend: &dyn Contestant,
) -> Given {
    let mut given = Given::Whole(0);
    let answered = caught(|| {
        backend.answer_any(task.name(), scene, content, Purpose::Use, &mut |answer| {
            given = match answer.downcast_ref::<Answers>() {
                Some(signs) => Given::Signs(signs.0.clone()),
                None => Given::Whole(task.digest_of(answer)),
            };
        })
    });
    match answered {
        Ok(Ok(())) => given,
        Ok(Err(why)) => Given::None { class: Class::Declined, why: why.to_string() },
        Err(broken) => Given::None { class: broken.class, why: broken.message },
    }
}

/// The answers of a backend to a scene that is asked again in this process; `None` if the way is not for the scene.
pub(super) fn again(
    way: Way,
    task: &dyn AnyTask,
    loaded: &LoadedScene,
    backend: &dyn Contestant,
    seed: u64,
) -> Option<Given> {
    let mut random = Random::new("repeat", task.name(), seed);
    match way {
        Way::Process => None,
        Way::Again => Some(given(task, loaded, backend)),
        Way::Threads(threads) => {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().ok()?;
            Some(pool.install(|| given(task, loaded, backend)))
        }
        Way::Order => {
            let queries = &loaded.content::<SignQueries>()?.queries;
            let order = shuffled(queries.len(), &mut random);
            let args = order.iter().flat_map(|&at| queries.args(at)).copied().collect();
            let content = SignQueries::new(QuerySet::new(queries.question(), args));
            let answers = asked(task, &loaded.scene, &content, backend);
            let Given::Signs(signs) = answers else { return Some(answers) };
            let mut back = vec![Sign::Zero; signs.len()];
            order.iter().zip(signs).for_each(|(&at, sign)| back[at] = sign);
            Some(Given::Signs(back))
        }
        Way::Ids => {
            let queries = &loaded.content::<SignQueries>()?.queries;
            let scene = &loaded.scene;
            let is_list = scene.constructions().is_empty() && scene.second_mesh().is_none();
            // The vertex that has each number now.
            let order = shuffled(scene.len(), &mut random);
            let points = order.iter().flat_map(|&at| scene.point(Vertex::input(at))).copied().collect();
            let moved = Scene::new(scene.dimension(), points).ok().filter(|_| is_list)?;
            let mut number = vec![0; order.len()];
            order.iter().enumerate().for_each(|(now, &before)| number[before] = now);
            let args = queries.flat().iter().map(|v| Vertex::input(number[v.index()])).collect();
            Some(asked(task, &moved, &SignQueries::new(QuerySet::new(queries.question(), args)), backend))
        }
    }
}

/// The numbers below `n` in random order.
fn shuffled(n: usize, random: &mut Random) -> Vec<usize> {
    let mut order: Vec<usize> = (0..n).collect();
    random.shuffle(&mut order);
    order
}
