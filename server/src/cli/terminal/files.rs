//! The files of a command: which it reads, keeps and writes, looked at before any work is done.

use std::path::{Path, PathBuf};

use crate::cli::terminal::exit::Failure;
use crate::cli::terminal::output::JsonTarget;
use crate::cli::terminal::output_place::{self, Identity};

/// Files that the command line names.
#[derive(Debug, Default)]
pub struct Files {
    database: Option<PathBuf>,
    inputs: Vec<PathBuf>,
    outputs: Vec<PathBuf>,
    folder: Option<PathBuf>,
}

impl Files {
    /// A command that keeps its studies in this database.
    pub(crate) fn of_database(path: &Path) -> Self {
        Self {
            database: Some(path.to_owned()),
            ..Self::default()
        }
    }

    /// Adds files that it reads.
    pub fn reading<P: AsRef<Path>>(mut self, paths: impl IntoIterator<Item = P>) -> Self {
        let paths = paths.into_iter().map(|path| path.as_ref().to_owned());
        self.inputs.extend(paths);
        self
    }

    /// Adds a file that it writes, if it is asked to.
    pub fn writing(mut self, path: Option<&Path>) -> Self {
        self.outputs.extend(path.map(Path::to_owned));
        self
    }

    /// Adds a JSON document.
    pub fn telling(self, target: Option<&JsonTarget>) -> Self {
        match target {
            Some(JsonTarget::File(path)) => self.writing(Some(path)),
            _ => self,
        }
    }

    /// Adds a folder, which is made when it isn't there, and the files in it.
    pub(crate) fn filling(mut self, folder: Option<&Path>, names: &[&str]) -> Self {
        if let Some(folder) = folder {
            self.folder = Some(folder.to_owned());
            let files = names.iter().map(|name| folder.join(name));
            self.outputs.extend(files);
        }
        self
    }

    /// Sees that every output can be written, and ends nothing that the command needs.
    ///
    /// # Errors
    /// A sentence about the first that can't.
    pub fn check(&self) -> Result<(), Failure> {
        let kept = self.kept();
        let mut taken: Vec<(Identity, &'static str)> = kept
            .iter()
            .filter_map(|(path, what)| Some((Identity::of(path)?, *what)))
            .collect();
        for path in &self.outputs {
            let Some(identity) = Identity::of(path) else {
                continue;
            };
            if let Some((_, what)) = taken.iter().find(|(other, _)| *other == identity) {
                return Err(Failure::input(format!(
                    "{} can't be written: it is {what}; name another file",
                    path.display()
                )));
            }
            taken.push((identity, "another output of this command"));
        }
        let folder = self.folder.as_deref();
        folder.map_or(Ok(()), output_place::check_folder)?;
        let made_later =
            |path: &&PathBuf| folder.is_some_and(|f| !f.exists() && path.starts_with(f));
        let mut outputs = self.outputs.iter().filter(|path| !made_later(path));
        outputs.try_for_each(|path| output_place::check(path))
    }

    /// Returns the files that no output may replace.
    fn kept(&self) -> Vec<(PathBuf, &'static str)> {
        let inputs = self.inputs.iter().cloned();
        let mut kept: Vec<(PathBuf, &'static str)> = inputs
            .map(|path| (path, "an input of this command"))
            .collect();
        // SQLite keeps its files beside the one that links lead to.
        let database = self.database.iter();
        for path in database.flat_map(|path| [Some(path.clone()), output_place::followed(path)]) {
            kept.extend(path.iter().flat_map(|path| beside(path)));
        }
        kept
    }
}

/// A database and the files that belong to it.
fn beside(database: &Path) -> impl Iterator<Item = (PathBuf, &'static str)> + '_ {
    let named = |ending: &str| {
        let mut name = database.as_os_str().to_owned();
        name.push(ending);
        (PathBuf::from(name), "a file of the database")
    };
    ["", "-wal", "-shm", "-journal", ".lock"]
        .map(named)
        .into_iter()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_that_a_command_needs_is_an_output() {
        let folder = tempfile::tempdir().expect("temp dir");
        let at = |name: &str| folder.path().join(name);
        std::fs::write(at("study.toml"), "name = 1").expect("writes");
        let files = |output: &str| {
            Files::of_database(&at("a.db"))
                .reading([at("study.toml")])
                .writing(Some(&at(output)))
        };
        files("answer.json").check().expect("free");
        // The database isn't there yet, and its files aren't.
        for (output, what) in [
            ("a.db", "a file of the database"),
            ("./a.db-wal", "a file of the database"),
            ("a.db.lock", "a file of the database"),
            ("study.toml", "an input"),
        ] {
            let refused = files(output).check().expect_err(output);
            assert_eq!(refused.code(), 2);
            assert!(refused.to_string().contains(what), "{refused}");
        }
        let twice = files("b").telling(Some(&JsonTarget::File(at("b"))));
        let refused = twice.check().expect_err("twice");
        assert!(refused.to_string().contains("another output"), "{refused}");
        let null = Path::new("/dev/null");
        let nowhere = Files::default().writing(Some(null)).writing(Some(null));
        nowhere.check().expect("a device takes all");
        let deep = at("x/y");
        let later = Files::default().filling(Some(&deep), &["result.json"]);
        later.check().expect("is made later");
        assert!(!at("x").exists());
    }
}
