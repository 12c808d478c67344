//! A database that can't be used is refused at the start by its name. (A damaged row, named when it is read: `tests/api/results.rs`.)

use std::path::Path;

use crate::program::service::{Program, draft};
use crate::program::{strainsite, text};
use crate::small_disk::SmallDisk;

/// SQLite's page size.
const PAGE: usize = 4096;

/// Starts a service that must not start; what it says.
fn refused(database: &Path) -> String {
    let folder = std::env::temp_dir();
    let database = database.to_str().expect("UTF-8");
    let ended = strainsite(
        &folder,
        &["serve", "--addr", "127.0.0.1:0", "--db", database],
    );
    assert_eq!(ended.status.code(), Some(1), "{}", text(&ended.stderr));
    assert_eq!(text(&ended.stdout), "");
    let said = text(&ended.stderr).to_owned();
    assert!(said.contains(database), "{said}");
    said
}

#[tokio::test(flavor = "multi_thread")]
async fn a_damaged_database_is_refused_by_name() {
    let folder = tempfile::tempdir().expect("temp dir");
    let whole = folder.path().join("whole.db");
    let program = Program::start(&whole);
    program.result_hash(&program.submit(&draft()).await).await;
    // A graceful end folds the write-ahead log into the file.
    drop(program);
    let closed = strainsite(folder.path(), &["db", "vacuum", "--db", "whole.db"]);
    assert_eq!(closed.status.code(), Some(0), "{}", text(&closed.stderr));
    let bytes = std::fs::read(&whole).expect("reads");
    assert!(bytes.len() > 20 * PAGE, "{} bytes", bytes.len());

    let mut without_header = bytes.clone();
    without_header[..16].fill(b'x');
    // What the tables are stands in pages of its own, without which nothing else is looked at.
    let has_tables = |page: &[u8]| page.windows(7).any(|text| text == b"CREATE ");
    let (mut overwritten, mut without_tables) = (bytes.clone(), bytes.clone());
    let pages = bytes.len() / PAGE;
    for page in overwritten.chunks_mut(PAGE).skip(pages / 2).step_by(2) {
        if !has_tables(page) {
            page.fill(0xaa);
        }
    }
    for page in without_tables.chunks_mut(PAGE).skip(1) {
        if has_tables(page) {
            page.fill(0xaa);
        }
    }
    let half = bytes[..bytes.len() / 2].to_vec();
    for (name, damaged, because) in [
        ("header.db", without_header, "not a database"),
        ("pages.db", overwritten, "it is corrupt"),
        ("tables.db", without_tables, "malformed"),
        ("half.db", half, "malformed"),
    ] {
        let database = folder.path().join(name);
        std::fs::write(&database, damaged).expect("writes");
        let said = refused(&database);
        assert!(
            said.contains("can't be opened") && said.contains(because),
            "{name}: {said}"
        );
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_read_only_database_is_refused_by_name() {
    let Some(disk) = SmallDisk::mount(4) else {
        return;
    };
    let database = disk.path().join("sealed.db");
    Program::start(&database).kill();
    disk.make_read_only();
    let said = refused(&database);
    assert!(said.to_lowercase().contains("read-only"), "{said}");
}

#[test]
fn a_database_in_no_folder_is_refused_by_name() {
    let folder = tempfile::tempdir().expect("temp dir");
    let said = refused(&folder.path().join("nowhere").join("a.db"));
    assert!(said.contains("can't be opened"), "{said}");
}
