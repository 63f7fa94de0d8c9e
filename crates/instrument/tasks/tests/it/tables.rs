//! Tests of the tables of tasks: columns, checks, and the round trip to disk.

use predicament_contacts::task::ContactRow;
use predicament_cube_union::task::MassRow;
use predicament_mesh_intersect::task::MeshIntersectRow;
use predicament_mesh_locate::task::MeshLocateRow;
use predicament_overlay::task::snap::SnapRow;
use predicament_polygon_locate::task::LocateRow;
use predicament_records::{Env, Outcome, Plan, Record, Row, RunDir, RunWriter, TableSpec};
use predicament_simplify::task::SimplifyRow;
use predicament_tasks::replies::ReplyRow;

fn locate() -> LocateRow {
    LocateRow {
        suite: "maps".to_owned(),
        scene: "a".to_owned(),
        scene_id: "b".to_owned(),
        backend: "sos".to_owned(),
        surroundings: "land".to_owned(),
        probes: 1,
        in_none: 2,
        in_one: 3,
        in_many: 4,
        on_boundary: 5,
        violations: 6,
    }
}

fn reply() -> ReplyRow {
    ReplyRow {
        suite: "overlays".to_owned(),
        scene: "a".to_owned(),
        scene_id: "b".to_owned(),
        task: "overlay2d".to_owned(),
        backend: "engine:mine".to_owned(),
        part: "union".to_owned(),
        vertices: 1,
        distance: 0.25,
        distance_ulps: 2.0,
        distance_over_l: 0.125,
        class: "rounded".to_owned(),
    }
}

fn contact() -> ContactRow {
    ContactRow {
        suite: "contacts".to_owned(),
        scene: "a".to_owned(),
        scene_id: "b".to_owned(),
        task: "contacts3d".to_owned(),
        backend: "sos".to_owned(),
        rank_a: 1,
        rank_b: 2,
        candidates: 12,
        ended: 5,
        asked: 7,
        registered: 6,
    }
}

fn mass() -> MassRow {
    MassRow {
        suite: "cubes".to_owned(),
        scene: "a".to_owned(),
        scene_id: "b".to_owned(),
        backend: "sos".to_owned(),
        cubes: 1,
        volume: -0.1,
        true_volume: 0.1 + 0.2,
        area: f64::INFINITY,
        limit_area: 5e-324,
        edge_length: 0.0,
        limit_edge_length: f64::MAX,
        corners: 2,
        edge_faces: 3,
        three_faces: 4,
    }
}

fn snap() -> SnapRow {
    SnapRow {
        suite: "snaps".to_owned(),
        scene: "a".to_owned(),
        scene_id: "0123456789abcdef".to_owned(),
        backend: "exact".to_owned(),
        method: "snap".to_owned(),
        pixel: -3,
        hot: 5,
        merged: 1,
        edges: 4,
        new_crossings: 0,
        drift: 0.625,
    }
}

fn simplify() -> SimplifyRow {
    SimplifyRow {
        suite: "simplify".to_owned(),
        scene: "a".to_owned(),
        scene_id: "0123456789abcdef".to_owned(),
        backend: "exact".to_owned(),
        triangles: 9,
        target: 2,
        left: 4,
        collapsed: 3,
        refused: 5,
        turned: 0,
        undecided: 1,
        needless: 5,
        reach: Some(0.25),
    }
}

fn mesh_locate() -> MeshLocateRow {
    MeshLocateRow {
        suite: "mesh-points".to_owned(),
        scene: "a".to_owned(),
        scene_id: "0123456789abcdef".to_owned(),
        backend: "exact".to_owned(),
        triangles: 4,
        kind: "vertex".to_owned(),
        probes: 9,
        in_region: 5,
        on_mesh: 3,
        contradictions: 1,
        undecided: 0,
        known: 8,
        lost: 2,
    }
}

fn mesh_intersect() -> MeshIntersectRow {
    MeshIntersectRow {
        suite: "intersections".to_owned(),
        scene: "a".to_owned(),
        scene_id: "0123456789abcdef".to_owned(),
        backend: "sos:per-mesh".to_owned(),
        operation: "union".to_owned(),
        given: 24,
        points: 8,
        perturbed: 30,
        limit: 20,
        merged: 7,
        flat: 4,
        cancelled: 6,
        covered: 5,
        rounded: 19,
        moved: 3,
        collapsed: 1,
        turned: 2,
        folded: 9,
        crossing: 10,
        mended: 11,
        left: 12,
    }
}

/// The tables of all tasks, each once.
fn tables() -> Vec<TableSpec> {
    let mut tables: Vec<TableSpec> = predicament_bundle::tasks().iter().flat_map(|task| task.own_tables()).collect();
    tables.sort_by_key(|table| table.file);
    tables.dedup();
    tables
}

