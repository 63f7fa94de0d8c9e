//! The Parquet format: typed columns, in groups of rows, each compressed separately.
//!
//! Rows arrive one at a time and are stored by column until a group is full, so memory is that of one group. Text has a
//! dictionary in each group; repeated values, such as names of suites and backends, cost a few bits a row. The codec is
//! gzip, which every reader of Parquet supports and which is already a dependency for other files; Snappy files are
//! half as large again.

use crate::error::WriteError;
use std::fs::File;
use std::sync::Arc;

use bytes::Bytes;
use parquet::basic::{Compression, GzipLevel, LogicalType, Repetition, TimeUnit, Type as Physical};
use parquet::column::writer::ColumnWriter;
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use predicament_records::Kind;

use crate::sink::Sink;
use crate::value::{Typed, Value};

/// The maximum number of rows in a group.
const ROWS: usize = 1 << 16;
/// The number of bytes of text at which a group is full, whatever its number of rows.
const TEXT: usize = 1 << 25;

pub(crate) struct RowGroups {
    writer: SerializedFileWriter<File>,
    columns: Vec<Kept>,
    rows: usize,
    text: usize,
}

/// The values of a column in the current group.
struct Kept {
    values: Values,
    /// The value 1 for a present cell, 0 for a null; only for optional columns.
    levels: Option<Vec<i16>>,
}

enum Values {
    /// The concatenated texts, and the end of each.
    Text(Vec<u8>, Vec<usize>),
    /// Integers and timestamps.
    Int64(Vec<i64>),
    Float64(Vec<f64>),
    Bool(Vec<bool>),
}

impl RowGroups {
    pub fn new(file: File, columns: &[Typed]) -> Result<RowGroups, WriteError> {
        let fields = columns.iter().map(field).collect::<Result<Vec<_>, _>>()?;
        let schema = Type::group_type_builder("schema").with_fields(fields).build()?;
        // Minimum and maximum of each group, but not of its pages: most tables have one page.
        let properties = WriterProperties::builder()
            .set_compression(Compression::GZIP(GzipLevel::default()))
            .set_statistics_enabled(EnabledStatistics::Chunk)
            .set_offset_index_disabled(true)
            .build();
        let writer = SerializedFileWriter::new(file, Arc::new(schema), Arc::new(properties))?;
        let columns = columns
            .iter()
            .map(|column| Kept { values: Values::of(column.kind), levels: column.is_optional.then(Vec::new) });
        Ok(RowGroups { writer, columns: columns.collect(), rows: 0, text: 0 })
    }

    fn write_group(&mut self) -> Result<(), ParquetError> {
        let mut group = self.writer.next_row_group()?;
        for kept in &mut self.columns {
            let mut column =
                group.next_column()?.ok_or_else(|| ParquetError::General("a column is missing".to_owned()))?;
            let levels = kept.levels.as_deref();
            match (column.untyped(), &mut kept.values) {
                (ColumnWriter::ByteArrayColumnWriter(writer), Values::Text(text, ends)) => {
                    let text = Bytes::from(std::mem::take(text));
                    let starts = std::iter::once(0).chain(ends.iter().copied());
                    let each =
                        starts.zip(ends.iter().copied()).map(|(start, end)| ByteArray::from(text.slice(start..end)));
                    let each: Vec<ByteArray> = each.collect();
                    writer.write_batch(&each, levels, None)?;
                    ends.clear();
                }
                (ColumnWriter::Int64ColumnWriter(writer), Values::Int64(values)) => {
                    writer.write_batch(values, levels, None)?;
                    values.clear();
                }
                (ColumnWriter::DoubleColumnWriter(writer), Values::Float64(values)) => {
                    writer.write_batch(values, levels, None)?;
                    values.clear();
                }
                (ColumnWriter::BoolColumnWriter(writer), Values::Bool(values)) => {
                    writer.write_batch(values, levels, None)?;
                    values.clear();
                }
                _ => return Err(ParquetError::General("a column of another type".to_owned())),
            }
            if let Some(levels) = &mut kept.levels {
                levels.clear();
            }
            column.close()?;
        }
        group.close()?;
        (self.rows, self.text) = (0, 0);
        Ok(())
    }
}

impl Sink for RowGroups {
    fn push(&mut self, _: &[&str], values: &[Value<'_>]) -> Result<(), WriteError> {
        for (kept, value) in self.columns.iter_mut().zip(values) {
            if let Some(levels) = &mut kept.levels {
                levels.push(i16::from(*value != Value::Null));
            }
            match (&mut kept.values, *value) {
                (_, Value::Null) => {}
                (Values::Text(text, ends), Value::Text(cell)) => {
                    text.extend_from_slice(cell.as_bytes());
                    ends.push(text.len());
                    self.text += cell.len();
                }
                (Values::Int64(numbers), Value::Int64(number) | Value::Timestamp(number)) => numbers.push(number),
                (Values::Float64(numbers), Value::Float64(number)) => numbers.push(number),
                (Values::Bool(flags), Value::Bool(flag)) => flags.push(flag),
                (_, value) => return Err(WriteError::Type(format!("{value:?}"))),
            }
        }
        self.rows += 1;
        if self.rows == ROWS || self.text >= TEXT { Ok(self.write_group()?) } else { Ok(()) }
    }

    fn finish(mut self: Box<Self>) -> Result<(), WriteError> {
        if self.rows > 0 {
            self.write_group()?;
        }
        self.writer.close()?;
        Ok(())
    }
}

impl Values {
    fn of(kind: Kind) -> Values {
        match kind {
            Kind::Text => Values::Text(Vec::new(), Vec::new()),
            Kind::Int64 | Kind::Timestamp => Values::Int64(Vec::new()),
            Kind::Float64 => Values::Float64(Vec::new()),
            Kind::Bool => Values::Bool(Vec::new()),
        }
    }
}

/// The Parquet type of a column. Timestamps are in UTC but declared without a time zone, so that readers neither shift
/// them nor need a time zone database.
fn field(column: &Typed) -> Result<Arc<Type>, ParquetError> {
    let (physical, logical) = match column.kind {
        Kind::Text => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
        Kind::Int64 => (Physical::INT64, None),
        Kind::Float64 => (Physical::DOUBLE, None),
        Kind::Bool => (Physical::BOOLEAN, None),
        Kind::Timestamp => (Physical::INT64, Some(LogicalType::timestamp(false, TimeUnit::MICROS))),
    };
    let repetition = if column.is_optional { Repetition::OPTIONAL } else { Repetition::REQUIRED };
    let builder = Type::primitive_type_builder(&column.name, physical);
    builder.with_repetition(repetition).with_logical_type(logical).build().map(Arc::new)
}
