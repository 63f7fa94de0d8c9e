//! Suites can use the tasks of their vocabulary, and no others.

use predicament_corpus::{Canon, Content, Context, Family, Level, Library, Parts, Recipe, SceneFormat, Source, Suite};
use predicament_corpus::{Vocabulary, fmt};
use predicament_formats::{Cache, CorpusError, Fields, Manifest, read_points};
use predicament_predicates::{Dimension, Scene};

/// A task without questions: its scenes are points at a level.
#[derive(Debug)]
struct Points {
    name: &'static str,
    families: &'static [Family],
}

#[derive(Debug, PartialEq)]
struct Height(u64);

impl Content for Height {
    fn count(&self) -> usize {
        1
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("height");
        canon.text(&self.0.to_string());
    }
}

impl SceneFormat for Points {
    fn name(&self) -> &'static str {
        self.name
    }

    fn about(&self) -> &'static str {
        "points, and nothing about them"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["points", "height"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points"]
    }

    fn read(&self, _: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        let points = fields.required("points")?;
        let (dimension, coordinates) = read_points(&points)?;
        let scene =
            Scene::new(dimension, coordinates).map_err(|error| points.error(error.to_string(), "correct it"))?;
        Ok(Source::Written(Parts::new(scene, Height(fields.integer_or("height", 0, 0..=9)?))))
    }

    fn families(&self) -> &'static [Family] {
        self.families
    }

    fn generator_keys(&self) -> &'static [&'static str] {
        &["height"]
    }

    fn naming_keys(&self) -> &'static [&'static str] {
        &["height"]
    }
}

/// A row of points on the x axis, and a single point whose position is a parameter.
static FAMILIES: [Family; 2] = [
    Family {
        name: "row",
        reported_as: Some("rows"),
        parameters: &[],
        about: "integers",
        read: |_, fields| {
            let height = fields.integer_or("height", 0, 0..=9)?;
            Ok(Recipe::new(
                |n| 2 * n,
                move |making| {
                    let coordinates =
                        (0..making.n).flat_map(|at| [f64::from(u32::try_from(at).unwrap()), 0.0]).collect();
                    Parts::new(Scene::new(Dimension::Two, coordinates).unwrap(), Height(height))
                },
            ))
        },
    },
    Family {
        name: "single",
        reported_as: None,
        parameters: &["place"],
        about: "one point",
        read: |_, fields| {
            let place = fields.required("place")?.integer(0..=9)?;
            let x = f64::from(u32::try_from(place).unwrap());
            Ok(Recipe::new(
                |n| 2 * n,
                move |making| {
                    let coordinates = [x, f64::from(u32::try_from(making.seed).unwrap())].into();
                    Parts::new(Scene::new(Dimension::Two, coordinates).unwrap(), Height(place))
                },
            )
            .of_size(1))
        },
    },
];

static FIRST: Points = Points { name: "first", families: &FAMILIES };
static SECOND: Points = Points { name: "second", families: &[] };

fn both() -> Vocabulary {
    Vocabulary::new(vec![&FIRST, &SECOND])
}

fn parse(text: &str) -> Result<Suite, CorpusError> {
    Suite::parse(&both(), "s.toml", &format!("title = \"t\"\n{text}"), None, &Manifest::default())
}

#[test]
#[should_panic(expected = "two tasks are called `first`")]
fn two_tasks_of_one_name_are_refused() {
    static AGAIN: Points = Points { name: "first", families: &[] };
    let _ = Vocabulary::new(vec![&FIRST, &SECOND, &AGAIN]);
}

