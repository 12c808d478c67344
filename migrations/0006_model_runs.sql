-- Runs of models that other programs serve, which `gsa run` asks for: a row each, written once, before it counts. A run that failed may be replaced by one that didn't.
create table model_runs (
    key     text primary key not null,          -- of the model's URL, name and config, and the values of its inputs by their bits
    model   text not null,                      -- URL and name, for people
    outputs text,                               -- every number of the answer in order, JSON; null where the run failed
    failure text,                               -- why it failed, a sentence
    sha256  text not null,                      -- of all other columns
    created text not null,
    check ((outputs is null) <> (failure is null))
) strict;
