"""What the service answers, as typed objects. No file here sends a request."""
