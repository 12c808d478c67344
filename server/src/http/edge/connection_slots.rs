//! Slots for connections: who hasn't shown that it belongs makes room for others.
//!
//! A connection begins as a stranger. It belongs as soon as one of its requests was let in: with the token or its cookie where the service asks for one, and elsewhere
//! with any whole request but a health check. However many strangers there are and whatever they do, the next newcomer is taken after [`HEARING`] at the latest and has as
//! long to show that it belongs; those who do are only asked to leave between two requests.

use std::collections::BTreeMap;
use std::pin::Pin;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::task::{Context, Poll};
use std::time::{Duration, Instant};

use axum::body::{Body, Bytes, HttpBody};
use hyper::body::{Frame, SizeHint};
use tokio::sync::{Notify, oneshot};
use tokio::time::timeout_at;

/// Connections at once.
const MOST: usize = 512;
/// Slots of these that strangers may have.
const STRANGERS: usize = 384;
/// Time that a stranger is heard before another one may have its slot. At most 1024 wait to be accepted, so that the last of them waits for three times as
/// long.
pub(crate) const HEARING: Duration = Duration::from_millis(250);

/// The slots of a service.
#[derive(Debug, Clone, Default)]
pub(crate) struct ConnectionSlots(Arc<Shared>);

#[derive(Debug, Default)]
struct Shared {
    taken: Mutex<Taken>,
    /// Told when a slot, or one of those who belong, may have become free.
    changed: Notify,
}

/// The connections in the order of their arrival.
#[derive(Debug, Default)]
struct Taken {
    arrived: u64,
    connections: BTreeMap<u64, Connection>,
}

#[derive(Debug)]
struct Connection {
    since: Instant,
    belongs: bool,
    /// Time since which it has had no request in flight; `None` while it has one.
    idle: Option<Instant>,
    /// Sender whose end asks the connection to leave.
    _stay: oneshot::Sender<()>,
}

impl Taken {
    /// Makes room for a newcomer, or says when to look again; `None` where only a change can help.
    fn make_room(&mut self, now: Instant) -> Result<(), Option<Instant>> {
        let mut strangers = self.connections.iter().filter(|(_, each)| !each.belongs);
        let oldest = strangers.next().map(|(id, each)| (*id, each.since));
        let full = self.connections.len() >= MOST;
        if !full && strangers.count() + 1 < STRANGERS {
            return Ok(());
        }
        let heard = oldest.filter(|(_, since)| now.duration_since(*since) >= HEARING);
        let idle = || {
            let belonging = self.connections.iter().filter(|(_, each)| each.belongs);
            let idle = belonging.filter_map(|(id, each)| Some((each.idle?, *id)));
            idle.min().map(|(_, id)| id).filter(|_| full)
        };
        match heard.map(|(id, _)| id).or_else(idle) {
            Some(leaving) => {
                self.connections.remove(&leaving);
                Ok(())
            }
            None => Err(oldest.map(|(_, since)| since + HEARING)),
        }
    }
}

impl ConnectionSlots {
    /// A slot for a newcomer, as soon as there is one.
    pub async fn take(&self) -> Slot {
        loop {
            let changed = self.0.changed.notified();
            match self.try_take(Instant::now()) {
                Ok(slot) => return slot,
                Err(Some(until)) => {
                    // Either way there may be one now.
                    let _ = timeout_at(until.into(), changed).await;
                }
                Err(None) => changed.await,
            }
        }
    }

    fn try_take(&self, now: Instant) -> Result<Slot, Option<Instant>> {
        let mut taken = self.0.taken();
        taken.make_room(now)?;
        let (stay, leave) = oneshot::channel();
        let id = taken.arrived;
        taken.arrived += 1;
        let connection = Connection {
            since: now,
            belongs: false,
            idle: Some(now),
            _stay: stay,
        };
        taken.connections.insert(id, connection);
        let standing = Standing {
            id,
            slots: self.0.clone(),
        };
        Ok(Slot { standing, leave })
    }
}

impl Shared {
    fn taken(&self) -> MutexGuard<'_, Taken> {
        self.taken.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A connection's slot, free again when it is dropped.
#[derive(Debug)]
pub struct Slot {
    standing: Standing,
    leave: oneshot::Receiver<()>,
}

impl Slot {
    /// Returns what requests of this connection change.
    pub fn standing(&self) -> Standing {
        self.standing.clone()
    }

    /// Waits until somebody else is to have this slot.
    pub(crate) async fn asked_to_leave(&mut self) {
        // Nothing is ever sent.
        let _ = (&mut self.leave).await;
    }
}

impl Drop for Slot {
    fn drop(&mut self) {
        let Standing { id, slots } = &self.standing;
        slots.taken().connections.remove(id);
        slots.changed.notify_one();
    }
}

/// Standing of a connection. Its requests carry it.
#[derive(Debug, Clone)]
pub struct Standing {
    id: u64,
    slots: Arc<Shared>,
}

impl Standing {
    /// A request of this connection was let in.
    pub(crate) fn belongs(&self) {
        self.change(|connection| connection.belongs = true);
    }

    /// A request of this connection is in flight until the end of what is returned.
    pub fn busy(&self) -> Busy {
        self.change(|connection| connection.idle = None);
        Busy(self.clone())
    }

