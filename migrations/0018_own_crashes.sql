-- A point that was in flight when the program died is suspect: the count of that blames nobody, because a kill from outside looks the same. It is solved
-- alone in a process of its own then, whose crashes are counted here.
alter table crashes add column own integer not null default 0 check (own >= 0);
alter table crashes add column cause text;   -- what ended that process the last time
