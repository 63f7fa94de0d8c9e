//! Sorting by signs, including contradictory signs.

use predicament_grid::sort::sort_by_sign;
use predicament_predicates::Sign;

fn sign(a: u32, b: u32) -> Sign {
    Sign::from(a.cmp(&b))
}

/// Numbers in a fixed random order.
fn scattered(n: u32) -> Vec<u32> {
    (0..n).map(|i| i.wrapping_mul(0x9e37_79b9) >> 20).collect()
}

#[test]
fn sorts_as_the_standard_library_and_is_stable() {
    for n in [0, 1, 2, 3, 7, 64, 1000] {
        let mut items: Vec<(u32, u32)> = scattered(n).into_iter().map(|x| x % 50).zip(0..).collect();
        let mut expected = items.clone();
        expected.sort_by_key(|item| item.0);
        sort_by_sign(&mut items, |a, b| sign(a.0, b.0));
        assert_eq!(items, expected, "{n} items");
    }
}

#[test]
fn runs_cost_one_question_an_item() {
    let mut asked = 0;
    let mut items: Vec<u32> = (0..1000).collect();
    sort_by_sign(&mut items, |a, b| {
        asked += 1;
        sign(a, b)
    });
    assert_eq!(asked, 999);
}

#[test]
fn contradictions_lose_no_item_and_end_in_time() {
    let n = 1000;
    let answers: [fn(u32, u32) -> Sign; 4] = [
        |_, _| Sign::Negative,
        |_, _| Sign::Positive,
        |a, b| sign(a.wrapping_mul(b) % 3, 1),
        |a, b| sign((a + 2 * b) % 5, 2),
    ];
    for compare in answers {
        let mut items = scattered(n);
        let mut expected = items.clone();
        let mut asked = 0;
        sort_by_sign(&mut items, |a, b| {
            asked += 1;
            compare(a, b)
        });
        assert!(asked <= 11 * n, "{asked} questions");
        items.sort_unstable();
        expected.sort_unstable();
        assert_eq!(items, expected);
    }
}
