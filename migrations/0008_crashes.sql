-- Solves that have begun and not ended: what is here at a start was being solved when the program died.
create table solves_in_flight (
    key     text primary key not null,          -- content key of the point
    started text not null
) strict;

-- How often the program died while a point was being solved.
create table crashes (
    key   text primary key not null,
    count integer not null check (count > 0)
) strict;
