"""The service on a free port, and bytes sent to it as they are."""

import contextlib
import socket
import subprocess


@contextlib.contextmanager
def served(attacks, *arguments, stderr=subprocess.DEVNULL):
    """Port of a service that ends with the block, none where it didn't start, and the lines that it printed."""
    service = attacks.start("serve", "--addr", "127.0.0.1:0", *arguments,
                            stdout=subprocess.PIPE, stderr=stderr, text=True)
    try:
        port = service.stdout.readline().rpartition(":")[2].strip()
        yield int(port) if port else None, service.stdout
    finally:
        service.terminate()
        try:
            service.wait(10)
        except subprocess.TimeoutExpired:
            # It is an attack of its own whether it heeds that.
            service.kill()
            service.wait()


def ask(port, request, patience_s=2):
    """All that the service answers until it closes the connection, or says nothing more for a while."""
    answer = b""
    with socket.create_connection(("127.0.0.1", port), timeout=patience_s) as connection:
        with contextlib.suppress(OSError):
            connection.sendall(request.replace(b"HOST", b"Host: 127.0.0.1:%d" % port))
            while piece := connection.recv(1 << 16):
                answer += piece
    return answer


def posted(port, path, kind, body):
    """The answer to a document."""
    head = f"POST {path} HTTP/1.1\r\nHOST\r\nContent-Type: {kind}\r\nContent-Length: {len(body)}\r\nConnection: close\r\n\r\n"
    return ask(port, head.encode() + body.encode()).decode()
