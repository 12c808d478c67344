-- Estimators of forces: what was asked, the recordings that each is learnt from, and what was learnt.
create table estimators (
    id              text primary key not null,
    name            text not null,
    document        text not null,                -- recipe, forces, figures of the recordings, JSON
    document_sha256 text not null,                -- of that document
    state           text not null check (state in ('queued', 'running', 'done', 'failed', 'cancelled')),
    error           text,
    created         text not null,
    started         text,
    finished        text
) strict;

create index estimators_by_state on estimators (state, id);

create table estimator_recordings (
    estimator text not null references estimators (id),
    ordinal   integer not null,
    file      text not null,
    text      text not null,                      -- CSV, as it was sent
    sha256    text not null,                      -- of file and text
    primary key (estimator, ordinal)
) strict;

create table estimator_parts (
    estimator text not null references estimators (id),
    part      text not null check (part in ('report', 'model', 'left-out')),
    document  text not null,                      -- JSON
    sha256    text not null,                      -- of that document
    primary key (estimator, part)
) strict;

-- As idempotency_keys, of estimators.
create table estimator_keys (
    key       text primary key not null,
    estimator text not null references estimators (id),
    sha256    text not null,                      -- of what was submitted
    created   text not null
) strict, without rowid;
