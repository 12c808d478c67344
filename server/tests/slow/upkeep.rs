//! SIGKILL at any moment of a backup, a restore, a vacuum, a prune and a merge: the database is whole, and the command can be given again.

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use sqlx::migrate::Migrator;
use sqlx::sqlite::SqliteConnectOptions;
use sqlx::{Connection, SqliteConnection};

use crate::kill::kills;
use crate::program::service::integrity;
use crate::program::{command, stored_points, strainsite, text};

/// Kills of each command, where `STRAINSITE_KILLS` doesn't ask for more.
const KILLS: u32 = 10;
/// Runs of which one has to be killed before its end.
const TRIES: u32 = 5;
/// Events of the database, a kilobyte each: so many that no command is over at once.
const EVENTS: i64 = 3000;
/// Events of the copy that is restored.
const OTHERS: i64 = 1000;

/// A database with so many events, and as much space that is free.
async fn database(path: &Path, events: i64) {
    let options = SqliteConnectOptions::new()
        .filename(path)
        .create_if_missing(true);
    let mut sql = SqliteConnection::connect_with(&options)
        .await
        .expect("opens");
    let migrations = Path::new(env!("CARGO_MANIFEST_DIR")).join("../migrations");
    let migrations = Migrator::new(migrations).await.expect("reads");
    migrations.run(&mut sql).await.expect("makes the tables");
    for change in [
        "insert into studies (id, name, spec, spec_sha256, state, created) values ('a', 'old', '{}', '44136fa355b3678a1146ad16f7e8649e94fb4fc21fe77e8310c060f61caaff8a', 'cancelled', 't')",
        &format!(
            "with recursive n(i) as (select 1 union all select i + 1 from n where i < {})
             insert into events (study, previous, kind, payload, created)
             select 'a', nullif(i - 1, 0), iif(i = {events}, 'cancelled', 'note'), json_object('bytes', hex(randomblob(500))), 't' from n",
            2 * events
        ),
        &format!("delete from events where id > {events}"),
    ] {
        let changed = sqlx::query(sqlx::AssertSqlSafe(change)).execute(&mut sql).await;
        changed.expect("changes");
    }
    sql.close().await.expect("closes");
    // A start seals the rows.
    let store = store::Store::open(path).await.expect("opens");
    store.close().await.expect("closes");
}

/// Events of a whole database.
async fn events(path: &Path) -> i64 {
    assert_eq!(integrity(path).await, "ok", "{}", path.display());
    let options = SqliteConnectOptions::new().filename(path);
    let mut sql = SqliteConnection::connect_with(&options)
        .await
        .expect("opens");
    let count = sqlx::query_scalar("select count(*) from events");
    let count = count.fetch_one(&mut sql).await.expect("a count");
    sql.close().await.expect("closes");
    count
}

/// Kills a command after a while; whether it wasn't over before.
fn is_killed(mut command: Command, after: Duration) -> bool {
    command.stdout(Stdio::null());
    command.stderr(Stdio::null());
    let mut process = command.spawn().expect("starts");
    let begun = Instant::now();
    while begun.elapsed() < after {
        if process.try_wait().expect("a state").is_some() {
            return false;
        }
        std::thread::sleep(Duration::from_millis(1));
    }
    process.kill().expect("kills");
    process.wait().expect("ends").code().is_none()
}

fn runs(folder: &Path, arguments: &[&str]) {
    let done = strainsite(folder, arguments);
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
}

/// Gives the command on a copy of `base.db`, again and again, and kills it at every share of the time that it takes; `check` looks at what
/// there is after each kill. Returns how many kills came before its end.
async fn killed(folder: &Path, arguments: &[&str], check: impl AsyncFn(u32)) -> u32 {
    let base = folder.join("base.db");
    let again = || {
        for ending in ["", "-wal", "-shm", "-journal"] {
            let _ = std::fs::remove_file(folder.join(format!("work.db{ending}")));
        }
        std::fs::copy(&base, folder.join("work.db")).expect("copies");
    };
    let mut whole = Duration::MAX;
    // The first run of a program may take far longer than all others.
    for _ in 0..2 {
        again();
        let begun = Instant::now();
        runs(folder, arguments);
        whole = whole.min(begun.elapsed());
        check(0).await;
    }

    let kills = kills(KILLS);
    let mut unfinished = 0;
    for kill in 1..=kills {
        let share = f64::from(kill) / f64::from(kills + 1);
        // Other work may have slowed the runs that were timed: a run that is over before its kill says how long one takes now.
        for _ in 0..TRIES {
            again();
            let begun = Instant::now();
            if is_killed(command(folder, arguments), whole.mul_f64(share)) {
                unfinished += 1;
                break;
            }
            whole = whole.min(begun.elapsed());
        }
        check(kill).await;
    }
    eprintln!("{arguments:?} takes {whole:?}; {unfinished} of {kills} kills came before its end");
    assert!(whole < Duration::from_secs(20), "{whole:?}");
    unfinished
}

