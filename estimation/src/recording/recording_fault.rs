//! Faults of a recording, and where they are.

// What users write is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

/// Faults told of one file; the last one says that there are more.
pub const MOST_FAULTS: usize = 50;

/// A fault of a recording.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RecordingFault {
    /// The file.
    pub file: String,
    /// Line in the file, from 1; none where the file as a whole is meant.
    pub line: Option<usize>,
    /// The column's name.
    pub column: Option<String>,
    /// Sentence that says what is wrong and what would be right.
    pub detail: String,
    /// Further lines with a fault of this kind, in the same column: the first ones.
    pub further_lines: Vec<usize>,
    /// Number of further lines that have one.
    pub further: usize,
}

/// Kind of a fault that many rows may have.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum FaultKind {
    /// More or fewer cells than the header.
    Cells,
    /// Empty cell.
    Empty,
    /// Text, or a number that isn't finite.
    Number,
    /// Time that doesn't rise.
    Time,
}

/// Further lines that a fault names.
const MOST_LINES: usize = 4;

impl std::fmt::Display for RecordingFault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.file)?;
        if let Some(line) = self.line {
            write!(f, ", line {line}")?;
        }
        if let Some(column) = &self.column {
            write!(f, ", column {}", column.escape_debug())?;
        }
        write!(f, ": {}", self.detail)?;
        match self.further_lines.as_slice() {
            [] => Ok(()),
            lines => {
                let lines: Vec<String> = lines.iter().map(usize::to_string).collect();
                let more = match self.further - lines.len() {
                    0 => String::new(),
                    more => format!(" and {more} more"),
                };
                let word = if self.further == 1 { "line" } else { "lines" };
                write!(f, " (also {word} {}{more})", lines.join(", "))
            }
        }
    }
}

/// Collects the faults of one file, up to [`MOST_FAULTS`].
#[derive(Debug)]
pub struct FaultList {
    file: String,
    faults: Vec<RecordingFault>,
    /// Kinds of the faults that further rows may have, with their places in the list.
    kinds: Vec<(FaultKind, usize)>,
}

impl FaultList {
    /// No fault yet.
    pub fn of(file: &str) -> Self {
        Self {
            file: file.to_owned(),
            faults: Vec::new(),
            kinds: Vec::new(),
        }
    }

    /// Name of the file.
    pub(crate) fn file(&self) -> &str {
        &self.file
    }

    /// Adds a fault.
    pub fn add(&mut self, line: Option<usize>, column: Option<&str>, detail: impl Into<String>) {
        let (line, column, detail) = match self.faults.len() {
            n if n < MOST_FAULTS => (line, column.map(str::to_owned), detail.into()),
            n if n == MOST_FAULTS => (
                None,
                None,
                "it has more faults, which aren't listed".to_owned(),
            ),
            _ => return,
        };
        self.faults.push(RecordingFault {
            file: self.file.clone(),
            line,
            column,
            detail,
            further_lines: Vec::new(),
            further: 0,
        });
    }

    /// Adds a fault of a row, or its line to one of this kind in the same column: a file with one cause has one fault.
    pub(crate) fn add_like(
        &mut self,
        kind: FaultKind,
        line: usize,
        column: Option<&str>,
        detail: impl Into<String>,
    ) {
        let faults = &self.faults;
        let is_like = |(of, at): &&(FaultKind, usize)| {
            *of == kind
                && faults
                    .get(*at)
                    .is_some_and(|fault| fault.column.as_deref() == column)
        };
        let like = self.kinds.iter().find(is_like).map(|(_, at)| *at);
        if let Some(fault) = like.and_then(|at| self.faults.get_mut(at)) {
            fault.further += 1;
            if fault.further_lines.len() < MOST_LINES {
                fault.further_lines.push(line);
            }
            return;
        }
        if self.faults.len() < MOST_FAULTS {
            self.kinds.push((kind, self.faults.len()));
        }
        self.add(Some(line), column, detail);
    }

    /// The value, if there is no fault.
    ///
    /// # Errors
    /// The faults.
    pub fn or(
        self,
        value: impl FnOnce() -> Option<super::Recording>,
    ) -> Result<super::Recording, Vec<RecordingFault>> {
        match value() {
            Some(value) if self.faults.is_empty() => Ok(value),
            _ => Err(self.faults),
        }
    }

    /// The faults.
    pub fn into_faults(self) -> Vec<RecordingFault> {
        self.faults
    }

    /// Whether no further fault is listed.
    pub fn is_full(&self) -> bool {
        self.faults.len() > MOST_FAULTS
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.faults.is_empty()
    }
}
