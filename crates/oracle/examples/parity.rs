//! Counts the crossings of random near-degenerate polygons after merging, and
//! shrinks some of the finds:
//! `cargo run --release -p predicament-oracle --example parity -- [SEED [PAIRS OF EACH RECIPE [FINDS TO SHRINK]]]`.

use std::collections::BTreeMap;

use predicament_checks::contacts::Seat;
use predicament_oracle::parity::{examine, random_pair, search, shrink_odd};
use predicament_oracle::shrink::Shrink;
use predicament_tolerance::Tolerance;

fn main() {
    let mut numbers = std::env::args().skip(1).map(|text| text.parse::<u64>().expect("a number"));
    let (seed, pairs) = (numbers.next().unwrap_or(1), numbers.next().unwrap_or(40_000));
    let shrunk = usize::try_from(numbers.next().unwrap_or(0)).expect("few");
    let census = search(seed, pairs);
    println!("{} pairs of simple polygons, {} draws refused", census.pairs, census.refused);
    for row in &census.rows {
        println!("{row:?}");
    }
    let mut of_recipe: BTreeMap<_, usize> = BTreeMap::new();
    for found in &census.found {
        *of_recipe.entry((&found.backend, found.recipe)).or_default() += 1;
    }
    println!("odd under some rule: {of_recipe:?}");

    // The smallest for each set of rules and whether vertices were merged with vertices, edges with vertices.
    let mut smallest: BTreeMap<_, (_, _, _)> = BTreeMap::new();
    let finds = census.found.iter().filter(|found| found.backend == "tolerance");
    let each = census.found.len().div_ceil(shrunk.max(1));
    for found in finds.step_by(each).take(shrunk) {
        let (pair, _) = random_pair(found.recipe, seed, found.number);
        let small = shrink_odd(&Tolerance, pair, &found.seats, 20_000);
        let registered = examine(&Tolerance, &small.scene).expect("shown before").contacts.registered;
        let has = |rank| registered.iter().any(|contact| contact.a.rank + contact.b.rank == rank);
        let kind = (found.seats.clone(), has(0), has(1), has(2));
        let size = small.scene.size();
        if smallest.get(&kind).is_none_or(|(known, ..)| size < *known) {
            smallest.insert(kind, (size, found, small));
        }
    }
    for ((seats, vertices, edges, crossings), (size, found, small)) in smallest {
        let seats: Vec<&str> = seats.into_iter().map(Seat::name).collect();
        println!(
            "{seats:?} vertex-vertex {vertices} edge-vertex {edges} edge-edge {crossings}: {size:?}, from {:?} {}",
            found.recipe, found.number
        );
        println!("  {:?} ({} tried, minimal {})", small.scene.polygons, small.tried, small.minimal);
    }
}
