//! Bodies for what hyper refuses before any handler sees it.
//!
//! An address or headers that are too long, and what isn't HTTP, get an answer of hyper's own, without a body, and their connection is closed. A client that reads problem
//! documents should find one there too, with the headers of every answer, and hyper has no place to give it any: they are put in on the way to the client.

// What users send is read here: nothing of it may end in a panic.
#![warn(clippy::expect_used, clippy::indexing_slicing, clippy::panic)]

use std::io::{self, IoSlice};
use std::pin::Pin;
use std::task::{Context, Poll, ready};

use axum::http::StatusCode;
use tokio::io::{AsyncRead, AsyncWrite, ReadBuf};

use crate::http::edge::guard::{SECURITY_HEADERS, UNKEPT};
use crate::http::edge::problem_document::Problem;

/// A connection on which every refusal has a problem document.
#[derive(Debug)]
pub(crate) struct Refusals<S> {
    stream: S,
    /// Bytes that are written instead of hyper's answer, and how many of them were.
    instead: Option<(Vec<u8>, usize)>,
}

impl<S> Refusals<S> {
    /// Wraps the connection.
    pub fn on(stream: S) -> Self {
        Self {
            stream,
            instead: None,
        }
    }
}

/// hyper's refusal with a document, when that is what the bytes are: every answer of ours has a body.
fn with_document(bytes: &[u8]) -> Option<Vec<u8>> {
    const NO_BODY: &str = "\r\nconnection: close\r\ncontent-length: 0\r\n";
    let (status, _) = bytes.strip_prefix(b"HTTP/1.1 ")?.split_first_chunk::<3>()?;
    let detail = match status {
        b"400" => "this isn't a request of HTTP/1.1",
        b"414" => "the address is too long: one has at most 65 534 bytes",
        b"431" => "a request has at most 100 headers, of 64 kB together",
        _ => return None,
    };
    let head = std::str::from_utf8(bytes).ok()?;
    if !head.contains(NO_BODY) || !head.ends_with("\r\n\r\n") {
        return None;
    }
    let problem = Problem::new(StatusCode::from_bytes(status).ok()?, detail);
    let document = problem.document().to_string();
    let mut described = format!(
        "\r\nconnection: close\r\ncontent-type: application/problem+json\r\ncontent-length: {}\r\n",
        document.len()
    );
    for (name, value) in SECURITY_HEADERS.iter().chain([&UNKEPT]) {
        described.push_str(&format!("{name}: {value}\r\n"));
    }
    Some((head.replacen(NO_BODY, &described, 1) + &document).into_bytes())
}

impl<S: AsyncRead + Unpin> AsyncRead for Refusals<S> {
    fn poll_read(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
        buffer: &mut ReadBuf<'_>,
    ) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_read(context, buffer)
    }
}

impl<S: AsyncWrite + Unpin> AsyncWrite for Refusals<S> {
    fn poll_write(
        self: Pin<&mut Self>,
        context: &mut Context<'_>,
        bytes: &[u8],
    ) -> Poll<io::Result<usize>> {
        let Self { stream, instead } = self.get_mut();
        if instead.is_none() {
            *instead = with_document(bytes).map(|refusal| (refusal, 0));
        }
        let Some((refusal, written)) = instead else {
            return Pin::new(stream).poll_write(context, bytes);
        };
        while let Some(rest) = refusal.get(*written..).filter(|rest| !rest.is_empty()) {
            match ready!(Pin::new(&mut *stream).poll_write(context, rest))? {
                0 => return Poll::Ready(Err(io::ErrorKind::WriteZero.into())),
                more => *written += more,
            }
        }
        *instead = None;
        Poll::Ready(Ok(bytes.len()))
    }

    fn poll_write_vectored(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
        bytes: &[IoSlice<'_>],
    ) -> Poll<io::Result<usize>> {
        // A refusal is a head alone.
        if let [head] = bytes {
            return self.poll_write(context, head);
        }
        Pin::new(&mut self.stream).poll_write_vectored(context, bytes)
    }

    fn is_write_vectored(&self) -> bool {
        self.stream.is_write_vectored()
    }

    fn poll_flush(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_flush(context)
    }

    fn poll_shutdown(mut self: Pin<&mut Self>, context: &mut Context<'_>) -> Poll<io::Result<()>> {
        Pin::new(&mut self.stream).poll_shutdown(context)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tokio::io::{AsyncReadExt, AsyncWriteExt};

    #[tokio::test]
    async fn a_refusal_gets_its_document_however_slowly_it_is_read() {
        let head = "HTTP/1.1 431 Request Header Fields Too Large\r\nconnection: close\r\ncontent-length: 0\r\ndate: x\r\n\r\n";
        let (near, mut far) = tokio::io::duplex(7);
        let mut connection = Refusals::on(near);
        let writing = async move { connection.write_all(head.as_bytes()).await };
        let mut seen = String::new();
        let (written, read) = tokio::join!(writing, far.read_to_string(&mut seen));
        written.expect("writes");
        read.expect("reads");
        let (head, document) = seen.split_once("\r\n\r\n").expect("a head");
        assert!(head.contains("content-type: application/problem+json"));
        for header in ["x-frame-options: DENY\r\n", "cache-control: no-store\r\n"] {
            assert!(head.contains(header), "{head}");
        }
        assert!(head.contains(&format!("content-length: {}\r\n", document.len())));
        let document: serde_json::Value = serde_json::from_str(document).expect("JSON");
        assert_eq!(document["status"], 431);
    }

    #[test]
    fn answers_of_ours_stay_as_they_are() {
        for answer in [
            "HTTP/1.1 400 Bad Request\r\ncontent-length: 2\r\n\r\n{}",
            "HTTP/1.1 204 No Content\r\nconnection: close\r\ncontent-length: 0\r\n\r\n",
            "HTTP/1.1 431",
            "data: HTTP/1.1 431\r\nconnection: close\r\ncontent-length: 0\r\n\r\n",
        ] {
            assert_eq!(with_document(answer.as_bytes()), None, "{answer}");
        }
    }
}
