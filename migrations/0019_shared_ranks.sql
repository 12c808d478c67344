-- Equal locations share a rank: that of the first of them. `rank` stays the place of the row.
alter table locations add column shared_rank integer;   -- null where it is the row's place
