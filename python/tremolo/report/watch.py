"""`tremolo watch`: the report of a run, served on this machine while the run goes on.

A thread makes the report anew whenever run.h5 has grown, and takes at most a third of a core for it. Every address holds a token
that nobody else knows, so that other users of the machine can neither read the run nor abort it. A request must name this machine
as its host, so that no page from elsewhere reaches the run under a name of its own.
"""

import concurrent.futures
import hmac
import html
import http.server
import json
import os
import re
import secrets
import signal
import socket
import sys
import threading
import time
import urllib.parse
from pathlib import Path

from tremolo.report import page as report_page
from tremolo.run import Run

EVERY = 2.0  # s between two looks at the run
PATIENCE = 10.0  # s that a browser may take to ask, and to take the answer
THIS_MACHINE = re.compile(r"(127\.0\.0\.1|localhost)(:\d{1,5})?", re.IGNORECASE)  # of any port: that of a tunnel may be another
WORKERS = 16  # requests that are answered at a time; as many connections may be open that have not asked yet
WAITING = """<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><meta http-equiv="refresh" content="2">
<link rel="icon" href="data:,"><title>tremolo watch</title></head><body><h1>{}</h1><p id="told">{}</p></body></html>"""


def launcher(folder):
    """Process id of the `tremolo run` that writes into a folder, None where there is none: it has locked the folder."""
    status = os.stat(folder)
    place = f"{os.major(status.st_dev):02x}:{os.minor(status.st_dev):02x}:{status.st_ino}"
    for line in Path("/proc/locks").read_text().splitlines():
        words = line.split()
        if words[1] == "FLOCK" and words[5] == place and _is_tremolo(words[4]):
            return int(words[4])
    return None


def _is_tremolo(process):
    try:
        return Path(f"/proc/{process}/comm").read_text().strip() == "tremolo"
    except OSError:
        return False


def _owner(path):
    """The name of a file's owner, or its number where this machine knows no name."""
    try:
        return Path(path).owner()
    except KeyError:
        return f"user {os.stat(path).st_uid}"


class Watch:
    """What is known of a run, and its report as of the last look."""

    def __init__(self, path):
        path = Path(path)
        self.folder = path.parent if path.name == "run.h5" else path
        if not self.folder.is_dir():
            raise FileNotFoundError(f"{self.folder}: no such folder; start the run first")
        for needed in (self.folder, self.folder / "run.h5"):
            if needed.exists() and not os.access(needed, os.R_OK):
                raise PermissionError(f"{needed}: no permission to read it; it belongs to {_owner(needed)}")
        self.token = secrets.token_urlsafe(24)
        self.page = self.content = None
        self.state = {"version": 0, "share": 0.0, "words": "The run has written no frame yet.", "ended": False}
        self._seen = None

    def look(self):
        """Makes the report anew if the run has written more. A file that is just being written is looked at again later."""
        try:
            status = (self.folder / "run.h5").stat()
            if (status.st_size, status.st_mtime_ns) == self._seen:
                return
            report = report_page.Report([self.folder])
            version = self.state["version"] + 1
            state = self._told(report.runs[0], version)
            live = None if state["ended"] else {"token": self.token, "version": version, "every_s": EVERY}
            # All of them at once: a page never holds more than its version says.
            self.page, self.content, self.state = report.html(live), report.content, state
            self._seen = (status.st_size, status.st_mtime_ns)
            report.runs[0].close()
        except (OSError, ValueError, LookupError) as error:
            self.state = {**self.state, "words": f"not read yet: {error}"}

    def _told(self, run, version):
        plan = run.plan
        end = plan["steps"] * plan["dt_s"] if plan else run.times[-1]
        energy = run.energy
        now = float(energy["time"][-1]) if energy is not None and len(energy) else float(run.times[-1])
        ended = run.status != "running"
        words = f"simulated {now:.2f} of {end:.2f} s, {len(run.times)} frames; {run.status}"
        if not ended and launcher(self.folder) is None:
            words += ", but no `tremolo run` on this machine writes into this folder"
        return {"version": version, "share": min(now / end, 1.0) if end > 0.0 else 1.0, "words": words, "ended": ended}

    def follow(self):
        """Looks until the run has ended."""
        while not self.state["ended"]:
            began = time.monotonic()
            self.look()
            time.sleep(max(EVERY, 2.0 * (time.monotonic() - began)))

    def abort(self):
        """Ends the run as Ctrl-C does, and says what came of it."""
        process = launcher(self.folder)
        if process is None:
            return "no `tremolo run` on this machine writes into this folder"
        try:
            os.kill(process, signal.SIGINT)
        except PermissionError:
            return f"the run belongs to {_owner(f'/proc/{process}')}, who alone can end it"
        except ProcessLookupError:
            return "the run has ended by itself"
        return "the run has been asked to end"


