//! The content of a scene, its syntax in a suite, and a family of generated scenes.

use predicament::corpus::{
    Canon, Content, Context, Family, Items, List, Making, Parts, Recipe, SceneFormat, Source, Spelled, spelled_points,
};
use predicament::formats::{CorpusError, Fields, bits, read_points};
use predicament::predicates::{Scene, Vertex};

use crate::Leftmost;

/// The vertices among which the leftmost are looked for, ascending.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Among(pub Vec<Vertex>);

impl Content for Among {
    fn count(&self) -> usize {
        self.0.len()
    }

    fn canon(&self, canon: &mut Canon) {
        canon.text("leftmost");
        canon.vertices(&self.0);
    }

    fn spelled(&self, scene: &Scene) -> Option<Spelled> {
        let lists = vec![List::required("among", Items::Vertices(self.0.clone()))];
        Some(Spelled { lists, ..spelled_points(scene) })
    }
}

impl SceneFormat for Leftmost {
    fn name(&self) -> &'static str {
        "leftmost"
    }

    fn about(&self) -> &'static str {
        "the vertices with the smallest x"
    }

    fn keys(&self) -> &'static [&'static str] {
        &["points", "among"]
    }

    fn coordinate_keys(&self) -> &'static [&'static str] {
        &["points"]
    }

    fn read(&self, _: &Context<'_>, fields: &Fields<'_, '_>) -> Result<Source, CorpusError> {
        let field = fields.required("points")?;
        let (dimension, coordinates) = read_points(&field)?;
        let scene =
            Scene::new(dimension, coordinates).map_err(|why| field.error(why.to_string(), "mend the points"))?;
        let mut among: Vec<Vertex> = match fields.get("among") {
            None => scene.vertices().collect(),
            Some(among) => among.items("indices of points")?.map(|item| item.point()).collect::<Result<_, _>>()?,
        };
        among.sort_unstable();
        among.dedup();
        if let Some(unknown) = among.iter().find(|vertex| vertex.index() >= scene.len()) {
            return Err(fields.error(format!("there is no point {unknown}"), "indices count from 0"));
        }
        if among.is_empty() {
            return Err(fields.error("there is no point to choose from", "write at least one"));
        }
        Ok(Source::Written(Parts::new(scene, Among(among))))
    }

    fn families(&self) -> &'static [Family] {
        &FAMILIES
    }
}

/// The families of the task.
static FAMILIES: [Family; 1] = [Family {
    name: "columns",
    reported_as: Some("columns"),
    parameters: &["columns"],
    about: "points on a few vertical lines: many share the smallest x",
    read: |_, fields| {
        let columns = fields.integer_or("columns", 8, 1..=1000)?.cast_signed();
        let make = move |making: &Making| {
            let mut random = making.random();
            let points: Vec<[f64; 2]> =
                (0..making.n).map(|_| [bits::integer(random.integer(0, columns - 1)), random.unit()]).collect();
            let scene = Scene::from_points2(&points).expect("integers and fractions are finite");
            let among = scene.vertices().collect();
            Parts::new(scene, Among(among))
        };
        Ok(Recipe::new(|n| 2 * n, make))
    },
}];
