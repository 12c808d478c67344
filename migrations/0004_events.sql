-- What happened to a study, in order; replayed to clients that come back.
create table events (
    id      integer primary key autoincrement,
    study   text not null references studies (id),
    kind    text not null,
    payload text not null,                      -- JSON object
    created text not null
) strict;

create index events_by_study on events (study, id);
