//! Commands that a reader of a result may want next.

use std::fmt::Write;
use std::path::Path;

use results::StudyResult;

use crate::cli::terminal::paint::{FAINT, STRONG, painted};

/// Database of commands that name none.
const USUAL: &str = "strainsite.db";

/// Commands for a study that was run on this database.
pub(crate) fn after_study(result: &StudyResult, database: &Path) -> String {
    let has_films = result
        .answer
        .as_ref()
        .is_some_and(|answer| !answer.films.is_empty());
    let films = [
        (
            "export latest --table films",
            "where each film is glued, mm",
        ),
        (
            "export latest --format svg -o films.svg",
            "the same, to print and glue by",
        ),
    ];
    let rest = [
        ("show latest", "this once more"),
        ("serve", "all of it in a browser"),
    ];
    let shown = if has_films { &films[..] } else { &[] };
    let steps: Vec<(&str, &str)> = shown.iter().chain(&rest).copied().collect();
    told("study", &result.study.id, database, &steps)
}

/// Commands for a sweep that was run on this database.
pub(crate) fn after_sweep(id: &str, database: &Path) -> String {
    let steps = [
        (
            "compare latest",
            "this once more; --baseline ID against another design",
        ),
        (
            "compare latest --format csv --table designs",
            "a row for each design",
        ),
        ("serve", "all of it in a browser"),
    ];
    told("sweep", id, database, &steps)
}

fn told(kind: &str, id: &str, database: &Path, steps: &[(&str, &str)]) -> String {
    let mut text = format!(
        "\n{}\n",
        painted(STRONG, format!("{kind} {id} in {}", database.display()))
    );
    let named = match database == Path::new(USUAL) {
        true => String::new(),
        false => format!(" --db {}", shell_word(database)),
    };
    for (command, why) in steps {
        let _ = writeln!(
            text,
            "  strainsite {command}{named}  {}",
            painted(FAINT, format!("# {why}"))
        );
    }
    text
}

/// A path as a shell takes it for one word.
pub(crate) fn shell_word(path: &Path) -> String {
    let text = path.display().to_string();
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "_./-+".contains(c);
    match text.chars().all(is_plain) && !text.starts_with('-') {
        true => text,
        false => format!("'{}'", text.replace('\'', "'\\''")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::terminal::shown::plain;

    #[test]
    fn commands_name_a_database_of_another_name_and_films_where_there_are_some() {
        let mut result = StudyResult::default();
        result.study.id = "01a2".to_owned();
        let usual = plain(&after_study(&result, Path::new(USUAL)));
        assert!(
            usual.starts_with("\nstudy 01a2 in strainsite.db\n  strainsite show latest  # this"),
            "{usual}"
        );
        assert!(!usual.contains("films"));
        let other = plain(&after_sweep("01a3", Path::new("it's.db")));
        assert!(
            other.contains("strainsite compare latest --db 'it'\\''s.db'  # "),
            "{other}"
        );
    }
}
