/// The turn with the coordinates in f32: a fault.
pub fn orient2d(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f32 {
    #[allow(clippy::cast_possible_truncation)] // the fault
    let [a, b, c] = [a, b, c].map(|p| p.map(|x| x as f32));
    (a[0] - c[0]) * (b[1] - c[1]) - (a[1] - c[1]) * (b[0] - c[0])
}

/// Answered: -; found in classics/kettner-a2, query 1.
#[test]
#[should_panic(expected = "assertion")]
fn orient2d_classics_kettner_a2_1() {
    use predicament_conformance::{Answer, Sign};
    let a = [f64::from_bits(0x0000000000000000), f64::from_bits(0x0000000000000000)]; // [0.0, 0.0]
    let b = [f64::from_bits(0x3ffbdc83d0000000), f64::from_bits(0x3ff2b67eb8000000)]; // [1.7413366436958313, 1.169554442167282]
    let c = [f64::from_bits(0x3ff6e2da00000000), f64::from_bits(0x3feebe1960000000)]; // [1.4303836822509766, 0.9607054591178894]
    let answer = orient2d(a, b, c);
    assert_eq!(Answer::from(answer), Answer::Sign(Sign::Positive));
}