    fn change(&self, change: impl FnOnce(&mut Connection)) {
        // One that was asked to leave isn't there any more.
        if let Some(connection) = self.slots.taken().connections.get_mut(&self.id) {
            change(connection);
        }
    }
}

/// A request in flight.
#[derive(Debug)]
pub struct Busy(Standing);

impl Drop for Busy {
    fn drop(&mut self) {
        self.0
            .change(|connection| connection.idle = Some(Instant::now()));
        self.0.slots.changed.notify_one();
    }
}

/// The body of a request whose connection belongs when all of it has come: anybody can send half of one.
#[derive(Debug)]
pub(crate) struct AskedWhole {
    body: Body,
    standing: Standing,
}

impl AskedWhole {
    /// Wraps the body, if there is one.
    pub(crate) fn of(body: Body, standing: Standing) -> Body {
        if body.is_end_stream() {
            standing.belongs();
            return body;
        }
        Body::new(Self { body, standing })
    }
}

impl HttpBody for AskedWhole {
    type Data = Bytes;
    type Error = axum::Error;

    fn poll_frame(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
    ) -> Poll<Option<Result<Frame<Bytes>, axum::Error>>> {
        let frame = Pin::new(&mut self.body).poll_frame(context);
        if self.body.is_end_stream() || matches!(frame, Poll::Ready(None)) {
            self.standing.belongs();
        }
        frame
    }

    fn is_end_stream(&self) -> bool {
        self.body.is_end_stream()
    }

    fn size_hint(&self) -> SizeHint {
        self.body.size_hint()
    }
}

/// An answer whose request is in flight until it is sent.
#[derive(Debug)]
pub struct Answer {
    body: Body,
    _busy: Busy,
}

impl Answer {
    /// Wraps the answer.
    pub fn of(body: Body, busy: Busy) -> Self {
        Self { body, _busy: busy }
    }
}

impl HttpBody for Answer {
    type Data = Bytes;
    type Error = axum::Error;

    fn poll_frame(
        mut self: Pin<&mut Self>,
        context: &mut Context<'_>,
    ) -> Poll<Option<Result<Frame<Bytes>, axum::Error>>> {
        Pin::new(&mut self.body).poll_frame(context)
    }

    fn is_end_stream(&self) -> bool {
        self.body.is_end_stream()
    }

    fn size_hint(&self) -> SizeHint {
        self.body.size_hint()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Takes so many slots at a moment.
    fn taken(slots: &ConnectionSlots, count: usize, now: Instant) -> Vec<Slot> {
        let take = |_| slots.try_take(now).expect("a slot");
        (0..count).map(take).collect()
    }

    fn left(slots: &mut [Slot]) -> Vec<usize> {
        let asked =
            |slot: &mut Slot| slot.leave.try_recv() != Err(oneshot::error::TryRecvError::Empty);
        let each = slots.iter_mut().enumerate();
        each.filter_map(|(index, slot)| asked(slot).then_some(index))
            .collect()
    }

    #[test]
    fn a_newcomer_has_the_place_of_the_stranger_that_was_heard_longest() {
        let (slots, now) = (ConnectionSlots::default(), Instant::now());
        let mut strangers = taken(&slots, STRANGERS, now);
        let early = slots
            .try_take(now + HEARING / 2)
            .expect_err("none was heard");
        assert_eq!(early, Some(now + HEARING));
        // A request in flight keeps no stranger's slot: it may never end.
        let _busy = strangers[0].standing().busy();
        let _newcomer = slots.try_take(now + HEARING).expect("a slot");
        assert_eq!(left(&mut strangers), [0]);
        strangers[1].standing().belongs();
        let _next = slots.try_take(now + HEARING).expect("a slot");
        assert_eq!(
            left(&mut strangers),
            [0],
            "there was room for a stranger again"
        );
    }

    #[test]
    fn who_belongs_leaves_when_all_places_are_taken_and_the_one_idle_longest_first() {
        let (slots, now) = (ConnectionSlots::default(), Instant::now());
        let mut belonging = Vec::new();
        for _ in 0..MOST {
            let slot = slots.try_take(now).expect("a slot");
            slot.standing().belongs();
            belonging.push(slot);
        }
        let busy: Vec<Busy> = belonging
            .iter()
            .map(|each| each.standing().busy())
            .collect();
        assert_eq!(
            slots.try_take(now + HEARING).err(),
            Some(None),
            "all are busy"
        );
        let mut busy = busy.into_iter();
        let (first, second) = (busy.next(), busy.next());
        drop(second);
        drop(first);
        let _newcomer = slots.try_take(Instant::now()).expect("a slot");
        assert_eq!(left(&mut belonging), [1]);
        drop(belonging.pop());
        assert!(
            slots.try_take(Instant::now()).is_ok(),
            "one has left by itself"
        );
    }

    #[test]
    fn strangers_leave_places_to_those_who_belong() {
        let (slots, now) = (ConnectionSlots::default(), Instant::now());
        let mut strangers = taken(&slots, STRANGERS - 1, now);
        let mut belonging = Vec::new();
        for round in 1..=u32::try_from(MOST - STRANGERS).expect("fits") {
            let slot = slots.try_take(now + HEARING * round).expect("a slot");
            slot.standing().belongs();
            belonging.push(slot);
        }
        assert!(left(&mut strangers).is_empty());
        assert!(left(&mut belonging).is_empty());
    }
}
