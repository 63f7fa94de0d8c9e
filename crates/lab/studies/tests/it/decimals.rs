//! The study of decimals: a grid of the written digits is right, exact signs are right about the doubles only.

use predicament_studies::decimals::{Answered, Decimals};
use predicament_studies::{Common, Study};

use crate::{backend, quiet};

#[test]
fn each_backend_is_right_about_what_it_knows() {
    let (digits, common) = (vec![0, 2, 12], Common::default());
    let study = Decimals { backends: Vec::new(), digits, queries: 40, samples: 0, common };
    let backends: Vec<_> = ["exact", "epsilon:1e-20", "epsilon:1"].map(backend).into();
    let backends: Vec<_> = backends.iter().map(AsRef::as_ref).collect();
    let measured = study.survey(&backends, &quiet()).unwrap();
    assert!(study.holds(&measured));
    let rows = |of: &dyn Fn(&&Answered) -> bool| measured.answered.iter().filter(of).cloned().collect::<Vec<_>>();
    for row in rows(&|row| row.digits == 0) {
        assert_eq!(row.doubles, row.written, "decimals without digits are their doubles: {row:?}");
    }
    for row in rows(&|row| row.digits == 2 && row.place != "survey" && row.backend.starts_with("grid:")) {
        assert_eq!(row.written, row.answers, "{row:?}");
    }
    let exact = rows(&|row| row.digits == 2 && row.place == "survey" && row.backend == "exact");
    assert!(exact.iter().all(|row| (row.written < row.answers) == (row.figure != "grid")), "{exact:?}");
    // Nineteen digits are more than a double has, so that no backend can be right.
    let far = rows(&|row| row.digits == 12 && row.place == "survey");
    assert!(far.iter().any(|row| row.backend == "grid:1e-12" && row.written < row.answers), "{far:?}");
    // A page needs the rows alone, and the same arguments give the same bytes.
    let again = study.survey(&backends, &quiet()).unwrap();
    assert_eq!(study.page(&measured), study.page(&again));
    assert!(study.page(&measured).contains("grid of the digits"), "{}", study.page(&measured));
    assert_eq!(study.plots(&measured).unwrap().len(), study.plots(&again).unwrap().len());
}
