-- The strains over map and rings of a point: nine tenths of its response, read only where a study is analysed. Kept as numbers rather than text, so
-- that reading them back costs next to nothing. Responses stored before have theirs inside.
create table strain_fields (
    key    text primary key not null references evaluations (key),
    lists  blob not null,                       -- each list of the response in order: its length (u64), its values (f64), little endian
    sha256 text not null                        -- of key and lists
) strict;
