//! Requests that are made to hurt.

use std::time::{Duration, Instant};

use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::net::TcpStream;

use crate::program::service::Program;
use crate::timing::p99;

/// Slow connections at once; the service takes 384 of such, and closes further ones early.
const SLOW: usize = 500;
/// 100 ms on a quiet machine; tests share theirs with each other.
const OTHERS: Duration = Duration::from_secs(2);
/// Headers may take five seconds; a loaded machine may be late.
const CLOSED: Duration = Duration::from_secs(15);
/// Bytes by which a program of this size grows and shrinks from one request to the next; each of the bodies below is smaller or cut off.
const FLAT: u64 = 32 << 20;

/// Sends bytes as they are, and gives the answer's status; 0 when there is none.
async fn status(address: &str, request: &[u8]) -> u16 {
    let mut stream = TcpStream::connect(address).await.expect("connects");
    // The service may answer and close before everything is sent.
    let _ = stream.write_all(request).await;
    let mut answer = Vec::new();
    let _ = stream.read_to_end(&mut answer).await;
    let answer = String::from_utf8_lossy(&answer);
    let code = answer.split(' ').nth(1).and_then(|code| code.parse().ok());
    code.unwrap_or(0)
}

fn post(address: &str, headers: &str, body: &[u8]) -> Vec<u8> {
    let length = body.len();
    let head = format!(
        "POST /v1/studies HTTP/1.1\r\nHost: {address}\r\nContent-Type: application/json\r\nContent-Length: {length}\r\n\
         {headers}Connection: close\r\n\r\n"
    );
    [head.as_bytes(), body].concat()
}

#[tokio::test(flavor = "multi_thread")]
async fn what_is_too_large_too_deep_or_too_many_is_refused_and_costs_no_memory() {
    let folder = tempfile::tempdir().expect("temp dir");
    let program = Program::start(&folder.path().join("test.db"));
    let address = program.address();
    let headers: String = (0..200).map(|k| format!("X-{k}: {k}\r\n")).collect();
    // Ten bytes of a gzip stream that never ends: nothing here inflates, so that its content doesn't matter.
    let bomb = [&[0x1f, 0x8b, 8, 0, 0, 0, 0, 0, 2, 3][..], &[0xed; 100_000]].concat();
    let cases = [
        (431, post(address, &headers, b"{}")),
        (
            431,
            post(address, &format!("X: {}\r\n", "x".repeat(1 << 20)), b"{}"),
        ),
        (413, post(address, "", &vec![b' '; (1 << 20) + 1])),
        (413, post(address, "", &vec![b'['; 8 << 20])),
        (415, post(address, "Content-Encoding: gzip\r\n", &bomb)),
        (400, post(address, "", "[".repeat(900_000).as_bytes())),
        (400, post(address, "", "{\"a\":".repeat(200_000).as_bytes())),
    ];
    let ask = async |rounds: usize| {
        for _ in 0..rounds {
            for (expected, request) in &cases {
                let found = status(address, request).await;
                let head = String::from_utf8_lossy(&request[..200.min(request.len())]);
                assert_eq!(found, *expected, "{head}");
            }
        }
    };
    ask(2).await;
    let before = program.resident_bytes();
    ask(20).await;
    let after = program.resident_bytes();
    eprintln!("{} kB before, {} kB after", before / 1000, after / 1000);
    assert!(after < before + FLAT, "{before} bytes grew to {after}");
    assert_eq!(
        program.json("/v1/studies").await["studies"],
        serde_json::json!([])
    );
}

/// A header that never ends: a byte a second, until the other side closes.
async fn crawl(mut stream: TcpStream) -> Duration {
    let begun = Instant::now();
    let mut answer = [0; 256];
    while begun.elapsed() < CLOSED {
        if stream.write_all(b"x").await.is_err() {
            break;
        }
        let read = tokio::time::timeout(Duration::from_secs(1), stream.read(&mut answer)).await;
        if matches!(read, Ok(Ok(0) | Err(_))) {
            break;
        }
    }
    begun.elapsed()
}

#[tokio::test(flavor = "multi_thread")]
async fn five_hundred_clients_that_crawl_are_closed_and_hold_up_nobody() {
    let folder = tempfile::tempdir().expect("temp dir");
    let program = Program::start(&folder.path().join("test.db"));
    let mut slow = Vec::new();
    for _ in 0..SLOW {
        let mut stream = TcpStream::connect(program.address())
            .await
            .expect("connects");
        let head = b"GET /healthz HTTP/1.1\r\nHost: localhost\r\nX: ";
        stream.write_all(head).await.expect("writes");
        slow.push(tokio::spawn(crawl(stream)));
    }
    let mut times = Vec::new();
    for _ in 0..300 {
        let begun = Instant::now();
        program.json("/v1/studies").await;
        times.push(begun.elapsed());
        tokio::time::sleep(Duration::from_millis(5)).await;
    }
    let others = p99(times);
    let mut longest = Duration::ZERO;
    for task in slow {
        longest = longest.max(task.await.expect("ends"));
    }
    eprintln!("others: p99 {others:?}; the last one was closed after {longest:?}");
    assert!(others < OTHERS, "{others:?}");
    assert!(longest < CLOSED, "{longest:?}");
}
