//! The token of the real program: where it comes from, and where it never goes.

use std::fs;

use reqwest::redirect::Policy;
use reqwest::{Client, StatusCode};

use super::served::Served;
use crate::program::{command, strainsite, text};

const SECRET: &str = "a-token-that-is-in-no-log";

/// All that it can log.
const LOG: (&str, &str) = ("STRAINSITE_LOG", "trace");
const FREE_PORT: [&str; 2] = ["--addr", "127.0.0.1:0"];

#[tokio::test]
async fn the_token_is_in_no_log_and_neither_is_the_address_that_works_once() {
    let folder = tempfile::tempdir().expect("temp dir");
    let mut service = Served::start(
        folder.path(),
        &[&FREE_PORT[..], &["--token"]].concat(),
        &[LOG, ("STRAINSITE_TOKEN", SECRET)],
    );
    // A token that is known already is not printed: the address for a browser comes next.
    let link = service.line("in a browser, once: ");
    assert!(link.starts_with(&service.url), "{link}");
    assert_eq!(service.status(SECRET).await, StatusCode::OK);
    let wrong = "a-wrong-token-of-somebody";
    assert_eq!(service.status(wrong).await, StatusCode::UNAUTHORIZED);
    let client = Client::builder().redirect(Policy::none()).build();
    let client = client.expect("a client");
    let first = client.get(&link).send().await.expect("an answer");
    assert_eq!(first.status(), StatusCode::SEE_OTHER);
    let cookie = first.headers()["set-cookie"].to_str().expect("text");
    let cookie = cookie.split(['=', ';']).nth(1).expect("a value").to_owned();
    let second = client.get(&link).send().await.expect("an answer");
    assert_eq!(second.status(), StatusCode::UNAUTHORIZED);
    let log = service.log();
    assert!(
        log.contains("/v1/studies") && log.contains("/login"),
        "requests are logged: {log}"
    );
    let (_, once) = link.split_once("once=").expect("a secret");
    for secret in [SECRET, wrong, once, &cookie] {
        assert!(!log.contains(secret), "{secret} is in the log");
    }
}

#[tokio::test]
async fn a_drawn_token_is_printed_once_and_a_file_s_is_not() {
    let folder = tempfile::tempdir().expect("temp dir");
    let mut service = Served::start(folder.path(), &[&FREE_PORT[..], &["--token"]].concat(), &[]);
    let token = service.line("token ");
    assert_eq!(token.len(), 64, "256 bits in hexadecimal digits");
    assert_eq!(service.status(&token).await, StatusCode::OK);
    drop(service);

    fs::write(folder.path().join("secret"), format!("{SECRET}\n")).expect("writes");
    let mut service = Served::start(
        folder.path(),
        &[&FREE_PORT[..], &["--token-file", "secret"]].concat(),
        &[],
    );
    service.line("in a browser, once: ");
    assert_eq!(service.status(SECRET).await, StatusCode::OK);
    assert_eq!(service.status(&token).await, StatusCode::UNAUTHORIZED);
}

#[tokio::test]
async fn other_machines_are_served_only_with_a_token() {
    let folder = tempfile::tempdir().expect("temp dir");
    for exposed in [["--addr", "0.0.0.0:0"], ["--host", "tires.example"]] {
        let refused = strainsite(folder.path(), &[&["serve"], &exposed[..]].concat());
        assert_eq!(refused.status.code(), Some(2), "{exposed:?}");
        let why = text(&refused.stderr);
        assert!(why.contains("--token") && why.contains("ssh -L"), "{why}");
    }
    let exposed = ["--token", "--addr", "0.0.0.0:0", "--host", "tires.example"];
    let mut served = Served::start(folder.path(), &exposed, &[]);
    let port = served.url.rsplit(':').next().expect("a port").to_owned();
    let token = served.line("token ");
    assert!(
        served
            .line("in a browser, once: ")
            .starts_with(&format!("http://127.0.0.1:{port}/login?once="))
    );
    let request = Client::new().get(format!("http://127.0.0.1:{port}/v1/studies"));
    let named = request.header("host", "tires.example").bearer_auth(token);
    assert_eq!(
        named.send().await.expect("an answer").status(),
        StatusCode::OK
    );
}

#[test]
fn tokens_that_can_not_be_used_are_refused_without_being_shown() {
    let folder = tempfile::tempdir().expect("temp dir");
    fs::write(folder.path().join("secret"), "hunter2 and more").expect("writes");
    let serve = |arguments: &[&str], token: Option<&str>| {
        let mut command = command(
            folder.path(),
            &[&["serve", "--addr", "127.0.0.1:0"], arguments].concat(),
        );
        if let Some(token) = token {
            command.env("STRAINSITE_TOKEN", token);
        }
        let refused = command.output().expect("the program runs");
        assert_eq!(refused.status.code(), Some(2));
        text(&refused.stderr).to_owned()
    };
    let short = serve(&[], Some("hunter2"));
    assert!(
        short.contains("STRAINSITE_TOKEN: a token has 16 to 512"),
        "{short}"
    );
    let spaced = serve(&["--token-file", "secret"], None);
    assert!(spaced.contains("--token-file: a token has"), "{spaced}");
    for told in [short, spaced] {
        assert!(!told.contains("hunter2"), "{told}");
    }
    assert!(
        serve(&[], Some("")).contains("STRAINSITE_TOKEN"),
        "an empty one is no wish to go without"
    );
    assert!(serve(&["--token-file", "missing"], None).contains("not found"));
    assert!(serve(&["--token-file", "secret"], Some(SECRET)).contains("not in both"));
}
