"""What the service answers, as typed objects; no file here sends a request.

Strains are plain numbers; names carry the units of all else.
"""
