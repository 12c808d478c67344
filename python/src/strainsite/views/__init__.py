"""Pandas frames, figures and what notebooks show, made of plain values: nothing here knows an answer."""
