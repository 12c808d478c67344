-- Ranked rows are what is served of them, errors included. Those of earlier results are written anew from their documents when the database is opened.
drop table locations;
drop table layouts;

-- Results whose ranked rows are all there.
create table rankings (
    study       text primary key not null references results (study),
    rows_sha256 text not null               -- of its rows in the three tables below
) strict;

-- Ranked locations, one row per candidate.
create table locations (
    study        text not null references results (study),
    rank         integer not null,          -- 1 is best
    name         text not null,
    input        text,                      -- the location's own
    rank_x       integer,                   -- by one strain alone
    rank_y       integer,
    rank_certain integer not null check (rank_certain in (0, 1)),
    primary key (study, rank)
) strict, without rowid;

-- What a location is judged by, one row per score and direction, in the score's unit.
create table location_scores (
    study     text not null,
    rank      integer not null,
    score     text not null,                -- gsi, mean_gsi, ...
    direction text not null check (direction in ('x', 'y')),
    value     real,
    error     real,
    primary key (study, rank, score, direction),
    foreign key (study, rank) references locations (study, rank)
) strict, without rowid;

-- Ranked layouts.
create table layouts (
    study                 text not null references results (study),
    rank                  integer not null, -- 1 is best
    spacing_deg           real not null,
    units                 integer not null,
    position              text not null,
    films                 text not null,    -- JSON array
    weakest_signal        real,             -- strain
    worst_angle_error_deg real,
    rms_angle_error_deg   real,
    worst_depth_error_mm  real,
    noise_strain          real not null,
    reason                text,             -- why numbers are null
    primary key (study, rank)
) strict, without rowid;
