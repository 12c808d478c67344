-- Keys under which clients submitted studies, so that a repeated request finds the same study.
create table idempotency_keys (
    key         text primary key not null,
    study       text not null references studies (id),
    spec_sha256 text not null,                  -- the same key with another document is refused
    created     text not null
) strict, without rowid;
