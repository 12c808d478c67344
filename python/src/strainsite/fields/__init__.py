"""Fields over the wheel, from what a study has stored."""
