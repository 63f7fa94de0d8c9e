#[path = "../../algorithms/benches/polygon_locate/wiggly.rs"]
mod wiggly;
use predicament_algorithms::polygon_locate::*;
use predicament_checks::tiling::*;
use predicament_exact::Exact;
use predicament_predicates::*;
use std::time::Instant;
fn main() {
    let (map, scene, queries) = wiggly::map(16, 1011, 1_000_000);
    let t = Instant::now();
    let index = LocateIndex::new(&map, &scene);
    println!("index {} {:?}", index.len(), t.elapsed());
    let session = Exact.prepare(&scene, Off).unwrap();
    let t = Instant::now();
    let a = locate_all(&index, &session, &queries, &|_| true);
    println!("locate {:?} (2 threads)", t.elapsed());
    let t = Instant::now();
    println!("flaws {} {:?}", map_flaws(&index, &session).len(), t.elapsed());
    let t = Instant::now();
    let s = surroundings(&index, &session, &queries);
    println!("surroundings {:?}", t.elapsed());
    let t = Instant::now();
    let r = tiling_report(&s, &a, ZeroMeaning::Exact);
    println!("report {} {:?} {:?}", r.violations().len(), r.counts(Ground::Land), t.elapsed());
}