#[test]
fn tasks_keep_their_order() {
    assert_eq!(both().names().collect::<Vec<_>>(), ["first", "second"]);
    assert_eq!(format!("{:?}", both()), r#"["first", "second"]"#);
}

#[test]
fn a_scene_is_what_its_task_reads() {
    let suite = parse(
        "[[scene]]\nname = \"a\"\ntask = \"second\"\npoints = [[0, 1]]\nheight = 3\n\
         [[generate]]\nfamily = \"row\"\ntask = \"first\"\nn = 2\nn_full = 5\nheight = 4\n\
         [[generate]]\nfamily = \"single\"\ntask = \"first\"\nplace = 7\nseed = 2\n",
    )
    .unwrap();
    let load = |at: usize, level| suite.scenes[at].load(level, &Cache::new("nowhere")).unwrap();
    let names: Vec<&str> = suite.scenes.iter().map(|scene| scene.name.as_str()).collect();
    assert_eq!(names, ["a", "row-first-height-4", "single-first-place-7"]);
    let families: Vec<&str> = suite.scenes.iter().map(|scene| scene.family.as_str()).collect();
    assert_eq!(families, ["a", "rows", "single-first-place-7"]);
    let written = load(0, Level::Quick);
    assert_eq!((written.task, written.content::<Height>(), written.count()), ("second", Some(&Height(3)), 1));
    let sizes = [Level::Quick, Level::Full].map(|level| load(1, level).scene.len());
    assert_eq!(sizes, [2, 5]);
    assert_eq!(load(1, Level::Full).content(), Some(&Height(4)));
    assert_eq!(load(2, Level::Quick).scene.coordinates(), [7.0, 2.0]);
}

#[test]
fn a_generated_scene_has_its_points_where_they_are_written() {
    let table = |places: &str| {
        let text = format!("[[generate]]\nfamily = \"row\"\ntask = \"first\"\nn = 2\nheight = 4\n{places}");
        parse(&text).and_then(|suite| suite.scenes[0].load(Level::Quick, &Cache::new("nowhere")))
    };
    let made = table("").unwrap();
    let rows: Vec<String> = made.scene.coordinates().chunks(2).map(|p| format!("[{}, {}]", p[0], p[1])).collect();
    let same = table(&format!("coordinates = [{}]\n", rows.join(", "))).unwrap();
    assert_eq!((&same.id, same.scene.coordinates()), (&made.id, made.scene.coordinates()));
    let moved = table("coordinates = [[5, \"0x1.8p+1\"], [7, 8]]\n").unwrap();
    assert_eq!(moved.scene.coordinates(), [5.0, 3.0, 7.0, 8.0]);
    assert_eq!(moved.content(), Some(&Height(4)));
    assert_ne!(moved.id, made.id);
    assert_eq!(made.moved(vec![5.0, 3.0, 7.0, 8.0]).unwrap().id, moved.id);
    for (places, message) in [
        ("coordinates = [[5, 6]]\n", "s.toml:7: the scene has 4 coordinates, and 2 are given; write as many points"),
        (
            "coordinates = [[5, 6, 7], [1, 2, 3]]\n",
            "s.toml:7: the family makes points of 2 coordinates, and these have 3",
        ),
        ("coordinates = [[5, 0.1000000000000000001], [7, 8]]\n", "s.toml:7: "),
    ] {
        let error = table(places).map(drop).unwrap_err().to_string();
        assert!(error.starts_with(message), "{error}");
    }
    let text = "title = \"t\"\n[[generate]]\nfamily = \"row\"\ntask = \"first\"\nn = 1\ncoordinates = [[0.1000000000000000001, 1]]\n";
    assert!(fmt(&both(), "s.toml", text).unwrap().contains("coordinates = [[\"0x1.999999999999ap-4\", 1]]"));
}

#[test]
fn what_no_task_knows_is_refused() {
    for (text, message) in [
        (
            "[[scene]]\nname = \"a\"\ntask = \"third\"\n",
            "s.toml:4: no task is called `third`; use one of first, second",
        ),
        (
            "[[scene]]\nname = \"a\"\ntask = \"first\"\npoints = [[0, 0]]\nheigth = 1\n",
            "s.toml:6: a scene has no key `heigth`; remove it or use one of analysis, height, ",
        ),
        (
            "[[generate]]\nfamily = \"column\"\ntask = \"first\"\nn = 1\n",
            "s.toml:3: no family is called `column`; use one of row, single",
        ),
        (
            "[[generate]]\nfamily = \"row\"\ntask = \"second\"\nn = 1\n",
            "s.toml:3: family row does not generate scenes for second; use it for first",
        ),
        ("[[generate]]\nfamily = \"row\"\ntask = \"first\"\nn = 1\nplace = 1\n", "s.toml:6: "),
        ("[[generate]]\nfamily = \"single\"\ntask = \"first\"\nplace = 1\nn = 1\n", "s.toml:6: "),
    ] {
        let error = parse(text).map(drop).unwrap_err().to_string();
        assert!(error.starts_with(message), "{error}");
    }
}

#[test]
fn only_a_task_s_coordinates_are_made_lossless() {
    let text = "title = \"t\"\n[[scene]]\nname = \"a\"\ntask = \"first\"\npoints = [[0.1000000000000000001, 1]]\n\
                [[generate]]\nfamily = \"row\"\ntask = \"first\"\nn = 1\nheight = 1\n";
    let expected =
        text.replace("[[0.1000000000000000001, 1]]", "[[\"0x1.999999999999ap-4\", 1]]  # 0.1000000000000000001");
    assert_eq!(fmt(&both(), "s.toml", text).unwrap(), expected);
    assert_eq!(fmt(&both(), "s.toml", &expected).unwrap(), expected);
}

#[test]
fn a_library_of_other_tasks_is_made_by_its_vocabulary() {
    let error = Library::embedded(&both()).unwrap().suites().unwrap_err().to_string();
    assert!(error.contains("; use one of first, second"), "{error}");
}
