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


def posted(port, path, kind, body, patience_s=2):
    """The answer to a document."""
    head = f"POST {path} HTTP/1.1\r\nHOST\r\nContent-Type: {kind}\r\nContent-Length: {len(body)}\r\nConnection: close\r\n\r\n"
    return ask(port, head.encode() + body.encode(), patience_s).decode()


def unread(port, request):
    """A client that has asked and doesn't read."""
    client = socket.socket()
    client.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    client.settimeout(60)
    client.connect(("127.0.0.1", port))
    client.sendall(request.replace(b"HOST", b"Host: 127.0.0.1:%d" % port))
    client.setblocking(False)
    return client


def answered(client):
    """The status of its answer, which it goes on not reading; none as long as there is no answer."""
    with contextlib.suppress(BlockingIOError):
        return int(client.recv(12, socket.MSG_PEEK)[9:] or 0)
    return None


def resident_mb(process):
    """Memory that a process holds now."""
    with open(f"/proc/{process}/status") as status:
        return next(int(line.split()[1]) for line in status if line.startswith("VmRSS:")) / 1024