class Server(http.server.HTTPServer):
    """One thread takes connections, at most WORKERS others answer them.

    Of the connections that have not sent a whole request, the oldest is closed when there are more than WORKERS: connections that
    nobody uses keep no browser waiting.
    """

    request_queue_size = 64

    def __init__(self, watch, port):
        self._workers = concurrent.futures.ThreadPoolExecutor(WORKERS)
        self._lock = threading.Lock()
        self._silent = {}  # connections that have not asked yet, the oldest first
        super().__init__(("127.0.0.1", port), _handler(watch))

    def process_request(self, request, client_address):
        with self._lock:
            self._silent[request] = None
            oldest = next(iter(self._silent)) if len(self._silent) > WORKERS else None
            self._silent.pop(oldest, None)
        if oldest:
            _hang_up(oldest)
        self._workers.submit(self._answer, request, client_address)

    def has_asked(self, connection):
        with self._lock:
            self._silent.pop(connection, None)

    def _answer(self, request, client_address):
        try:
            self.finish_request(request, client_address)
        except Exception:
            self.handle_error(request, client_address)
        finally:
            self.has_asked(request)
            self.shutdown_request(request)

    def handle_error(self, request, client_address):
        """A browser may leave at any time, which is an OSError."""
        error = sys.exc_info()[1]
        if not isinstance(error, OSError):
            print(f"tremolo: a request could not be answered: {type(error).__name__}: {error}", file=sys.stderr)

    def server_close(self):
        super().server_close()
        with self._lock:
            silent = list(self._silent)
        for connection in silent:
            _hang_up(connection)
        self._workers.shutdown(wait=False, cancel_futures=True)


def _hang_up(connection):
    """Wakes the thread that reads from a connection, which then closes it."""
    try:
        connection.shutdown(socket.SHUT_RDWR)
    except OSError:  # gone already
        pass


def _handler(watch):
    class Handler(http.server.BaseHTTPRequestHandler):
        timeout = PATIENCE

        def parse_request(self):
            parsed = super().parse_request()
            self.server.has_asked(self.connection)
            return parsed

        def do_GET(self):
            if not self._allowed():
                return
            what = self._address().path
            if what == "/":
                self._answer("text/html", watch.page or WAITING.format(*map(html.escape, (watch.folder.name, watch.state["words"]))))
            elif what == "/state":
                self._answer("application/json", json.dumps(watch.state))
            elif what == "/content" and watch.content:
                self._answer("application/json", watch.content)
            else:
                self._answer("text/plain", "not found", 404)

        def do_POST(self):
            if not self._allowed():
                return
            if self._address().path == "/abort":
                self._answer("text/plain", watch.abort())
            else:
                self._answer("text/plain", "not found", 404)

        def _address(self):
            """What is asked for; None where it is no address."""
            try:
                return urllib.parse.urlsplit(self.path)
            except ValueError:
                return None

        def _allowed(self):
            hosts = self.headers.get_all("Host", [])
            if len(hosts) != 1 or not THIS_MACHINE.fullmatch(hosts[0].strip()):
                self._answer("text/plain", "the request must name 127.0.0.1 or localhost as its host", 403)
                return False
            if self._address() is None:
                self._answer("text/plain", "the request asks for no address that can be read", 400)
                return False
            given = urllib.parse.parse_qs(self._address().query).get("token", [""])[0]
            if hmac.compare_digest(given.encode(), watch.token.encode()):
                return True
            self._answer("text/plain", "the address lacks the token that `tremolo watch` printed", 403)
            return False

        def _answer(self, kind, text, status=200):
            body = text.encode("utf-8")
            self.send_response(status)
            self.send_header("Content-Type", kind + "; charset=utf-8")
            self.send_header("Content-Length", str(len(body)))
            for name, value in (("Cache-Control", "no-store"), ("X-Content-Type-Options", "nosniff"), ("Referrer-Policy", "no-referrer")):
                self.send_header(name, value)
            self.end_headers()
            self.wfile.write(body)

        def log_message(self, *_):
            pass

    return Handler


def _server(watch, port):
    try:
        return Server(watch, port)
    except OSError as error:
        raise OSError(f"port {port} of 127.0.0.1: {error.strerror}") from error


def serve(path, port=0):
    """Serves the report of a run on the loopback address until Ctrl-C. Yields the address, and then that the run has ended.

    path: folder of the run, or its run.h5; port: 0 takes a free one.
    Raises OSError where there is no such folder or the port is taken, ValueError where Jinja2 or Plotly is missing.
    """
    report_page.require_libraries()
    watch = Watch(path)
    with _server(watch, port) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_address[1]}/?token={watch.token}"
        watch.follow()
        yield f"the run has ended ({Run(watch.folder).status}); the page stays until Ctrl-C"
        threading.Event().wait()
