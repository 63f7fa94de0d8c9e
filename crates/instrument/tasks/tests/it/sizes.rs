//! Tests of the sizes that recipes state: a scene is never larger, or the limit would fail.

use predicament_corpus::{Level, Making};
use predicament_formats::{Document, Fields, TableKind};

#[test]
fn no_scene_is_larger_than_its_recipe_says() {
    let mut families = 0;
    // A generator's table may have the keys of all families, since similar recipes read them, and a seed.
    let of_families = predicament_bundle::tasks()
        .iter()
        .copied()
        .flat_map(|task| task.families())
        .flat_map(|family| family.parameters);
    let of_tasks = predicament_bundle::tasks().iter().copied().flat_map(|task| task.generator_keys());
    let keys: Vec<&'static str> = of_families.chain(of_tasks).copied().chain(["seed"]).collect();
    for task in predicament_bundle::tasks() {
        for family in task.families() {
            let takes = |key: &str| family.parameters.contains(&key) || task.generator_keys().contains(&key);
            let is_taken = |line: &&&str| takes(line.split(" = ").next().unwrap_or_default());
            let text: Vec<&str> = task.sample_keys().iter().filter(is_taken).copied().collect();
            let text = text.join("\n");
            let document = Document::new("s.toml", &text);
            let table = document.parse().unwrap();
            let kind = TableKind { name: "generator", keys: keys.clone().into() };
            let name = format!("{} for {}", family.name, task.name());
            let recipe = (family.read)(task.name(), &Fields::new(&document, &kind, table.get_ref(), 0))
                .unwrap_or_else(|error| panic!("{name}: {error}"));
            for n in recipe.fixed_size.map_or(vec![1, 2, 3, 7, 20, 60, 200], |n| vec![n]) {
                for level in [Level::Quick, Level::Full] {
                    let making = Making { family: family.name, task: task.name(), seed: 1, n, level };
                    let found = recipe.make(&making).scene.coordinates().len() as u64;
                    let said = recipe.coordinates(n as u64);
                    assert!(found <= said, "{name}, n = {n}: {found} coordinates, and the recipe says {said}");
                    // A much larger stated size would refuse a scene that is not too large.
                    assert!(
                        said <= 20 * found + 2000,
                        "{name}, n = {n}: {found} coordinates, and the recipe says {said}"
                    );
                }
            }
            families += 1;
        }
    }
    assert!(families > 80, "{families} families");
}
