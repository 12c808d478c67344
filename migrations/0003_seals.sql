-- Seals: a hash of what a row says together with its key and its owner. Null until the transaction that wrote the row ends.
alter table studies add column seal text;
alter table events add column seal text;
alter table idempotency_keys add column seal text;
alter table crashes add column seal text;
alter table results add column seal text;
alter table trades add column seal text;
alter table sweeps add column seal text;
alter table sweep_designs add column seal text;
alter table sweep_keys add column seal text;
alter table estimators add column seal text;
alter table estimator_recordings add column seal text;
alter table estimator_parts add column seal text;
alter table estimator_keys add column seal text;

-- Those that are to be sealed are few, and found at once.
create index studies_unsealed on studies (id) where seal is null;
create index events_unsealed on events (id) where seal is null;
create index idempotency_keys_unsealed on idempotency_keys (key) where seal is null;
create index crashes_unsealed on crashes (key) where seal is null;
create index results_unsealed on results (study) where seal is null;
create index trades_unsealed on trades (id) where seal is null;
create index sweeps_unsealed on sweeps (id) where seal is null;
create index sweep_designs_unsealed on sweep_designs (sweep) where seal is null;
create index sweep_keys_unsealed on sweep_keys (key) where seal is null;
create index estimators_unsealed on estimators (id) where seal is null;
create index estimator_recordings_unsealed on estimator_recordings (estimator) where seal is null;
create index estimator_parts_unsealed on estimator_parts (estimator) where seal is null;
create index estimator_keys_unsealed on estimator_keys (key) where seal is null;

-- Of what changes while somebody works on it: name, state, counts, times.
alter table studies add column state_seal text;
create index studies_state_unsealed on studies (id) where state_seal is null;
alter table sweeps add column state_seal text;
create index sweeps_state_unsealed on sweeps (id) where state_seal is null;
alter table estimators add column state_seal text;
create index estimators_state_unsealed on estimators (id) where state_seal is null;

-- The event of the same study before this one: a gap shows.
alter table events add column previous integer;
update events set previous = (select max(id) from events as earlier where earlier.study = events.study and earlier.id < events.id);

-- Designs that a sweep has.
alter table sweeps add column designs integer not null default 0;
update sweeps set designs = (select count(*) from sweep_designs where sweep = sweeps.id);
