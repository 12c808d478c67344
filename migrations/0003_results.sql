-- Results, recomputable from evaluations and document; kept so that they needn't be.
create table results (
    study           text primary key not null references studies (id),
    document        text not null,              -- the result, JSON
    document_sha256 text not null,              -- of the text as stored
    content_sha256  text not null,              -- without cost and study identifier: equal for equal studies
    created         text not null
) strict;

-- Ranked locations, one row per candidate.
create table locations (
    study              text not null references studies (id),
    name               text not null,
    rank               integer not null,        -- 1 is best
    gsi_x_percent      real,                    -- own depth, x strain at the centre
    gsi_y_percent      real,
    mean_gsi_x_percent real,                    -- own depth, mean over the strains at all locations
    mean_gsi_y_percent real,
    own_gsi_x_percent  real,                    -- own depth, strain at the location itself
    own_gsi_y_percent  real,
    mdrm_gsi_x_percent real,                    -- as M-DRM computes it, valid or not
    mdrm_gsi_y_percent real,
    rank_x             integer,
    rank_y             integer,
    rank_certain       integer not null check (rank_certain in (0, 1)),
    primary key (study, name)
) strict, without rowid;

-- Ranked layouts.
create table layouts (
    study                 text not null references studies (id),
    rank                  integer not null,     -- 1 is best
    spacing_deg           real not null,
    units                 integer not null,
    position              text not null,
    films                 text not null,        -- JSON array
    weakest_signal        real,                 -- strain
    worst_angle_error_deg real,
    rms_angle_error_deg   real,
    worst_depth_error_mm  real,
    noise_strain          real not null,
    reason                text,                 -- why numbers are null
    primary key (study, rank)
) strict, without rowid;
