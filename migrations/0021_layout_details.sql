-- Layouts by simulation, at several loads, also film by film: all of that as JSON; null in rows of earlier versions. The column rank is the row's place then.
alter table layouts add column details text;
