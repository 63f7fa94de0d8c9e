//! `show`: draws a scene, a result or a finding as a picture, or as a page with a 3D view.

use std::path::{Path, PathBuf};

use predicament_corpus::LoadedScene;
use predicament_predicates::{Query, Scene, Vertex};
use predicament_records::{RunDir, replace};
use predicament_report::drawing::{Drawing, Look, Role, Window};
use predicament_tasks::output::Canvas;
use predicament_tasks::{AnyTask, Purpose};

use crate::exit::{self, Failure};
use crate::found::{find, load};
use crate::one_scene::OneScene;
use crate::told::cure;
use crate::tool::Tool;
use crate::{child, interrupt, progress};

const EXAMPLES: &str = "\
Select the input as for `solve`: a scene of a suite with -f, or a task on your own files. With --finding it is the \
scene of one finding. Without -b the scene is drawn; with -b also the answer of that backend.

The name of the file selects the format: .svg is a picture, .html is a self-contained page with a view that turns and \
zooms, .json has the same as data (docs/REPORT.md). A picture in space has no perspective. Coordinates are computed \
from exact ones: with --around they are offsets from that vertex, and --radius magnifies points that nearly coincide \
there.

Examples:
  predicament draw scene tilings -f '/tiling$' --out tiling.svg
  predicament draw scene slices -f '/sphere-through-vertices$' -b exact --out parts.html
  predicament draw scene mesh-intersect a.off b.off -b sos:per-mesh --layer difference --out difference.svg --look 30,25
  predicament draw scene lecture -f orientation-inversion --around 2 --radius 1e-15 --out near.svg
  predicament draw scene --finding 3fa9 --run out/run --out finding.html";

/// Draw a scene, the answer of a backend to it, or what a finding is about
#[derive(clap::Args)]
#[command(
    after_help = EXAMPLES,
    override_usage = "predicament draw scene [OPTIONS] --out <FILE> SUITE -f RE\n       \
                      predicament draw scene [OPTIONS] --out <FILE> TASK FILE...\n       \
                      predicament draw scene [OPTIONS] --out <FILE> --finding ID --run DIR"
)]
pub struct Args {
    #[command(flatten)]
    pub scene: OneScene,

    /// The backend whose answer is drawn; default: the scene alone
    #[arg(short = 'b', long = "backend", value_name = "BACKEND")]
    pub backend: Option<String>,

    /// The file to write: .svg, .html or .json
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,

    /// A layer of the picture; may be repeated. The error message about an unknown layer lists all names
    #[arg(long = "layer", value_name = "NAME")]
    pub layers: Vec<String>,

    /// In space: the direction from which the picture is taken, in degrees around the z axis and above the horizon
    #[arg(long, value_name = "AZIMUTH,ELEVATION", default_value = "30,25", allow_hyphen_values = true, value_parser = look)]
    pub look: Look,

    /// A vertex, such as 7 or c0, from which offsets are measured
    #[arg(long, value_name = "VERTEX")]
    pub around: Option<Vertex>,

    /// The radius of the picture around that vertex; default: the whole scene
    #[arg(long, value_name = "LENGTH", requires = "around", value_parser = length)]
    pub radius: Option<f64>,

    /// The id of a finding, or a prefix of it
    #[arg(long, value_name = "ID", requires = "run", conflicts_with_all = ["suites", "filter"])]
    pub finding: Option<String>,

    /// The run that found it
    #[arg(long, value_name = "DIR", requires = "finding")]
    pub run: Option<PathBuf>,
}

/// The kind of output, by the file's name.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Svg,
    Html,
    Json,
}

/// A picture with more parts is too large for browsers; a 3D view can have more.
const MOST_PARTS: usize = 200_000;

/// Runs the command.
pub fn run(args: &Args, tool: &Tool) -> exit::Outcome {
    child::end_with_parent();
    interrupt::leave_at_once();
    let working = progress::working("reading the scene");
    let kind = kind(&args.out)?;
    let (loaded, query) = what(args, tool)?;
    if let Some(v) = args.around.filter(|&v| !loaded.scene.has(v)) {
        return Err(Failure::usage(format!("--around {v}: `{}` has no such vertex", loaded.name)));
    }
    let task = tool.task(loaded.task);
    working.now("solving and drawing");
    let mut canvas = Canvas::new(&loaded.scene, args.around).map_err(Failure::usage)?;
    draw(args, tool, task, &loaded, &mut canvas)?;
    if let Some(query) = &query {
        asked(&loaded.scene, query, &mut canvas).map_err(Failure::usage)?;
    }
    let mut drawing = canvas.finish();
    choose(&mut drawing, &args.layers)?;
    let window = args.radius.map_or(Window::Whole, Window::Around);
    if kind == Kind::Svg && drawing.parts() > MOST_PARTS {
        let message = format!("{} parts are too many for an SVG picture", drawing.parts());
        return Err(Failure::usage(format!("{message}; write a view to an .html file, or choose layers with --layer")));
    }
    let text = match kind {
        Kind::Svg => drawing.svg(args.look, window),
        Kind::Html => drawing.page(&format!("{}/{}", loaded.suite, loaded.name)).map_err(Failure::usage)?,
        Kind::Json => format!("{}\n", drawing.json()),
    };
    replace(&args.out, text.as_bytes()).map_err(Failure::usage)?;
    drop(working);
    say!("{}", args.out.display());
    Ok(exit::OK)
}

