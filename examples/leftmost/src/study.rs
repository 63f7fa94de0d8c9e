//! A study of the crate's own: the number of vertices of a column that a backend takes for leftmost.

use clap::Args;
use predicament::predicates::{Axis, Predicates, Scene, Sign, Vertex};
use predicament::studies::{Error, File, Host, Study};
use predicament::tasks::Contestant;

/// The arguments of `predicament study column`.
#[derive(Args, Debug)]
pub struct Column {
    /// Backends, several with commas
    #[arg(short = 'b', long = "backend", default_value = "exact,sos,naive")]
    pub backends: Vec<String>,
    /// Vertices in the column
    #[arg(short, default_value_t = 100)]
    pub n: u32,
}

/// A backend, and the number of vertices that it found.
type Row = (String, usize);

impl Study for Column {
    const NAME: &'static str = "column";
    const ASKS: &'static str = "Ask how many vertices of a column are leftmost";
    const HELP: &'static str = "Examples:\n  leftmost study column -n 1000 -b sos";
    type Measured = Vec<Row>;

    fn backends(&self) -> Vec<String> {
        self.backends.clone()
    }

    fn survey(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Vec<Row>, Error> {
        host.begin(backends.len() as u64, "backends");
        let points: Vec<[f64; 2]> = (0..self.n).map(|y| [1.0, f64::from(y)]).collect();
        let scene = Scene::from_points2(&points).map_err(Error::unfit)?;
        let vertices: Vec<Vertex> = scene.vertices().collect();
        let measure = |backend: &&dyn Contestant| {
            let mut leftmost = 0;
            let mut ask = |session: &mut dyn Predicates| {
                let is_left_of = |a, b| session.compare(Axis::X, a, b) == Sign::Negative;
                let is_leftmost = |a: &&Vertex| vertices.iter().all(|&b| b == **a || !is_left_of(b, **a));
                leftmost = vertices.iter().filter(is_leftmost).count();
            };
            backend.with_session(&scene, &mut ask).map_err(Error::unfit)?;
            host.watch().done(1)?;
            Ok((backend.name(), leftmost))
        };
        backends.iter().map(measure).collect()
    }

    fn rows(&self, measured: &Vec<Row>) -> Result<Vec<File>, Error> {
        Ok(vec![File::csv("column.csv", measured)?])
    }

    fn page(&self, measured: &Vec<Row>) -> String {
        measured.iter().map(|(backend, found)| format!("* {backend}: {found} of {}\n", self.n)).collect()
    }
}
