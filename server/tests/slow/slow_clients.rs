//! Clients that open an event stream and don't read it.

use std::collections::BTreeSet;
use std::path::Path;
use std::time::{Duration, Instant};

use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::{TcpSocket, TcpStream};

use crate::program::service::{Program, sql};

const CLIENTS: usize = 100;
/// 3 MB on the wire, far beyond what the service keeps for a client that doesn't read.
const EVENTS: i64 = 20_000;
/// Memory for the clients, bytes each: the send buffer, twice 128 kB as the kernel counts, is the kernel's; the program holds a batch of events and
/// what of it is encoded, less than 100 kB. Five times that is the bound.
const MEMORY: u64 = CLIENTS as u64 * 500_000;

/// A study that has ended after so many events.
async fn told(database: &Path) {
    Program::start(database).kill();
    let mut sql = sql(database).await;
    let study = "insert into studies (id, name, spec, spec_sha256, state, created) values ('a', 'told', '{}', '44136fa355b3678a1146ad16f7e8649e94fb4fc21fe77e8310c060f61caaff8a', 'done', 't')";
    sqlx::query(study).execute(&mut sql).await.expect("stores");
    let events = "with recursive numbers(n) as (select 1 union all select n + 1 from numbers where n < ?1)
        insert into events (id, study, kind, payload, created)
        select n, 'a', iif(n < ?1, 'point-solved', 'done'), json_object('ordinal', n, 'done', n, 'of', ?1), '2026-11-22T00:00:00.000Z' from numbers";
    let stored = sqlx::query(events).bind(EVENTS).execute(&mut sql).await;
    assert_eq!(stored.expect("stores").rows_affected(), EVENTS as u64);
}

/// Asks for the events and doesn't read.
async fn ask(address: &str, after: i64) -> TcpStream {
    let socket = TcpSocket::new_v4().expect("a socket");
    socket.set_recv_buffer_size(8192).expect("a small buffer");
    let address = address.parse().expect("an address");
    let mut stream = socket.connect(address).await.expect("connects");
    let request = format!(
        "GET /v1/studies/a/events HTTP/1.1\r\nHost: {address}\r\nLast-Event-ID: {after}\r\n\r\n"
    );
    stream.write_all(request.as_bytes()).await.expect("asks");
    stream
}

/// Reads until the other side ends the stream or the connection, and gives the numbers of the events that came whole.
async fn read(mut stream: TcpStream) -> BTreeSet<i64> {
    let (mut text, mut buffer) = (Vec::new(), vec![0; 1 << 16]);
    // A connection that the service gave up may end in an error: what came before counts.
    while let Ok(size @ 1..) = stream.read(&mut buffer).await {
        text.extend_from_slice(&buffer[..size]);
        // The end of a chunked body; the connection itself stays open.
        if text.ends_with(b"\r\n0\r\n\r\n") {
            break;
        }
    }
    let text = String::from_utf8_lossy(&text);
    let whole = text.rsplit_once("\n\n").map_or("", |(whole, _)| whole);
    whole
        .lines()
        .filter_map(|line| line.strip_prefix("id:")?.trim().parse().ok())
        .collect()
}

#[tokio::test(flavor = "multi_thread")]
async fn clients_that_do_not_read_cost_little_and_are_dropped_after_thirty_seconds() {
    let folder = tempfile::tempdir().expect("temp dir");
    let database = folder.path().join("test.db");
    told(&database).await;
    let program = Program::start(&database);
    let whole = read(ask(program.address(), 0).await).await;
    assert_eq!(whole, (1..=EVENTS).collect());
    let (files, memory) = (program.open_files(), program.resident_bytes());

    let begun = Instant::now();
    let mut clients = Vec::new();
    for _ in 0..CLIENTS {
        clients.push(ask(program.address(), 0).await);
    }
    tokio::time::sleep(Duration::from_secs(5)).await;
    let grown = program.resident_bytes().saturating_sub(memory);
    eprintln!("{CLIENTS} clients that don't read cost {} kB", grown / 1000);
    assert!(grown < MEMORY, "{grown} bytes");
    let others = read(ask(program.address(), 0).await).await;
    assert_eq!(others, whole, "a client that reads isn't held up");

    tokio::time::sleep_until((begun + Duration::from_secs(20)).into()).await;
    // They were all there at the same time, so that half of them tells; files that the program had open for others come and go.
    let open = program.open_files();
    assert!(
        open >= files + CLIENTS / 2,
        "dropped too early: {open} open files"
    );
    // The limit is 30 s from the last byte that was taken; a loaded machine may be late.
    while program.open_files() >= files + CLIENTS / 10 {
        assert!(
            begun.elapsed() < Duration::from_secs(60),
            "still not dropped"
        );
        tokio::time::sleep(Duration::from_millis(200)).await;
    }
    eprintln!("dropped after {:?}", begun.elapsed());

    for client in clients.into_iter().take(10) {
        let seen = read(client).await;
        let last = *seen.last().expect("some events");
        assert!(last < EVENTS, "the client got everything");
        assert_eq!(seen, (1..=last).collect());
        let missed = read(ask(program.address(), last).await).await;
        assert_eq!(missed, (last + 1..=EVENTS).collect());
    }
}
