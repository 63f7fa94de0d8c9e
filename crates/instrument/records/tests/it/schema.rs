//! The published schema agrees with the rows.

use predicament_records::{
    AnswerRow, DecimalsRow, FindingRow, ImportRow, Kind, PhaseRow, PlannedScene, Row, SampledRow, SegmentRow, TABLES,
    TableSpec, ThroughputRow, schema_json, schema_markdown,
};

fn tables() -> Vec<TableSpec> {
    let more = [
        TableSpec::of::<AnswerRow>(),
        TableSpec::of::<DecimalsRow>(),
        TableSpec::of::<ImportRow>(),
        TableSpec::of::<PhaseRow>(),
        TableSpec::of::<SampledRow>(),
        TableSpec::of::<SegmentRow>(),
        TableSpec::of::<PlannedScene>(),
    ];
    TABLES.into_iter().chain(more).collect()
}

#[test]
fn the_columns_of_the_schema_are_those_of_the_file() {
    for table in tables() {
        let names: Vec<&str> = table.schema.iter().map(|column| column.name).collect();
        assert_eq!(names, table.columns, "{}", table.file);
        assert!(!table.about().is_empty() && !table.about().contains(table.file), "{}", table.file);
        for column in table.schema {
            assert!(column.meaning().ends_with(['.', '…']), "{}: {}: {}", table.file, column.name, column.meaning());
            assert!(!column.meaning().contains(['[', '\n']), "{}", column.meaning());
            assert!(column.kind != Kind::Text || column.unit.is_empty(), "{}: a text has no unit", column.name);
        }
    }
}

#[test]
fn types_names_and_units_are_those_of_the_fields() {
    let column = |schema: &[predicament_records::Column], name: &str| *schema.iter().find(|c| c.name == name).unwrap();
    let distance = column(FindingRow::SCHEMA, "distance_over_L");
    assert_eq!((distance.kind, distance.is_optional, distance.unit), (Kind::Float64, true, "L"));
    let id = column(FindingRow::SCHEMA, "finding_id");
    assert_eq!((id.kind, id.is_optional), (Kind::Text, false), "ids are text");
    let queries = column(ThroughputRow::SCHEMA, "queries");
    assert_eq!((queries.kind, queries.unit), (Kind::Int64, "count"));
    assert_eq!(column(ThroughputRow::SCHEMA, "ns_per_query").unit, "ns");
    let page = schema_markdown(&tables());
    assert!(page.contains("### throughput\nOne timed sample.\n"), "{page}");
    assert!(page.contains("| `bytes` | int64, or null | bytes | The memory of the phase's result, in bytes;"));
    let json = schema_json(&[TableSpec::of::<ThroughputRow>()]);
    assert_eq!(json["tables"][0]["columns"][7]["type"], "float64");
    assert_eq!(json["tables"][0]["columns"].as_array().unwrap().len(), ThroughputRow::COLUMNS.len());
}
