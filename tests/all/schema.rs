//! The published JSON Schemas are those of the types, and what the program prints obeys them. With `CURVETO_GOLDEN=1` they are
//! written anew.

use std::path::PathBuf;

use curveto::compare::Comparison;
use curveto::page::PageDocument;
use curveto::write::catalogue::{CatalogueDocument, MethodDocument};
use curveto::write::conic::{ConicDocument, ConicMeasurement, ConicSamples};
use curveto::write::difference::DifferenceDocument;
use curveto::write::json::DrawingDocument;
use curveto::write::measurement::{Measurement, Samples};
use curveto::write::path::PathDocument;
use curveto::write::sphere::SphereDocument;
use curveto::write::spline::SplineDocument;
use schemars::{Schema, schema_for};
use serde_json::Value;

use crate::judges::program::{drawn_text as printed, is_golden};

fn published() -> [(&'static str, Schema); 14] {
    [
        ("drawing", schema_for!(DrawingDocument)),
        ("path", schema_for!(PathDocument)),
        ("difference", schema_for!(DifferenceDocument)),
        ("measurement", schema_for!(Measurement)),
        ("conic", schema_for!(ConicDocument)),
        ("conic-measurement", schema_for!(ConicMeasurement)),
        ("conic-samples", schema_for!(ConicSamples)),
        ("samples", schema_for!(Samples<'_>)),
        ("comparison", schema_for!(Comparison)),
        ("page", schema_for!(PageDocument)),
        ("spline", schema_for!(SplineDocument)),
        ("sphere", schema_for!(SphereDocument)),
        ("methods", schema_for!(CatalogueDocument)),
        ("method", schema_for!(MethodDocument)),
    ]
}

#[test]
fn the_published_schemas_are_those_of_the_types() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("docs/schema");
    for (name, schema) in published() {
        let text = serde_json::to_string_pretty(&schema).unwrap() + "\n";
        let file = folder.join(format!("{name}.json"));
        assert!(
            is_golden(&file, text.as_bytes()),
            "{} is out of date: make golden",
            file.display()
        );
    }
}

fn json(arguments: &str) -> Value {
    serde_json::from_str(&printed(&format!("{arguments} -f json"))).unwrap()
}

/// Checks a value against the parts of JSON Schema that ours use, and that no key is unknown.
fn check(value: &Value, schema: &Value, root: &Value, at: &str) -> Result<(), String> {
    if schema == &Value::Bool(true) {
        return Ok(());
    }
    if let Some(reference) = schema.get("$ref").and_then(Value::as_str) {
        let target = root.pointer(reference.trim_start_matches('#')).unwrap();
        return check(value, target, root, at);
    }
    for key in ["oneOf", "anyOf"] {
        if let Some(choices) = schema.get(key).and_then(Value::as_array) {
            let wrong: Vec<String> = choices
                .iter()
                .filter_map(|choice| check(value, &with_parent(choice, schema), root, at).err())
                .collect();
            return if wrong.len() < choices.len() {
                Ok(())
            } else {
                Err(wrong.join("; "))
            };
        }
    }
    if let Some(constant) = schema.get("const") {
        return (constant == value)
            .then_some(())
            .ok_or(format!("{at} is not {constant}"));
    }
    if let Some(types) = schema.get("type") {
        let types: Vec<&str> = match types {
            Value::Array(types) => types.iter().filter_map(Value::as_str).collect(),
            one => one.as_str().into_iter().collect(),
        };
        let matches = |name: &&str| match *name {
            "object" => value.is_object(),
            "array" => value.is_array(),
            "string" => value.is_string(),
            "number" => value.is_number(),
            "integer" => value.is_u64() || value.is_i64(),
            "boolean" => value.is_boolean(),
            "null" => value.is_null(),
            other => panic!("unknown type {other}"),
        };
        if !types.iter().any(matches) {
            return Err(format!("{at}: {value} is not {types:?}"));
        }
    }
    for required in schema
        .get("required")
        .and_then(Value::as_array)
        .into_iter()
        .flatten()
    {
        if value.get(required.as_str().unwrap()).is_none() {
            return Err(format!("{at} lacks {required}"));
        }
    }
    if let (Some(object), Some(properties)) = (value.as_object(), properties(schema, root)) {
        for (key, value) in object {
            let Some(schema) = properties.get(key) else {
                return Err(format!("{at} has the unknown key {key}"));
            };
            check(value, schema, root, &format!("{at}/{key}"))?;
        }
    }
    if let (Some(array), Some(items)) = (value.as_array(), schema.get("items")) {
        for (i, value) in array.iter().enumerate() {
            check(value, items, root, &format!("{at}/{i}"))?;
        }
    }
    Ok(())
}

/// The properties of an object's schema, those of a schema that it refers to included.
fn properties(schema: &Value, root: &Value) -> Option<serde_json::Map<String, Value>> {
    let mut found = schema.get("properties")?.as_object()?.clone();
    if let Some(reference) = schema.get("$ref").and_then(Value::as_str) {
        let target = root.pointer(reference.trim_start_matches('#'))?;
        found.extend(properties(target, root)?);
    }
    Some(found)
}

/// A choice together with the properties that stand beside the choices; a choice may itself refer elsewhere.
fn with_parent(choice: &Value, parent: &Value) -> Value {
    let mut choice = choice.clone();
    if let (Some(own), Some(others)) = (
        choice.get_mut("properties").and_then(Value::as_object_mut),
        parent.get("properties").and_then(Value::as_object),
    ) {
        own.extend(others.clone());
    }
    choice
}

/// A tagged choice `{kind, ..}` keeps its tag beside a reference: both are looked at as one object.
fn flattened(schema: &Value, root: &Value) -> Value {
    match schema {
        Value::Object(object) => {
            let mut object: serde_json::Map<String, Value> = object
                .iter()
                .map(|(key, value)| (key.clone(), flattened(value, root)))
                .collect();
            let target = object
                .get("$ref")
                .and_then(Value::as_str)
                .and_then(|reference| root.pointer(reference.trim_start_matches('#')))
                .cloned();
            if let (true, Some(target)) = (object.contains_key("properties"), target) {
                object.remove("$ref");
                let others = target["properties"].as_object().unwrap().clone();
                object["properties"].as_object_mut().unwrap().extend(others);
            }
            Value::Object(object)
        }
        Value::Array(array) => array.iter().map(|value| flattened(value, root)).collect(),
        other => other.clone(),
    }
}

/// Each schema, and commands that print what it describes with `-f json`; an underscore is a space within an argument.
const CASES: [(&str, &str); 25] = [
    (
        "conic-samples",
        "measure conic --from 0,0 --control 1,2 --to 3,0 --weight 2 --samples 3",
    ),
    ("drawing", "circle 50 -m chen-2"),
    (
        "conic",
        "conic --from 0,0 --control 1,2 --to 3,0 --weight 2",
    ),
    (
        "conic-measurement",
        "measure conic --from 0,0 --control 1,2 --to 3,0 --weight 2",
    ),
    ("drawing", "circle 50"),
    ("drawing", "ellipse 5 3 -m minimax-g0"),
    ("drawing", "arc 5 --start 0 --end 90 --handle 0.5"),
    ("drawing", "arc --svg M0_0A0_0_0_0_1_5_5"),
    ("measurement", "measure circle 50"),
    ("samples", "measure circle 50 --samples 3"),
    ("measurement", "measure arc 5 3 --start 0 --end 90"),
    (
        "measurement",
        "measure --path M1_0C1_.55_.55_1_0_1C-.55_1-1_.55-1_0C-1-.55-.55-1_0-1C.55-1_1-.55_1_0Z",
    ),
    ("measurement", "measure --path M0_0C0_0_1_1_1_1Q3_1_3_0L0_0"),
    ("comparison", "compare"),
    (
        "difference",
        "diff M1_0C1_.55_.55_1_0_1C-.55_1-1_.55-1_0C-1-.55-.55-1_0-1C.55-1_1-.55_1_0Z M1_0C1_.55_.55_1_0_1C-.55_1-1_.55-1_0C-1-.55-.55-1_0-1C.55-1_1-.55_1_0Z",
    ),
    ("page", "explore circle 50 -m minimax,minimax-g0 -n 3,4"),
    ("path", "path M0_0L5_0A5_5_0_0_1_0_5Z"),
    ("spline", "spline --points 0,0_1,2_3,1"),
    (
        "spline",
        "spline --points 0,0_1,2_3,1 --ends fixed:1,0,0,1 --parametrization arc-length --quadrature gauss2 --transform scale(2)",
    ),
    ("sphere", "sphere 50"),
    (
        "sphere",
        "sphere 50 --hidden dash --view 20,30 --transform scale(2)",
    ),
    ("sphere", "sphere 5 --meridians 3 --hidden none"),
    ("methods", "methods"),
    ("method", "methods minimax"),
    ("method", "methods lancaster-best"),
];

#[test]
fn what_is_printed_obeys_the_schemas() {
    let schemas = published();
    for (name, arguments) in CASES {
        let (_, schema) = schemas.iter().find(|(known, _)| *known == name).unwrap();
        let root = serde_json::to_value(schema).unwrap();
        let root = flattened(&root, &root);
        if let Err(why) = check(&json(arguments), &root, &root, "") {
            panic!("{arguments:?}: {why}");
        }
    }
    let (_, schema) = schemas
        .iter()
        .find(|(known, _)| *known == "measurement")
        .unwrap();
    let root = serde_json::to_value(schema).unwrap();
    let mut wrong = json("measure circle 50");
    wrong["error"]["peak"] = Value::Null;
    assert!(
        check(&wrong, &root, &root, "").is_err(),
        "a schema that accepts everything checks nothing"
    );
}
