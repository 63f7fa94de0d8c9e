//! Counts the crossings of random near-degenerate polygons after merging:
//! `cargo run --release -p predicament-oracle --example parity -- [SEED [PAIRS OF EACH RECIPE [SHRUNK]]]`.

use predicament_checks::contacts::Seat;
use predicament_oracle::parity::{random_pair, search, shrink_odd};
use predicament_oracle::shrink::Shrink;

fn main() {
    let mut numbers = std::env::args().skip(1).map(|text| text.parse::<u64>().expect("a number"));
    let (seed, pairs) = (numbers.next().unwrap_or(1), numbers.next().unwrap_or(40_000));
    let shrunk = usize::try_from(numbers.next().unwrap_or(0)).expect("few");
    let census = search(seed, pairs);
    println!("{} pairs of simple polygons, {} draws refused", census.pairs, census.refused);
    for row in &census.rows {
        println!("{row:#?}");
    }
    let mut best: Vec<_> = census
        .found
        .iter()
        .filter(|found| found.backend == "tolerance")
        .take(shrunk)
        .map(|found| {
            let (pair, _) = random_pair(found.recipe, seed, found.number);
            let small = shrink_odd(pair, &found.seats, 20_000);
            (small.scene.size(), found, small)
        })
        .collect();
    best.sort_by_key(|(size, ..)| *size);
    for seats in [&Seat::ALL[..], &Seat::ALL[..1], &Seat::ALL[1..2], &Seat::ALL[2..]] {
        for (size, found, small) in best.iter().filter(|(_, found, _)| found.seats == seats).take(2) {
            println!("{size:?} {found:?}\n{small:?}");
        }
    }
}
