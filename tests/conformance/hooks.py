"""What schemathesis can't know by itself: how a body of type application/toml is sent."""

import json

import schemathesis


@schemathesis.serializer("application/toml")
def toml(context, value):
    """The description says that it is a text. What isn't one is sent all the same, to be refused."""
    if isinstance(value, bytes):
        return value
    return (value if isinstance(value, str) else json.dumps(value)).encode("utf-8")
