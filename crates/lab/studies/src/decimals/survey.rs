//! The scenes of the study, and the answers of backends to them.

use predicament_corpus::{Level, LoadedScene, Suite};
use predicament_formats::{Cache, Manifest};
use predicament_records::Spread;
use predicament_tasks::{AnyTask, Budget, Contestant, run, vocabulary};

use super::{Answered, Timed};
use crate::compare::clock::{Taken, taken};
use crate::{Error, Host};

/// One kind of queries.
#[derive(Clone, Copy)]
pub(super) struct Kind {
    pub task: &'static dyn AnyTask,
    pub figure: &'static str,
    pub place: &'static str,
    pub digits: u32,
}

impl Kind {
    /// The scene with this number of queries.
    fn scene(&self, n: u32, seed: u64) -> Result<LoadedScene, Error> {
        let Kind { task, figure, place, digits } = self;
        let text = format!(
            "title = \"decimals\"\n[[generate]]\nname = \"decimals\"\nfamily = \"decimals\"\ntask = \"{}\"\nn = {n}\n\
             seed = {seed}\ntruth = \"decimals\"\ndigits = {digits}\nfigure = \"{figure}\"\nplace = \"{place}\"\n",
            task.name()
        );
        let suite = Suite::parse(&vocabulary(&[*task]), "decimals", &text, None, &Manifest::default());
        let cache = Cache::new("decimals");
        suite.and_then(|suite| suite.scenes[0].load(Level::Quick, &cache)).map_err(Error::unfit)
    }

    /// The answers of backends to the scene, and their times if `samples` is not 0.
    pub fn survey(
        &self,
        backends: &[&dyn Contestant],
        [n, samples]: [u32; 2],
        seed: u64,
        host: &dyn Host,
    ) -> Result<(Vec<Answered>, Vec<Timed>), Error> {
        let loaded = self.scene(n, seed)?;
        let case = self.task.case(&loaded, host.watch())?;
        let budget = Budget { permutations: 0, relations: 0, ties: 0, findings_per_class: 0, ..Budget::QUICK };
        let answered = |backend: &&dyn Contestant| -> Result<Answered, Error> {
            let counts = run(case.as_ref(), *backend, budget, host.watch())?.agreement.unwrap_or_default();
            Ok(Answered {
                predicate: self.task.name().to_owned(),
                figure: self.figure.to_owned(),
                place: self.place.to_owned(),
                digits: self.digits,
                backend: backend.name(),
                answers: counts.answers,
                doubles: counts.doubles,
                written: counts.written,
                ties: counts.ties,
                ties_found: counts.ties_found,
            })
        };
        let rows = backends.iter().map(answered).collect::<Result<_, _>>()?;
        if samples == 0 {
            return Ok((rows, Vec::new()));
        }
        let times = taken(&loaded, backends, samples, host.watch())?;
        let timed = |(backend, taken): (&&dyn Contestant, &Taken)| {
            Some(Timed {
                predicate: self.task.name().to_owned(),
                place: self.place.to_owned(),
                digits: self.digits,
                backend: backend.name(),
                ns_per_query: Spread::of(taken.nanoseconds.iter().copied())?.median,
            })
        };
        Ok((rows, backends.iter().zip(&times).filter_map(timed).collect()))
    }
}
