//! Accepts connections, limits what each may cost, and lets them finish at the end.

use std::io;
use std::net::SocketAddr;
use std::pin::pin;
use std::time::Duration;

use axum::Router;
use axum::body::Body;
use hyper::body::Incoming;
use hyper::server::conn::http1;
use hyper::service::{Service, service_fn};
use hyper::{Request, Response};
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::service::TowerToHyperService;
use tokio::net::{TcpListener, TcpSocket, TcpStream};
use tokio::task::JoinSet;

use crate::http::edge::connection_slots::{Answer, ConnectionSlots, HEARING, Slot};
use crate::http::edge::reading::WhileRead;
use crate::http::edge::refusals::Refusals;
use service::work::shutdown::Shutdown;

/// A client that has not sent its headers by then is dropped.
const HEADER_TIMEOUT: Duration = Duration::from_secs(5);
/// A client that takes nothing of its answer for so long is dropped.
const READ_TIMEOUT: Duration = Duration::from_secs(30);
/// Bytes of a request's head, or of an answer that isn't sent yet, that a connection holds.
const BUFFER: usize = 64 << 10;
/// Bytes of an answer that the kernel holds: it would let that grow to megabytes for every client that doesn't read.
const SEND_BUFFER: u32 = 128 << 10;
/// Connections that may wait to be accepted.
const BACKLOG: u32 = 1024;
/// Requests in flight may take this long when the service stops.
const GRACE: Duration = Duration::from_secs(5);
/// A connection that makes room for another one may finish this long what it is about. Strangers arrive as often at most as they are heard, so that there are no
/// more of these than of strangers.
const FAREWELL: Duration = HEARING;
/// Headers beyond what the service takes, so that it can say so itself: hyper's refusal has no body.
const MAX_HEADERS: usize = 1000;

/// Listens on an address.
///
/// # Errors
/// When the address is taken or not ours.
pub fn bind(address: SocketAddr) -> io::Result<TcpListener> {
    let socket = match address {
        SocketAddr::V4(_) => TcpSocket::new_v4(),
        SocketAddr::V6(_) => TcpSocket::new_v6(),
    }?;
    // A service that starts again needn't wait for the connections of the last one to be forgotten.
    #[cfg(unix)]
    socket.set_reuseaddr(true)?;
    // Connections inherit it.
    socket.set_send_buffer_size(SEND_BUFFER)?;
    socket.bind(address)?;
    socket.listen(BACKLOG)
}

/// Serves until `shutdown`, then waits for requests in flight, but not for long.
pub async fn serve(listener: TcpListener, app: Router, mut shutdown: Shutdown) {
    let slots = ConnectionSlots::default();
    let mut connections = JoinSet::new();
    loop {
        let (stream, slot) = tokio::select! {
            () = shutdown.wait() => break,
            next = next(&listener, &slots) => next,
        };
        connections.spawn(converse(stream, app.clone(), slot, shutdown.clone()));
        while connections.try_join_next().is_some() {}
    }
    drop(listener);
    while connections.join_next().await.is_some() {}
}

/// The next connection, with its slot.
async fn next(listener: &TcpListener, slots: &ConnectionSlots) -> (TcpStream, Slot) {
    loop {
        match listener.accept().await {
            Ok((stream, _)) => return (stream, slots.take().await),
            Err(error) => {
                tracing::warn!(%error, "a connection could not be accepted");
                tokio::time::sleep(Duration::from_millis(100)).await;
            }
        }
    }
}

async fn converse(stream: TcpStream, app: Router, mut slot: Slot, mut shutdown: Shutdown) {
    let stream = Refusals::on(WhileRead::new(stream, READ_TIMEOUT));
    let (app, standing) = (TowerToHyperService::new(app), slot.standing());
    let answering = service_fn(|mut request: Request<Incoming>| {
        let busy = standing.busy();
        request.extensions_mut().insert(standing.clone());
        let answer = app.call(request);
        async move {
            answer
                .await
                .map(|answer: Response<Body>| answer.map(|body| Answer::of(body, busy)))
        }
    });
    let mut connection = pin!(
        http1::Builder::new()
            .timer(TokioTimer::new())
            .header_read_timeout(HEADER_TIMEOUT)
            .max_headers(MAX_HEADERS)
            .max_buf_size(BUFFER)
            .serve_connection(TokioIo::new(stream), answering)
    );
    let patience = tokio::select! {
        ended = connection.as_mut() => return note(ended),
        () = shutdown.wait() => GRACE,
        () = slot.asked_to_leave() => FAREWELL,
    };
    connection.as_mut().graceful_shutdown();
    note(
        tokio::time::timeout(patience, connection)
            .await
            .unwrap_or(Ok(())),
    );
}

fn note(ended: hyper::Result<()>) {
    if let Err(error) = ended {
        tracing::debug!(%error, "a connection ended early");
    }
}
