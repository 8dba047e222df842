"""`tremolo watch` against sockets that do what no browser does: no traceback, no thread for each, nothing for strangers."""

import contextlib
import io
import os
import signal
import socket
import tempfile
import threading
import unittest
from pathlib import Path
from unittest import mock

import synthetic_run
from tremolo.__main__ import main
from tremolo.report import watch

PATIENT = 20.0  # s, of a test that waits for an answer


class Served(unittest.TestCase):
    """The page of a small run, on a port of its own."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        synthetic_run.write(Path(self.folder.name) / "run.h5", frames=2, size=5.0)
        self.told = io.StringIO()
        said = contextlib.redirect_stderr(self.told)
        said.__enter__()
        self.addCleanup(said.__exit__, None, None, None)
        self.watch = watch.Watch(self.folder.name)
        self.server = watch.Server(self.watch, 0)
        self.port = self.server.server_address[1]
        self.host = f"Host: 127.0.0.1:{self.port}\r\n"
        serving = threading.Thread(target=self.server.serve_forever, kwargs={"poll_interval": 0.01})
        serving.start()
        self.addCleanup(serving.join)
        self.addCleanup(self.server.server_close)
        self.addCleanup(self.server.shutdown)

    def connect(self, text=b""):
        connection = socket.create_connection(("127.0.0.1", self.port), timeout=PATIENT)
        self.addCleanup(connection.close)
        connection.sendall(text if isinstance(text, bytes) else text.encode())
        return connection

    def answer(self, text):
        """All that comes back until the server closes the connection."""
        connection = self.connect(text)
        parts = []
        with contextlib.suppress(ConnectionResetError):  # it had not read all that was sent
            while part := connection.recv(65536):
                parts.append(part)
        return b"".join(parts).decode("latin-1")

    def status(self, text):
        return int(self.answer(text).split()[1])

    def asked(self, path="/state", host=None, method="GET"):
        return f"{method} {path}?token={self.watch.token} HTTP/1.1\r\n{self.host if host is None else host}\r\n"

    def expect_alive(self):
        self.assertEqual(200, self.status(self.asked()))
        self.assertEqual("", self.told.getvalue())


class Requests(Served):
    def test_malformed_ones_are_refused_in_words(self):
        self.assertEqual(200, self.status(self.asked()))
        refused = [f"GET http://[ HTTP/1.1\r\n{self.host}\r\n", f"GET http://[::1 HTTP/1.1\r\n{self.host}\r\n",
                   "GET\r\n\r\n", "GET / HTTP/9\r\n\r\n", "\x00\x01\x02\r\n\r\n", "GET / HTTP/1.1 more words\r\n\r\n"]
        for text in refused:
            with self.subTest(text=text):
                self.assertRegex(self.answer(text), "(?s)^(HTTP/1.0 400 |.*Error code: 400)")
        self.assertEqual(414, self.status(b"GET /" + 70000 * b"a" + b" HTTP/1.1\r\n\r\n"))
        self.assertEqual(431, self.status("GET / HTTP/1.1\r\n" + "".join(f"X{i}: a\r\n" for i in range(200)) + "\r\n"))
        self.assertEqual(501, self.status(f"BREW / HTTP/1.1\r\n{self.host}\r\n"))
        self.assertEqual(403, self.status(f"GET /?token=\xff%ff%00 HTTP/1.1\r\n{self.host}\r\n".encode("latin-1")))
        self.assertEqual(404, self.status(self.asked("/other")))
        self.expect_alive()

    def test_a_foreign_host_is_refused(self):
        for host in ("", "Host: example.org\r\n", f"Host: example.org:{self.port}\r\n", "Host: 127.0.0.1.example.org\r\n",
                     "Host: localhost@example.org\r\n", self.host + "Host: example.org\r\n", self.host + self.host):
            for method in ("GET", "POST"):
                with self.subTest(host=host, method=method):
                    self.assertEqual(403, self.status(self.asked("/abort" if method == "POST" else "/", host, method)))
        for host in ("LocalHost", f"localhost:{self.port}", "127.0.0.1:8080"):  # of a tunnel
            self.assertEqual(200, self.status(self.asked(host=f"Host: {host}\r\n")))
        self.expect_alive()

    def test_a_browser_that_leaves_is_no_matter(self):
        self.watch.page = 2_000_000 * "page "  # more than sockets buffer
        for _ in range(5):
            connection = self.connect(self.asked("/"))
            connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, b"\x01\x00\x00\x00\x00\x00\x00\x00")  # a reset, at once
            connection.recv(100)
            connection.close()
            self.connect(b"GET / HT").close()
            self.connect().close()
        self.expect_alive()


class Connections(Served):
    def test_those_that_ask_nothing_take_no_threads_and_keep_nobody_waiting(self):
        before = threading.active_count()
        waiting = [self.connect(b"GET / HTTP/1.1\r\nHost: ") for _ in range(400)]
        self.expect_alive()
        self.assertLessEqual(threading.active_count(), before + watch.WORKERS)
        self.assertEqual(400, len(waiting))

    def test_one_that_asks_nothing_is_closed_after_a_while(self):
        with mock.patch.object(self.server.RequestHandlerClass, "timeout", 0.1):
            for text in (b"", b"GET / HTTP/1.1\r\nHo"):
                self.assertEqual(b"", self.connect(text).recv(100))
        self.expect_alive()

    def test_one_that_takes_no_answer_is_closed_after_a_while(self):
        self.watch.page = 4_000_000 * "page "
        with mock.patch.object(self.server.RequestHandlerClass, "timeout", 0.1):
            taken = len(self.answer_late())
        self.assertLess(taken, len(self.watch.page))
        self.expect_alive()

    def answer_late(self):
        """Asks, waits until the server has given up, then takes what is left."""
        connection = self.connect(self.asked("/"))
        given_up = threading.Event()
        close = self.server.shutdown_request
        with mock.patch.object(self.server, "shutdown_request", lambda request: (close(request), given_up.set())):
            self.assertTrue(given_up.wait(PATIENT))
        parts = []
        with contextlib.suppress(ConnectionResetError):
            while part := connection.recv(65536):
                parts.append(part)
        return b"".join(parts)


class AnotherUser(Served):
    def test_whose_run_it_is_alone_ends_it(self):
        with mock.patch.object(watch, "launcher", lambda folder: os.getpid()), \
                mock.patch.object(watch.os, "kill", side_effect=PermissionError) as kill:
            self.assertRegex(self.answer(self.asked("/abort", method="POST")), r"\r\n\r\nthe run belongs to \S+, who alone can end it$")
            kill.assert_called_once_with(os.getpid(), signal.SIGINT)
        with mock.patch.object(watch, "launcher", lambda folder: os.getpid()), \
                mock.patch.object(watch.os, "kill", side_effect=ProcessLookupError):
            self.assertIn("the run has ended by itself", self.answer(self.asked("/abort", method="POST")))
        self.expect_alive()

    def test_a_run_that_may_not_be_read_is_refused(self):
        with mock.patch.object(watch.os, "access", lambda path, mode: Path(path).name != "run.h5"):
            with self.assertRaisesRegex(PermissionError, r"run\.h5: no permission to read it; it belongs to \S+"):
                watch.Watch(self.folder.name)


class Port(unittest.TestCase):
    def said(self, port, status):
        told = io.StringIO()
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stderr(told):
            try:
                self.assertEqual(status, main(["watch", folder, "--port", str(port)]))
            except SystemExit as end:
                self.assertEqual(status, end.code)
        return told.getvalue()

    def test_one_that_does_not_exist_is_named(self):
        for port in (99999, "ten", "+8", "1e3", ""):
            self.assertIn(f"'{port}' is no port; allowed are 1 to 65535, or 0 for a free one", self.said(port, 2))

    def test_one_that_is_taken_is_named(self):
        with socket.create_server(("127.0.0.1", 0)) as taken:
            port = taken.getsockname()[1]
            self.assertEqual(f"tremolo: port {port} of 127.0.0.1: Address already in use\n", self.said(port, 1))


if __name__ == "__main__":
    unittest.main()
