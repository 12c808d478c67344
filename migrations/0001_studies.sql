-- Studies: what was asked, and how far it got. Times are RFC 3339, UTC.
create table studies (
    id           text primary key not null,
    name         text not null,
    spec         text not null,                 -- canonical document, JSON
    spec_sha256  text not null,                 -- of the canonical document
    state        text not null check (state in ('queued', 'running', 'done', 'failed', 'cancelled')),
    points_total integer,                       -- null until the plan is known
    points_done  integer not null default 0,
    error        text,                          -- why it failed, a sentence
    created      text not null,
    started      text,                          -- of the first start
    finished     text
) strict;

-- The queue takes the oldest queued study; identifiers are ordered by time.
create index studies_by_state on studies (state, id);
create index studies_by_spec on studies (spec_sha256, id);
