-- The queue as a ring: the foremost of those with the highest priority gets the next turn, and goes to the end after it.
alter table studies add column priority integer not null default 0 check (priority between -100 and 100);
alter table studies add column place integer not null default 0;
update studies set place = 1 + (select count(*) from studies as older where older.id < studies.id);

create index studies_by_turn on studies (state, priority desc, place);
create index studies_by_place on studies (place);
