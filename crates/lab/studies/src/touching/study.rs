//! The survey of pairs of solids.

use predicament_report::text::in_order;
use predicament_tasks::Contestant;

use super::made::Solids;
use super::{Known, Made, Measured, Pair, Row, Touching, suite, table};
use crate::{Common, Error, File, Host, Study};

/// The relative difference that is put down to the rounding of lengths and areas, in sums of many square roots.
const ROUNDING: f64 = 1e-12;

impl Study for Touching {
    const NAME: &'static str = "touching";
    const ASKS: &'static str = "Unite solids that touch: the cost of special cases, perturbation and limits";
    const HELP: &'static str = "\
Two solids are united by each backend. If zeros are exact, the cases of contact are written out, and the contacts are \
listed: points, segments, faces. If ties are broken, the result belongs to moved solids; its limit, in exact signs, \
belongs to the given ones. If zeros are bands, registered contacts decide, and smaller contacts than an edge and a \
triangle have no result.

All results are measured in rationals: volumes of union and intersection, bits of constructed points (the longest \
numerator or denominator), lengths and areas of contacts. Where solids are made of unit cubes, volume and contacts \
are compared with counted values. `cleared` is the number of triangles that the limit removes or divides: without \
area, cancelled by an opposite one, covered by facing ones, divided at vertices on edges. `undefined` is the number \
of constructed vertices that only the moved solids have.

Files in the folder: touching.csv, touching-times.csv, touching.md, and touching-pairs.toml: the pairs as a suite, on which \
`bench` times other programs too. Everything except times is the same in every run.

Exit code 100 if exact or sos:per-mesh has no result, or a volume, or a contact of exact, is not the counted one, or \
the limit changes a result of exact.

Examples:
  predicament study touching
  predicament study touching --side 9 --levels 6 -b exact,sos:per-mesh --threads 1
  predicament study touching -p faces,parts --rounds 20 --out target/touching";

    type Measured = Measured;

    fn backends(&self) -> Vec<String> {
        self.backends.clone()
    }

    fn common(&self) -> Option<&Common> {
        Some(&self.common)
    }

    fn survey(&self, backends: &[&dyn Contestant], host: &dyn Host) -> Result<Measured, Error> {
        let pairs = if self.pairs.is_empty() { Pair::ALL.to_vec() } else { in_order(self.pairs.iter().copied()) };
        host.begin((pairs.len() * backends.len()) as u64 * u64::from(self.rounds + 1), "unions");
        let mut rows = Vec::new();
        for pair in pairs {
            let solids = Solids::new(&pair.solids(self.side, self.levels as usize)).map_err(Error::unfit)?;
            let first = rows.len();
            for backend in backends {
                host.turn_to(&format!("{} by {}", pair.name(), backend.name()));
                rows.push(Row {
                    pair,
                    backend: backend.name(),
                    triangles: solids.triangles(),
                    made: solids.made(*backend),
                    overlay: Vec::new(),
                    limit: Vec::new(),
                });
                host.watch().done(1)?;
            }
            host.turn_to(&format!("{}, timed", pair.name()));
            for _ in 0..self.rounds {
                for (row, backend) in rows[first..].iter_mut().zip(backends) {
                    if let Ok([overlay, limit]) = solids.times(*backend) {
                        row.overlay.push(overlay.as_secs_f64());
                        row.limit.push(limit.as_secs_f64());
                    }
                    host.watch().done(1)?;
                }
            }
        }
        Ok(Measured { rows })
    }

    fn rows(&self, measured: &Measured) -> Result<Vec<File>, Error> {
        table::csv(self, measured)
    }

    fn page(&self, measured: &Measured) -> String {
        table::page(self, measured)
    }

    fn suites(&self, measured: &Measured) -> Result<Vec<File>, Error> {
        Ok(vec![suite::suite(self, measured)?])
    }

    fn holds(&self, measured: &Measured) -> bool {
        measured.rows.iter().all(|row| {
            let (is_exact, is_moved) = (row.backend == "exact", row.backend == "sos:per-mesh");
            let known = row.pair.known(self.side);
            match &row.made {
                _ if !is_exact && !is_moved => true,
                Err(_) => false,
                Ok(made) => {
                    has_volume(made, known) && (!is_exact || has_contacts(made, known) && is_its_own_limit(made))
                }
            }
        })
    }
}

/// True if union and intersection have the volume of both solids together, and the union has the counted volume.
fn has_volume(made: &Made, known: Option<Known>) -> bool {
    made.volume.as_ref().is_some_and(|volume| {
        rug::Rational::from(&volume.union + &volume.intersection) == volume.both
            && known.is_none_or(|known| volume.union == known.union)
    })
}

/// True if the contacts are the counted ones.
fn has_contacts(made: &Made, known: Option<Known>) -> bool {
    let is = |found: f64, counted: f64| (found - counted).abs() <= ROUNDING * counted;
    made.touched.is_some_and(|touched| {
        known.is_none_or(|known| {
            touched.points == known.points && is(touched.length, known.length) && is(touched.area, known.area)
        })
    })
}

/// True if the limit changes nothing.
fn is_its_own_limit(made: &Made) -> bool {
    matches!(&made.limit, Some(Ok((triangles, counts))) if *triangles == made.triangles && *counts == Default::default())
}
