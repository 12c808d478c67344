-- The tables of strainsite 0.2. Times are RFC 3339, UTC; hashes are SHA-256 in lower-case hexadecimal.

-- Tells a database of strainsite from other SQLite files: "stra" in ASCII.
pragma application_id = 1937011297;

-- Studies: what was asked, and how far it got.
create table studies (
    id           text primary key not null,
    name         text not null,                 -- may be another than its document's
    spec         text not null,                 -- canonical document, JSON
    spec_sha256  text not null,                 -- of the canonical document
    state        text not null check (state in ('queued', 'running', 'done', 'failed', 'cancelled')),
    priority     integer not null default 0 check (priority between -100 and 100),
    place        integer not null default 0,    -- in the ring of turns: the foremost of the highest priority is next, and goes to the end after its turn
    points_total integer,                       -- null until the plan is known
    points_done  integer not null default 0,
    estimate     text,                          -- what it was expected to take when it last started, JSON
    error        text,                          -- why it failed, a sentence
    created      text not null,
    started      text,                          -- of the first start
    finished     text,
    archived     text                           -- when lists began to leave it out; null in those that they show
) strict;

-- Identifiers are ordered by time.
create index studies_by_state on studies (state, id);
create index studies_by_spec on studies (spec_sha256, id);
create index studies_by_turn on studies (state, priority desc, place);
create index studies_by_place on studies (place);

-- What happened to a study, in order; replayed to clients that come back.
create table events (
    id      integer primary key autoincrement,
    study   text not null references studies (id),
    kind    text not null,
    payload text not null,                      -- JSON object
    created text not null
) strict;

create index events_by_study on events (study, id);

-- Keys under which clients submitted studies, so that a repeated request finds the same study.
create table idempotency_keys (
    key         text primary key not null,
    study       text not null references studies (id),
    spec_sha256 text not null,                  -- the same key with another document is refused
    created     text not null
) strict, without rowid;

create index idempotency_keys_by_study on idempotency_keys (study);

-- Solved points, kept by content: one row per scene, readout, start rule and solver version, written once.
create table evaluations (
    key      text primary key not null,
    scene    text not null,                     -- canonical scene, JSON
    response text not null,                     -- strains, forces, diagnostics, JSON; the JSON null beside a failure
    failure  text,                              -- that a load has no equilibrium: kind, where it ended, loads reached, JSON
    cost     text not null,                     -- what the solve took, JSON
    sha256   text not null,                     -- of key, scene, response, cost and failure
    created  text not null
) strict;

-- The strains over map and rings of a point: nine tenths of its response, read only where a study is analysed. Kept as numbers rather than text, so
-- that reading them back costs next to nothing.
create table strain_fields (
    key    text primary key not null references evaluations (key),
    lists  blob not null,                       -- each list of the response in order: its length (u64), its values (f64), little endian
    sha256 text not null                        -- of key and lists
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
    sha256     text not null,                   -- of study, ordinal and evaluation
    primary key (study, ordinal)
) strict, without rowid;

create index study_points_by_evaluation on study_points (evaluation);

-- Solves that have begun and not ended: what is here at a start was being solved when the program died.
create table solves_in_flight (
    key     text primary key not null,          -- content key of the point
    started text not null
) strict;

-- A point that was in flight when the program died is suspect: the count of that blames nobody, because a kill from outside looks the same. It is solved
-- alone in a process of its own then, whose crashes are counted apart.
create table crashes (
    key   text primary key not null,
    count integer not null check (count > 0),
    own   integer not null default 0 check (own >= 0),
    cause text                                  -- what ended that process the last time
) strict;

-- Results, recomputable from evaluations and document; kept so that they needn't be.
create table results (
    study           text primary key not null references studies (id),
    document        text not null,              -- the result, JSON, with null in the place of its map
    map_place       integer,                    -- byte of the document where its map stood; null where it has none
    map_sha256      text,                       -- of study and map
    document_sha256 text not null,              -- of study, document, and the map's place and hash
    content_sha256  text not null,              -- without cost and study identifier: equal for equal studies
    created         text not null
) strict;

-- The maps of results: most of their bytes, which nothing else has to read.
create table result_maps (
    study    text primary key not null references results (study),
    document text not null                      -- the map, JSON
) strict;

-- What results rank, and films' signals, as rows; `place` counts from 1, and whatever has no column is in the JSON.

create view locations as
select study, key + 1 as place, value ->> 'rank' as rank, value ->> 'name' as name, value ->> 'input' as input,
    value ->> 'rank_x' as rank_x, value ->> 'rank_y' as rank_y, value ->> 'rank_certain' as rank_certain, value as document
from results, json_each(results.document, '$.locations');

-- Each figure that a location is judged by, under its name in documents.
create view location_scores as
select study, place, score.key as score, score.value as value
from locations, json_each(locations.document) as score
where score.key not in ('name', 'input', 'rank', 'rank_x', 'rank_y', 'rank_certain');

create view layouts as
select study, key + 1 as place, value ->> 'rank' as rank, value ->> 'name' as name, value ->> 'spacing_deg' as spacing_deg,
    value ->> 'units' as units, value ->> 'position' as position, value -> 'films' as films, value -> 'score' as score, value as document
from results, json_each(results.document, '$.layouts');

create view signals as
select study, key + 1 as place, value ->> 'tire' as tire, value ->> 'film' as film, value ->> 'position' as position,
    value ->> 'direction' as direction, value ->> 'over' as over, value ->> 'load_n' as load_n, value ->> 'pressure_mpa' as pressure_mpa,
    value ->> 'contact_deg' as contact_deg, value as document
from results, json_each(results.document, '$.signals.rows');

-- Measured trades of accuracy for time; the newest of a study's document counts.
create table trades (
    id              integer primary key autoincrement,
    spec_sha256     text not null,              -- of the study's canonical document
    document        text not null,              -- the trade, JSON
    document_sha256 text not null,              -- of the text as stored
    created         text not null
) strict;

create index trades_by_study on trades (spec_sha256, id);

-- Sweeps: a study and its designs, each a study of its own. Where a sweep stands is read off its designs.
create table sweeps (
    id          text primary key not null,
    name        text not null,
    spec        text not null,                  -- canonical document of the study without changes, JSON
    spec_sha256 text not null,                  -- of that document
    priority    integer not null check (priority between -100 and 100),
    created     text not null,
    archived    text                            -- as of studies
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

create index sweep_keys_by_sweep on sweep_keys (sweep);

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
