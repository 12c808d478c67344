"""Answers as pandas frames, figures and what notebooks show."""
