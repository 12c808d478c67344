-- Tells a database of strainsite from other SQLite files: "stra" in ASCII.
pragma application_id = 1937011297;
