//! Errors about scenes with data in files: the messages name the files.

use predicament_corpus::{
    Canon, Content, Context, Elsewhere, Level, Parts, PointSource, SceneFormat, Source, Suite, Vocabulary,
};
use predicament_formats::{Cache, CorpusError, Fields, Manifest};

/// A task about pairs of points in files.
struct Pairs;

#[derive(Debug, PartialEq)]
struct Nothing;

impl Content for Nothing {
    fn count(&self) -> usize {
        1
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("pairs");
    }
}

/// The points of a scene, not yet read.
struct Listed(Vec<PointSource>);

impl Elsewhere for Listed {
    fn load(&self, _: Level, cache: &Cache) -> Result<Parts, CorpusError> {
        let mut last = None;
        for source in &self.0 {
            let (scene, _) = source.scene(cache)?;
            if scene.len() % 2 == 1 {
                return Err(source.error(format!("{} points are no pairs", scene.len()), "add or remove points"));
            }
            last = Some(scene);
        }
        Ok(Parts::new(last.expect("points are required"), Nothing))
    }
}

impl SceneFormat for Pairs {
    fn name(&self) -> &'static str {
        "pairs"
    }

    fn about(&self) -> &'static str {
        "pairs of points"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["points", "probes"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points", "probes"]
    }

    fn read(&self, context: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        let first = fields.required("points")?;
        let read = |field| PointSource::read(context, &field, fields.file());
        let sources: Result<Vec<_>, _> = [Some(first), fields.get("probes")].into_iter().flatten().map(read).collect();
        Ok(Source::elsewhere(Listed(sources?)))
    }
}

/// The error from loading a scene with these lines. Files with two, three and unreadable points are beside its suite.
fn refusal(lines: &str) -> (String, String) {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [("two.csv", "0,0\n1,1\n"), ("three.csv", "0,0\n1,1\n2,2\n"), ("bad.csv", "0,0\n1,x\n")] {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    static PAIRS: Pairs = Pairs;
    let text = format!(
        "title = \"t\"\n[[scene]]\nname = \"first\"\ntask = \"pairs\"\npoints = {{ path = \"two.csv\" }}\n[[scene]]\nname = \"a\"\ntask = \"pairs\"\n{lines}"
    );
    let vocabulary = Vocabulary::new(vec![&PAIRS]);
    let suite = Suite::parse(&vocabulary, "s.toml", &text, Some(folder.path()), &Manifest::default()).unwrap();
    let cache = Cache::new("nowhere");
    suite.scenes[0].load(Level::Quick, &cache).unwrap();
    let error = suite.scenes[1].load(Level::Quick, &cache).map(drop).unwrap_err().to_string();
    (error, folder.path().display().to_string())
}

#[test]
fn an_error_about_a_scene_names_its_data_files_once() {
    let (error, folder) = refusal("points = { path = \"three.csv\" }\n");
    assert_eq!(error, format!("s.toml:9: with {folder}/three.csv: 3 points are no pairs; add or remove points"));
    let (error, folder) = refusal("points = { path = \"two.csv\" }\nprobes = { path = \"three.csv\" }\n");
    // Of two files, the error is about one.
    assert_eq!(error, format!("s.toml:10: with {folder}/three.csv: 3 points are no pairs; add or remove points"));
    // A file that is used twice is named once, and without a file no name is added.
    let (error, folder) = refusal("points = { path = \"three.csv\" }\nprobes = { path = \"three.csv\" }\n");
    assert!(error.starts_with(&format!("s.toml:9: with {folder}/three.csv: 3 points")), "{error}");
    let (error, _) = refusal("points = [[0, 0]]\n");
    assert_eq!(error, "s.toml:9: 1 points are no pairs; add or remove points");
    // An error that already names its file is unchanged.
    let (error, folder) = refusal("points = { path = \"bad.csv\" }\n");
    assert!(error.starts_with(&format!("{folder}/bad.csv:2: ")) && !error.contains("with"), "{error}");
    let (error, folder) = refusal("points = { path = \"none.csv\" }\n");
    assert!(error.starts_with(&format!("s.toml:9: {folder}/none.csv: ")) && !error.contains("with"), "{error}");
}
