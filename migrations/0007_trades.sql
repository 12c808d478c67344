-- Measured trades of accuracy for time; the newest of a study's document counts.
create table trades (
    id              integer primary key autoincrement,
    spec_sha256     text not null,              -- of the study's canonical document
    document        text not null,              -- the trade, JSON
    document_sha256 text not null,              -- of the text as stored
    created         text not null
) strict;

create index trades_by_study on trades (spec_sha256, id);