#[tokio::test(flavor = "multi_thread")]
async fn a_killed_backup_leaves_no_copy_that_isnt_whole() {
    let folder = tempfile::tempdir().expect("temp dir");
    let folder = folder.path();
    database(&folder.join("base.db"), EVENTS).await;
    let backup = ["db", "backup", "copy.db", "--db", "work.db"];
    let copy = folder.join("copy.db");
    let unfinished = killed(folder, &backup, async |kill| {
        assert_eq!(events(&folder.join("work.db")).await, EVENTS, "kill {kill}");
        if !copy.exists() {
            runs(folder, &backup);
        }
        assert_eq!(events(&copy).await, EVENTS, "kill {kill}");
        std::fs::remove_file(&copy).expect("removes");
        assert!(!folder.join("copy.db.unfinished").exists());
    });
    assert!(unfinished.await > KILLS / 5);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_killed_restore_leaves_the_database_before_or_the_copy() {
    let folder = tempfile::tempdir().expect("temp dir");
    let folder = folder.path();
    database(&folder.join("base.db"), EVENTS).await;
    database(&folder.join("copy.db"), OTHERS).await;
    let work = folder.join("work.db");
    for more in [&[][..], &["--discard"]] {
        let restore = [&["db", "restore", "copy.db", "--db", "work.db"], more].concat();
        let unfinished = killed(folder, &restore, async |kill| {
            let found = events(&work).await;
            assert!([EVENTS, OTHERS].contains(&found), "kill {kill}: {found}");
            runs(folder, &restore);
            assert_eq!(events(&work).await, OTHERS, "kill {kill}");
            runs(folder, &["db", "check", "--db", "work.db"]);
        });
        assert!(unfinished.await > KILLS / 5);
    }
    let names = std::fs::read_dir(folder).expect("lists");
    for name in names.map(|entry| entry.expect("reads").path()) {
        let kept = name.to_string_lossy().contains("work.db.replaced-");
        let extension = name.extension().unwrap_or_default().to_string_lossy();
        if kept && extension.ends_with('Z') {
            let found = events(&name).await;
            assert!([EVENTS, OTHERS].contains(&found), "{}", name.display());
        }
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn a_killed_vacuum_leaves_a_whole_database() {
    let folder = tempfile::tempdir().expect("temp dir");
    let folder = folder.path();
    database(&folder.join("base.db"), EVENTS).await;
    let vacuum = ["db", "vacuum", "--db", "work.db"];
    let work = folder.join("work.db");
    let unfinished = killed(folder, &vacuum, async |kill| {
        assert_eq!(events(&work).await, EVENTS, "kill {kill}");
        runs(folder, &vacuum);
        assert_eq!(events(&work).await, EVENTS, "kill {kill}");
    });
    assert!(unfinished.await > KILLS / 5);
}

/// Old studies, and the events of each.
const OLD: i64 = 30;
const EVENTS_OF_OLD: i64 = 20;

#[tokio::test(flavor = "multi_thread")]
async fn a_killed_prune_leaves_whole_studies() {
    let folder = tempfile::tempdir().expect("temp dir");
    let folder = folder.path();
    let base = folder.join("base.db");
    database(&base, EVENTS).await;
    let options = SqliteConnectOptions::new().filename(&base);
    let mut sql = SqliteConnection::connect_with(&options)
        .await
        .expect("opens");
    let numbers = "with recursive n(i) as (select 0 union all select i + 1 from n where i + 1 < ?)";
    let studies = "insert into studies (id, name, spec, spec_sha256, state, created, finished)
                   select 'old' || i, 'old', '{}', '44136fa355b3678a1146ad16f7e8649e94fb4fc21fe77e8310c060f61caaff8a', 'cancelled', '2026-01-01', '2026-01-01' from n";
    let events_of_old = format!(
        "insert into events (study, kind, payload, created)
         select 'old' || (i % {OLD}), 'note', json_object('bytes', hex(randomblob(500))), 't' from n"
    );
    for (change, count) in [(studies, OLD), (&events_of_old, OLD * EVENTS_OF_OLD)] {
        let change = format!("{numbers} {change}");
        let changed = sqlx::query(sqlx::AssertSqlSafe(change)).bind(count);
        changed.execute(&mut sql).await.expect("changes");
    }
    sql.close().await.expect("closes");

    let prune = ["db", "prune", "--older-than", "1h", "--db", "work.db"];
    let work = folder.join("work.db");
    let unfinished = killed(folder, &prune, async |kill| {
        let left = events(&work).await - EVENTS;
        assert!(
            left >= 0 && left % EVENTS_OF_OLD == 0,
            "kill {kill}: {left}"
        );
        runs(folder, &prune);
        assert_eq!(events(&work).await, EVENTS, "kill {kill}");
        runs(folder, &["db", "check", "--db", "work.db"]);
    });
    assert!(unfinished.await > KILLS / 5);
}

#[tokio::test(flavor = "multi_thread")]
async fn a_killed_merge_takes_all_of_a_file_or_nothing() {
    let folder = tempfile::tempdir().expect("temp dir");
    let folder = folder.path();
    database(&folder.join("base.db"), OTHERS).await;
    let draft = [
        "run",
        "foot-tire",
        "--set",
        "accuracy.preset=draft",
        "--db",
        "other.db",
    ];
    runs(folder, &draft);
    let theirs = stored_points(&folder.join("other.db")).await;
    assert!(theirs > 0);
    let merge = ["db", "merge", "other.db", "--db", "work.db"];
    let work = folder.join("work.db");
    let unfinished = killed(folder, &merge, async |kill| {
        events(&work).await;
        let found = stored_points(&work).await;
        assert!([0, theirs].contains(&found), "kill {kill}: {found}");
        runs(folder, &merge);
        assert_eq!(stored_points(&work).await, theirs, "kill {kill}");
        runs(folder, &["db", "check", "--db", "work.db"]);
        let names = std::fs::read_dir(folder).expect("lists");
        let left = names.filter(|name| {
            let name = name.as_ref().expect("reads").file_name();
            name.to_string_lossy().contains("merging")
        });
        assert_eq!(left.count(), 0, "kill {kill}");
    });
    assert!(unfinished.await > KILLS / 5);
}
