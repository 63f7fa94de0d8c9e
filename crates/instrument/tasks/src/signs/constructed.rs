//! The key `constructed`: vertices where lines and planes through the points of a scene meet, and shares of segments.

use predicament_corpus::meet;
use predicament_formats::{CorpusError, Field, Fields, TableKind};
use predicament_predicates::{Construction, ConstructionError, PredicateKind, Scene, ShareError, Vertex};

static CONSTRUCTION: TableKind = TableKind::new("construction", &["ssi", "lpi", "tpi", "ratio", "share"]);

/// The `constructed` of a scene, before its points are known: each with its line in the file.
#[derive(Clone, Debug, Default)]
pub(super) struct Constructions(Vec<(usize, Construction)>);

impl Constructions {
    /// Reads `constructed`; an empty list if the key is missing.
    pub(super) fn read(fields: &Fields<'_, '_>, kind: PredicateKind) -> Result<Constructions, CorpusError> {
        let Some(field) = fields.get("constructed") else { return Ok(Constructions::default()) };
        if !matches!(kind, PredicateKind::Compare | PredicateKind::Orient2d | PredicateKind::Orient3d) {
            let cure = "remove `constructed`, or ask for compare, orient2d or orient3d";
            return Err(field.error(format!("{kind} is about points only"), cure));
        }
        let items = field.items("constructions such as { ssi = [[0, 1], [2, 3]] }")?;
        if items.len() == 0 {
            return Err(field.error("`constructed` is empty", "write a construction, or remove the key"));
        }
        items.map(|item| Ok((item.line(), construction(&item)?))).collect::<Result<_, _>>().map(Constructions)
    }

    /// Constructs the vertices: `c0` is the first one in the file, and so on.
    pub(super) fn add_to(&self, scene: &mut Scene, file: &str) -> Result<(), CorpusError> {
        for (index, &(line, construction)) in self.0.iter().enumerate() {
            let wanted = Vertex::constructed(index);
            let error = |message: String, cure: &str| {
                CorpusError::file(file, format!("{wanted} = {construction}: {message}"), cure).at_line(line)
            };
            let vertex = scene.construct(construction).map_err(|why| error(why.to_string(), cure(why)))?;
            if vertex != wanted {
                return Err(error(format!("the same construction as {vertex}"), "remove one of the two"));
            }
            meet(scene, &construction)
                .map_err(|why| error(why.to_string(), "choose lines and planes that meet in one point"))?;
        }
        Ok(())
    }
}

fn cure(why: ConstructionError) -> &'static str {
    match why {
        ConstructionError::Dimension { .. } => "write ssi in 2D, and lpi or tpi in 3D",
        ConstructionError::Missing { .. } => "indices count from 0",
        ConstructionError::Repeated { .. } => "name different points",
        ConstructionError::TooMany => "divide the scene",
    }
}

fn construction(item: &Field<'_, '_>) -> Result<Construction, CorpusError> {
    let table = item.fields(&CONSTRUCTION)?;
    let ratio = table.get("ratio");
    if let (None, Some(share)) = (&ratio, table.get("share")) {
        return Err(share.error("a `share` without a `ratio`", "write the two points of a segment as `ratio`"));
    }
    let construction = match (table.get("ssi"), table.get("lpi"), table.get("tpi"), ratio) {
        (Some(ssi), None, None, None) => {
            let [first, second] = parts(&ssi, "two segments")?;
            Construction::Ssi([flat(&first)?, flat(&second)?])
        }
        (None, Some(lpi), None, None) => {
            let [line, plane] = parts(&lpi, "a line and a plane")?;
            Construction::Lpi { line: flat(&line)?, plane: flat(&plane)? }
        }
        (None, None, Some(tpi), None) => {
            let [first, second, third] = parts(&tpi, "three planes")?;
            Construction::Tpi([flat(&first)?, flat(&second)?, flat(&third)?])
        }
        (None, None, None, Some(ends)) => {
            let share = table.required("share")?;
            let cure = "write a fraction in quotes, such as \"1/3\"";
            let of_first = share.str()?.parse().map_err(|why: ShareError| share.error(why.to_string(), cure))?;
            Construction::Ratio { ends: flat(&ends)?, share: of_first }
        }
        (None, None, None, None) => {
            let what = "one of `ssi`, `lpi`, `tpi` and `ratio`";
            return Err(table.lacking(what, table.error("a construction without a kind", format!("write {what}"))));
        }
        _ => {
            let cure = "keep one of `ssi`, `lpi`, `tpi` and `ratio`";
            return Err(table.error("a construction with more than one kind", cure));
        }
    };
    table.finish()?;
    Ok(construction)
}

/// The lines and planes of a construction.
fn parts<'d, 't, const N: usize>(field: &Field<'d, 't>, what: &str) -> Result<[Field<'d, 't>; N], CorpusError> {
    let cure = format!("write {what}: arrays of the points' indices");
    let parts: Vec<_> = field.items(&format!("{what}, each an array of the points' indices"))?.collect();
    let count = parts.len();
    parts.try_into().map_err(|_| field.error(format!("a construction of {count} parts, not {N}"), cure))
}

/// The points that span a line or a plane.
fn flat<const N: usize>(field: &Field<'_, '_>) -> Result<[Vertex; N], CorpusError> {
    let points: Vec<Vertex> =
        field.items("an array of the points' indices")?.map(|point| point.point()).collect::<Result<_, _>>()?;
    let count = points.len();
    let what = if N == 2 { "line" } else { "plane" };
    points.try_into().map_err(|_| field.error(format!("a {what} of {count} points"), format!("write {N} indices")))
}