#[test]
fn columns_are_the_fields_in_their_order() {
    fn header<R: Row>(row: &R) -> Vec<String> {
        let value = serde_json::to_string(row).unwrap();
        let mut names: Vec<(usize, String)> = serde_json::from_str::<serde_json::Map<_, _>>(&value)
            .unwrap()
            .keys()
            .map(|name| (value.find(&format!("\"{name}\":")).unwrap(), name.clone()))
            .collect();
        names.sort();
        names.into_iter().map(|(_, name)| name).collect()
    }
    assert_eq!(header(&locate()), LocateRow::COLUMNS);
    assert_eq!(header(&contact()), ContactRow::COLUMNS);
    assert_eq!(header(&mass()), MassRow::COLUMNS);
    assert_eq!(header(&snap()), SnapRow::COLUMNS);
    assert_eq!(header(&simplify()), SimplifyRow::COLUMNS);
    assert_eq!(header(&mesh_locate()), MeshLocateRow::COLUMNS);
    assert_eq!(header(&mesh_intersect()), MeshIntersectRow::COLUMNS);
    assert_eq!(header(&reply()), ReplyRow::COLUMNS);
    // By the names of their files.
    let all = [
        TableSpec::of::<ContactRow>(),
        TableSpec::of::<LocateRow>(),
        TableSpec::of::<MassRow>(),
        TableSpec::of::<MeshIntersectRow>(),
        TableSpec::of::<MeshLocateRow>(),
        TableSpec::of::<ReplyRow>(),
        TableSpec::of::<SimplifyRow>(),
        TableSpec::of::<SnapRow>(),
    ];
    assert_eq!(tables(), all);
}

#[test]
fn every_table_survives_the_disk() {
    let folder = tempfile::tempdir().unwrap();
    let plan = RunDir::open("tests/data/checked").unwrap().plan;
    let plan = Plan { scenes: Vec::new(), ..plan };
    let mut writer = RunWriter::create(folder.path(), &plan, &Env::default(), &tables()).unwrap();
    writer.write(&[locate()]).unwrap();
    let records = [Record::of(&contact()).unwrap(), Record::of(&mass()).unwrap(), Record::of(&locate()).unwrap()];
    writer.append(&records).unwrap();
    writer.write(&[snap()]).unwrap();
    writer.write(&[simplify()]).unwrap();
    writer.write(&[mesh_locate()]).unwrap();
    writer.write(&[mesh_intersect()]).unwrap();
    writer.write(&[reply()]).unwrap();
    writer.finish(Outcome::Complete).unwrap();
    let run = RunDir::open(folder.path()).unwrap();
    assert_eq!(run.rows().unwrap(), vec![locate(), locate()]);
    assert_eq!(run.rows().unwrap(), vec![contact()]);
    assert_eq!(run.rows().unwrap(), vec![mass()]);
    assert_eq!(run.rows().unwrap(), vec![snap()]);
    assert_eq!(run.rows().unwrap(), vec![simplify()]);
    assert_eq!(run.rows().unwrap(), vec![mesh_locate()]);
    assert_eq!(run.rows().unwrap(), vec![mesh_intersect()]);
    assert_eq!(run.rows().unwrap(), vec![reply()]);
}

#[test]
fn rows_that_make_no_sense_are_not_written() {
    for contact in [ContactRow { registered: 8, ..contact() }, ContactRow { ended: 4, ..contact() }] {
        assert!(Record::of(&contact).is_err());
    }
    for row in [
        MeshLocateRow { probes: 8, ..mesh_locate() },
        MeshLocateRow { undecided: 1, ..mesh_locate() },
        MeshLocateRow { lost: 10, ..mesh_locate() },
        MeshLocateRow { known: 10, ..mesh_locate() },
    ] {
        assert!(Record::of(&row).is_err());
    }
    for row in [MeshIntersectRow { left: 22, ..mesh_intersect() }, MeshIntersectRow { flat: 25, ..mesh_intersect() }] {
        assert!(Record::of(&row).is_err());
    }
    for row in [SimplifyRow { left: 10, ..simplify() }, SimplifyRow { needless: 6, ..simplify() }] {
        assert!(Record::of(&row).is_err());
    }
    let masses = [
        MassRow { true_volume: -0.5, ..mass() },
        MassRow { limit_area: -1.0, ..mass() },
        MassRow { limit_edge_length: f64::NAN, ..mass() },
    ];
    for mass in masses {
        assert!(Record::of(&mass).is_err(), "{mass:?}");
    }
    // Volumes of cubes that are too small or too large for it.
    for true_volume in [0.0, f64::INFINITY] {
        assert!(Record::of(&MassRow { true_volume, ..mass() }).is_ok());
    }
    for drift in [-0.5, f64::NAN, f64::INFINITY] {
        assert!(Record::of(&SnapRow { drift, ..snap() }).is_err(), "{drift}");
    }
}
