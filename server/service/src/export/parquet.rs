//! A table as a Parquet file: every column with its type, and their units and origin in the file's metadata.
//!
//! One row group without compression: tables are small, and repeated texts are dictionaries.

use std::collections::HashSet;
use std::sync::Arc;

use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::{Type, TypePtr};
use serde_json::{Map, Value};

use super::table::{TypedColumn, TypedTable, Values};

/// The bytes of a file with this table. Beside `origin`, its metadata has `units`: a JSON object of column names and units.
///
/// # Errors
/// None that a table could cause: names are made distinct, columns are of one length.
pub fn parquet(table: &TypedTable, origin: &[(&str, &str)]) -> Result<Vec<u8>, ParquetError> {
    let names = distinct(table);
    let schema = schema(table, &names)?;
    let units = units(table, &names);
    let origin = origin.iter().map(|(key, value)| entry(key, value));
    let metadata = origin.chain([entry("units", &units)]).collect();
    let properties = WriterProperties::builder()
        .set_key_value_metadata(Some(metadata))
        .build();
    let mut writer = SerializedFileWriter::new(Vec::new(), schema, Arc::new(properties))?;
    let mut rows = writer.next_row_group()?;
    for column in &table.columns {
        if let Some(mut writer) = rows.next_column()? {
            write(&mut writer, &column.values)?;
            writer.close()?;
        }
    }
    rows.close()?;
    writer.into_inner()
}

fn entry(key: &str, value: &str) -> KeyValue {
    KeyValue::new(key.to_owned(), value.to_owned())
}

/// Names of the columns. An input may be named like a column of ours, which CSV bears and data frames don't: the later one gets a number.
fn distinct(table: &TypedTable) -> Vec<String> {
    let given: HashSet<&str> = table.columns.iter().map(|c| c.name.as_str()).collect();
    let mut names: Vec<String> = Vec::new();
    for TypedColumn { name, .. } in &table.columns {
        let is_free = |name: &String| !names.contains(name);
        let numbered = (2..).map(|number| format!("{name}_{number}"));
        let mut numbered = numbered.filter(|name| is_free(name) && !given.contains(name.as_str()));
        let own = Some(name.clone()).filter(is_free);
        names.extend(own.or_else(|| numbered.next()));
    }
    names
}

/// Every column may lack values, so that the files of all studies have one schema.
fn schema(table: &TypedTable, names: &[String]) -> Result<TypePtr, ParquetError> {
    let fields = table.columns.iter().zip(names).map(|(column, name)| {
        let (physical, logical) = match column.values {
            Values::Float(_) => (Physical::DOUBLE, None),
            Values::Integer(_) => (Physical::INT64, None),
            Values::Bool(_) => (Physical::BOOLEAN, None),
            Values::Text(_) => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
        };
        let field = Type::primitive_type_builder(name, physical)
            .with_repetition(Repetition::OPTIONAL)
            .with_logical_type(logical);
        field.build().map(Arc::new)
    });
    let fields = fields.collect::<Result<_, _>>()?;
    let schema = Type::group_type_builder("table").with_fields(fields);
    schema.build().map(Arc::new)
}

fn units(table: &TypedTable, names: &[String]) -> String {
    let unit = |unit: Option<&str>| unit.map_or(Value::Null, Value::from);
    let columns = table.columns.iter().zip(names);
    let units: Map<String, Value> = columns
        .map(|(column, name)| (name.clone(), unit(column.unit)))
        .collect();
    Value::Object(units).to_string()
}

fn write(writer: &mut SerializedColumnWriter<'_>, values: &Values) -> Result<(), ParquetError> {
    match values {
        Values::Float(values) => present::<DoubleType, _>(writer, values, |value| *value),
        Values::Integer(values) => present::<Int64Type, _>(writer, values, |value| *value),
        Values::Bool(values) => present::<BoolType, _>(writer, values, |value| *value),
        Values::Text(values) => {
            present::<ByteArrayType, _>(writer, values, |text| ByteArray::from(text.as_str()))
        }
    }
}

/// Writes the values that there are, and for every row whether there is one.
fn present<T: DataType, V>(
    writer: &mut SerializedColumnWriter<'_>,
    values: &[Option<V>],
    of: impl Fn(&V) -> T::T,
) -> Result<(), ParquetError> {
    let levels: Vec<i16> = values.iter().map(|v| i16::from(v.is_some())).collect();
    let values: Vec<T::T> = values.iter().flatten().map(of).collect();
    writer
        .typed::<T>()
        .write_batch(&values, Some(&levels), None)?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use bytes::Bytes;
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;
    use results::columns::Column;
    use serde_json::json;

    use super::*;

    fn table() -> TypedTable {
        // Numbers that lose bits in other formats.
        let rows = [
            json!([0.1 + 0.2, 3, true, "a"]),
            json!([-5e-324, null, false, "b,\"\n"]),
            json!([null, usize::MAX >> 1, true, "a"]),
        ];
        let columns = [
            Column::float("y", "/0").in_unit("mm"),
            Column::integer("n", "/1"),
            Column::bool("is_a", "/2"),
            Column::text("name", "/3"),
            Column::float("y", "/4"),
        ];
        TypedTable::of(&columns, &rows)
    }

    #[test]
    fn what_is_written_reads_back_with_its_types() {
        let bytes = parquet(&table(), &[("study", "x")]).expect("writes");
        let reader = SerializedFileReader::new(Bytes::from(bytes)).expect("a file");
        let rows: Vec<Vec<Field>> = reader
            .get_row_iter(None)
            .expect("rows")
            .map(|row| {
                row.expect("reads")
                    .get_column_iter()
                    .map(|c| c.1.clone())
                    .collect()
            })
            .collect();
        let text = |text: &str| Field::Str(text.to_owned());
        let (yes, no) = (Field::Bool(true), Field::Bool(false));
        let expected = [
            vec![
                Field::Double(0.1 + 0.2),
                Field::Long(3),
                yes.clone(),
                text("a"),
                Field::Null,
            ],
            vec![
                Field::Double(-5e-324),
                Field::Null,
                no,
                text("b,\"\n"),
                Field::Null,
            ],
            vec![
                Field::Null,
                Field::Long(i64::MAX),
                yes,
                text("a"),
                Field::Null,
            ],
        ];
        assert_eq!(rows, expected);
        let metadata = reader.metadata().file_metadata().key_value_metadata();
        let metadata: Vec<(&str, Option<&str>)> = metadata
            .expect("metadata")
            .iter()
            .map(|entry| (entry.key.as_str(), entry.value.as_deref()))
            .collect();
        let units = r#"{"y":"mm","n":null,"is_a":null,"name":null,"y_2":"1"}"#;
        assert_eq!(metadata, [("study", Some("x")), ("units", Some(units))]);
    }

    #[test]
    fn columns_have_names_of_their_own() {
        let columns = ["key", "key_2", "key", "key"].map(|name| Column::text(name, "/0"));
        let table = TypedTable::of(&columns, &[json!([""])]);
        assert_eq!(distinct(&table), ["key", "key_2", "key_3", "key_4"]);
    }

    #[test]
    fn a_table_without_rows_is_a_file() {
        let table = TypedTable::default().constant("study", "x");
        let bytes = parquet(&table, &[]).expect("writes");
        let reader = SerializedFileReader::new(Bytes::from(bytes)).expect("a file");
        assert_eq!(reader.metadata().file_metadata().num_rows(), 0);
    }
}
