-- Sweeps: a study and its designs, each a study of its own. Where a sweep stands is read off its designs.
create table sweeps (
    id          text primary key not null,
    name        text not null,
    spec        text not null,                  -- canonical document of the study without changes, JSON
    spec_sha256 text not null,                  -- of that document
    priority    integer not null check (priority between -100 and 100),
    created     text not null
) strict;

create table sweep_designs (
    sweep    text not null references sweeps (id),
    ordinal  integer not null,
    name     text not null,
    settings text not null,                     -- values by path, JSON
    study    text not null references studies (id),
    primary key (sweep, ordinal)
) strict, without rowid;

create index sweep_designs_by_study on sweep_designs (study);

-- As idempotency_keys, of sweeps.
create table sweep_keys (
    key     text primary key not null,
    sweep   text not null references sweeps (id),
    sha256  text not null,                      -- of what was submitted
    created text not null
) strict, without rowid;
