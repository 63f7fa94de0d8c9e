//! Predicates of the backend `exact`, as functions of points.

use predicament_conformance::{Axis, Plane, Point2, Point3};
use predicament_exact::Exact;
use predicament_predicates::{Backend, Construction, Dimension, Off, Question, Scene, Sign, Vertex};

pub fn orient2d(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Sign {
    predicament_exact::orient2d(a, b, c)
}

pub fn orient3d(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3]) -> Sign {
    predicament_exact::orient3d(a, b, c, d)
}

pub fn incircle(a: [f64; 2], b: [f64; 2], c: [f64; 2], d: [f64; 2]) -> Sign {
    predicament_exact::incircle(a, b, c, d)
}

pub fn insphere(a: [f64; 3], b: [f64; 3], c: [f64; 3], d: [f64; 3], e: [f64; 3]) -> Sign {
    predicament_exact::insphere(a, b, c, d, e)
}

/// A scene of points that are added one at a time.
struct Draft {
    dimension: Dimension,
    coordinates: Vec<f64>,
    constructions: Vec<Construction>,
}

impl Draft {
    fn new(dimension: Dimension) -> Draft {
        Draft { dimension, coordinates: Vec::new(), constructions: Vec::new() }
    }

    fn input<const D: usize>(&mut self, point: [f64; D]) -> Vertex {
        self.coordinates.extend(point);
        Vertex::input(self.coordinates.len() / D - 1)
    }

    fn constructed(&mut self, construction: Construction) -> Vertex {
        self.constructions.push(construction);
        Vertex::constructed(self.constructions.len() - 1)
    }

    fn point2(&mut self, point: Point2) -> Vertex {
        match point {
            Point2::Input(point) => self.input(point),
            Point2::Ssi(lines) => {
                let lines = lines.map(|line| line.map(|point| self.input(point)));
                self.constructed(Construction::Ssi(lines))
            }
        }
    }

    fn point3(&mut self, point: Point3) -> Vertex {
        match point {
            Point3::Input(point) => self.input(point),
            Point3::Lpi { line, plane } => {
                let (line, plane) = (line.map(|point| self.input(point)), plane.map(|point| self.input(point)));
                self.constructed(Construction::Lpi { line, plane })
            }
            Point3::Tpi(planes) => {
                let planes = planes.map(|plane| plane.map(|point| self.input(point)));
                self.constructed(Construction::Tpi(planes))
            }
        }
    }

    fn scene(self) -> Scene {
        let mut scene = Scene::new(self.dimension, self.coordinates).unwrap();
        self.constructions.into_iter().for_each(|construction| {
            scene.construct(construction).unwrap();
        });
        scene
    }

    fn ask(self, question: Question, args: &[Vertex]) -> Sign {
        question.ask(&Exact.prepare(&self.scene(), Off).unwrap(), args)
    }
}

fn in_plane<const N: usize>(question: Question, points: [Point2; N]) -> Sign {
    let mut draft = Draft::new(Dimension::Two);
    let args = points.map(|point| draft.point2(point));
    draft.ask(question, &args)
}

fn in_space<const N: usize>(question: Question, points: [Point3; N]) -> Sign {
    let mut draft = Draft::new(Dimension::Three);
    let args = points.map(|point| draft.point3(point));
    draft.ask(question, &args)
}

pub mod indirect {
    use super::*;

    pub fn orient2d(a: Point2, b: Point2, c: Point2) -> Sign {
        in_plane(Question::Orient2d(Plane::Xy), [a, b, c])
    }

    pub fn orient3d(a: Point3, b: Point3, c: Point3, d: Point3) -> Sign {
        in_space(Question::Orient3d, [a, b, c, d])
    }

    /// The sign by the harness's judge, in rationals of GMP: the backend has no circles through constructed vertices.
    pub fn incircle(a: Point2, b: Point2, c: Point2, d: Point2) -> Sign {
        let mut draft = Draft::new(Dimension::Two);
        let args = [a, b, c, d].map(|point| draft.point2(point));
        predicament_judge::sign(&draft.scene(), Question::Incircle, &args)
    }

    /// The same for spheres.
    pub fn insphere(a: Point3, b: Point3, c: Point3, d: Point3, e: Point3) -> Sign {
        let mut draft = Draft::new(Dimension::Three);
        let args = [a, b, c, d, e].map(|point| draft.point3(point));
        predicament_judge::sign(&draft.scene(), Question::Insphere, &args)
    }

    pub fn orient2d_of_3d(plane: Plane, a: Point3, b: Point3, c: Point3) -> Sign {
        in_space(Question::Orient2d(plane), [a, b, c])
    }

    pub fn compare2d(axis: Axis, a: Point2, b: Point2) -> Sign {
        in_plane(Question::Compare(axis), [a, b])
    }

    pub fn compare3d(axis: Axis, a: Point3, b: Point3) -> Sign {
        in_space(Question::Compare(axis), [a, b])
    }
}

#[test]
fn exact_conforms() {
    use predicament_conformance::check;
    check::orient2d(orient2d).assert();
    check::orient3d(orient3d).assert();
    check::incircle(incircle).assert();
    check::insphere(insphere).assert();
}

/// The predicates of other numbers, on all predicates.
#[test]
fn exact_conforms_in_singles_and_integers() {
    use predicament_conformance::check;
    use predicament_exact::{f32, i32, i64};
    check::orient2d(|a: [core::primitive::f32; 2], b, c| f32::orient2d(a, b, c)).cases(2000).assert();
    check::insphere(|a: [core::primitive::f32; 3], b, c, d, e| f32::insphere(a, b, c, d, e)).cases(2000).assert();
    check::orient3d(|a: [core::primitive::i32; 3], b, c, d| i32::orient3d(a, b, c, d)).cases(2000).assert();
    check::incircle(|a: [core::primitive::i32; 2], b, c, d| i32::incircle(a, b, c, d)).cases(2000).assert();
    check::orient2d(|a: [core::primitive::i64; 2], b, c| i64::orient2d(a, b, c)).cases(2000).assert();
    check::incircle(|a: [core::primitive::i64; 2], b, c, d| i64::incircle(a, b, c, d)).cases(2000).assert();
    check::insphere(|a: [core::primitive::i64; 3], b, c, d, e| i64::insphere(a, b, c, d, e)).cases(2000).assert();
}
