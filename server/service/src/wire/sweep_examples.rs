//! Examples of the documents of sweeps and comparisons.

use serde_json::{Value, json};

use crate::wire::examples::{study, study_toml};

/// A study with two walls.
pub fn document() -> Value {
    json!({"name": "two walls", "study": study(), "grid": {"geometry.wall_mm": [2.5, 3]}})
}

/// A study with two walls, as TOML.
pub fn document_toml() -> String {
    let study = study_toml()
        .replace("[[inputs]]", "[[study.inputs]]")
        .replace("[method]", "[study.method]")
        .replace("[accuracy]", "[study.accuracy]");
    format!("[grid]\n\"geometry.wall_mm\" = [2.5, 3]\n[study]\n{study}")
}

/// Further designs.
pub fn further() -> Value {
    json!({"designs": [{"name": "thick", "set": {"geometry.wall_mm": 3.5}}]})
}

/// The beginning of a comparison's locations as CSV.
pub fn comparison_csv() -> &'static str {
    "study,name,geometry.wall_mm,location,rank,rank_certain\n019aa2b3-7c4d-7e5f-8a6b-1c2d3e4f5a6c,wall_mm = 3,3,P3,1,true\n"
}

#[cfg(test)]
mod tests {
    use document::{Format, parse};
    use documents::sweep::{MOST_SUBMITTED, Sweep, designs_of};

    use super::*;

    #[test]
    fn the_example_sweeps_are_valid_and_the_same() {
        let refuse = |path: &str| Err(path.to_owned());
        let mut toml = parse(&document_toml(), Format::Toml).expect("is TOML");
        toml["name"] = "two walls".into();
        let read = |value: &Value| {
            Sweep::from_value(value, MOST_SUBMITTED, &refuse).expect("a valid sweep")
        };
        let sweep = read(&document());
        assert_eq!(read(&toml), sweep);
        assert_eq!(
            designs_of(&sweep.base, &further(), MOST_SUBMITTED)
                .expect("valid")
                .len(),
            1
        );
    }
}
