-- Solved points, kept by content: one row per scene, readout, start rule and solver version, written once.
create table evaluations (
    key      text primary key not null,
    scene    text not null,                     -- canonical scene, JSON
    response text not null,                     -- strains, forces, diagnostics, JSON
    cost     text not null,                     -- what the solve took, JSON
    sha256   text not null,                     -- of key, scene, response and cost
    created  text not null
) strict;

-- Equilibria from which other points start.
create table start_states (
    key    text primary key not null references evaluations (key),
    state  blob not null,
    sha256 text not null                        -- of key and state
) strict;

-- Which evaluation answers for which point of a study's plan.
create table study_points (
    study      text not null references studies (id),
    ordinal    integer not null,
    evaluation text not null references evaluations (key),
    primary key (study, ordinal)
) strict, without rowid;