/// The scene, and the query of a finding.
fn what(args: &Args, tool: &Tool) -> Result<(LoadedScene, Option<Query>), Failure> {
    let (Some(id), Some(folder)) = (&args.finding, &args.run) else { return Ok((args.scene.load(tool)?, None)) };
    let run = RunDir::open(folder).map_err(Failure::usage)?;
    let finding = find(&run, id, folder)?;
    let loaded = load(&run, finding, args.scene.selector.cache.as_deref(), tool)?;
    // For a finding about several queries, draw the first query. A finding about a whole scene has no query.
    let query = finding.query.split(" | ").next().filter(|query| !query.is_empty()).map(str::parse).transpose();
    Ok((loaded, query.map_err(|error| Failure::usage(format!("findings.csv was changed: {error}")))?))
}

fn draw(
    args: &Args,
    tool: &Tool,
    task: &dyn AnyTask,
    loaded: &LoadedScene,
    canvas: &mut Canvas,
) -> Result<(), Failure> {
    let Some(name) = &args.backend else { return task.draw_scene(loaded, None, canvas).map_err(Failure::usage) };
    let backend = tool.backend(name).map_err(Failure::usage)?;
    let mut drawn = Ok(());
    backend
        .answer_any(task.name(), &loaded.scene, loaded.content.as_ref(), Purpose::Files, &mut |answer| {
            drawn = task.draw_scene(loaded, Some(answer), canvas);
        })
        .map_err(|why| Failure::usage(format!("{}: {why}{}", backend.name(), cure(&why))))?;
    drawn.map_err(Failure::usage)
}

/// Adds a layer with the vertices of a query, labelled by letters in their order.
fn asked(scene: &Scene, query: &Query, canvas: &mut Canvas) -> std::io::Result<()> {
    let vertices: Vec<Vertex> = query.vertices().filter(|&v| scene.has(v)).collect();
    let names: Vec<String> = vertices.iter().zip('a'..='z').map(|(v, letter)| format!("{letter} = {v}")).collect();
    canvas.points(scene, "query", Role::Mark, vertices)?.label(names);
    Ok(())
}

/// Shows exactly the layers with these names; without names, the default layers of the task.
fn choose(drawing: &mut Drawing, names: &[String]) -> Result<(), Failure> {
    let known: Vec<String> = drawing.layers.iter().map(|layer| layer.name.clone()).collect();
    if let Some(unknown) = names.iter().find(|name| !known.contains(name)) {
        return Err(Failure::usage(format!("--layer {unknown}: the drawing has {}", known.join(", "))));
    }
    if !names.is_empty() {
        drawing.layers.iter_mut().for_each(|layer| layer.is_shown = names.contains(&layer.name));
    }
    Ok(())
}

fn kind(out: &Path) -> Result<Kind, Failure> {
    match out.extension().and_then(|extension| extension.to_str()) {
        Some("svg") => Ok(Kind::Svg),
        Some("html") => Ok(Kind::Html),
        Some("json") => Ok(Kind::Json),
        _ => Err(Failure::usage(format!("--out {}: name a file that ends in .svg, .html or .json", out.display()))),
    }
}

fn look(text: &str) -> Result<Look, String> {
    let degrees = |text: &str| text.trim().parse::<f64>().ok().filter(|degrees| degrees.is_finite());
    let found = text.split_once(',').and_then(|(azimuth, elevation)| Some((degrees(azimuth)?, degrees(elevation)?)));
    let (azimuth, elevation) = found.ok_or("write two angles in degrees, such as 30,25")?;
    Ok(Look { azimuth, elevation })
}

fn length(text: &str) -> Result<f64, String> {
    let length = text.parse::<f64>().ok().filter(|length| *length > 0.0 && length.is_finite());
    length.ok_or_else(|| "write a length above 0, such as 1e-15".to_owned())
}
