"""Reaching the service: requests with retries, event streams, waiting, downloads. Knows no answer's fields."""
