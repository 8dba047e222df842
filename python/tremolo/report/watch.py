"""`tremolo watch`: the report of a run, served on this machine while the run goes on.

A thread makes the report anew whenever run.h5 has grown, and takes at most a third of a core for it. Every address holds a token
that nobody else knows, so that other users of the machine can neither read the run nor abort it.
"""

import hmac
import html
import http.server
import json
import os
import secrets
import signal
import threading
import time
import urllib.parse
from pathlib import Path

from tremolo.report import page as report_page
from tremolo.run import Run

EVERY = 2.0  # s between two looks at the run
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


class Watch:
    """What is known of a run, and its report as of the last look."""

    def __init__(self, path):
        path = Path(path)
        self.folder = path.parent if path.name == "run.h5" else path
        if not self.folder.is_dir():
            raise FileNotFoundError(f"{self.folder}: no such folder; start the run first")
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
        except (OSError, ValueError, KeyError) as error:
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
        os.kill(process, signal.SIGINT)
        return "the run has been told to end"


def _handler(watch):
    class Handler(http.server.BaseHTTPRequestHandler):
        def do_GET(self):
            if not self._allowed():
                return
            what = urllib.parse.urlsplit(self.path).path
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
            if urllib.parse.urlsplit(self.path).path == "/abort":
                self._answer("text/plain", watch.abort())
            else:
                self._answer("text/plain", "not found", 404)

        def _allowed(self):
            given = urllib.parse.parse_qs(urllib.parse.urlsplit(self.path).query).get("token", [""])[0]
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


def serve(path, port=0):
    """Serves the report of a run on the loopback address until Ctrl-C. Yields the address, and then that the run has ended.

    path: folder of the run, or its run.h5; port: 0 takes a free one.
    Raises OSError where there is no such folder or the port is taken, ValueError where Jinja2 or Plotly is missing.
    """
    report_page.require_libraries()
    watch = Watch(path)
    with http.server.ThreadingHTTPServer(("127.0.0.1", port), _handler(watch)) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_address[1]}/?token={watch.token}"
        watch.follow()
        yield f"the run has ended ({Run(watch.folder).status}); the page stays until Ctrl-C"
        threading.Event().wait()
