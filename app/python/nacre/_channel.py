"""Views over the kernel's own channel: comm messages, which go where the notebook goes. cell.js is the other end.

One thread draws for all views, so that messages are received while a picture is drawn. Of each view in motion, only the
newest request is answered with a picture.
"""

from __future__ import annotations

import collections
import contextvars
import os
import threading

_MOST_VIEWS = 1000  # that respond

_NO_VIEW = 404, "application/problem+json", b'{"status": 404, "detail": "no such view: run its cell again"}'
_SUPERSEDED = 204, "", b""


class Channel:
    """Requests of pages: {n, view, path}. Answers: {n, status, type}, and the body as a buffer."""

    def __init__(self):
        self._views = {}
        self._changed = threading.Condition()
        self._queue = collections.deque()  # (view, path, answer), in order
        self._moving = {}  # by token: the newest request of each view in motion; the views take turns
        self._thread, self._turn = None, False

    def add(self, token, view):
        self._views[token] = view
        for old in list(self._views)[:-_MOST_VIEWS]:
            del self._views[old]

    def receive(self, data, send):
        """Takes a request. @param send  takes an answer: (data, buffers)"""
        context = contextvars.copy_context()  # ipykernel's send() looks its parent message up there

        def answer(status, kind, body):
            context.copy().run(send, {"n": data["n"], "status": status, "type": kind}, [body])

        token, path = str(data["view"]), str(data["path"])
        if token not in self._views:
            return answer(*_NO_VIEW)
        view, older = self._views[token], None
        with self._changed:
            if path.startswith("picture?") and "&moving=" in path:
                older = self._moving.get(token)
                self._moving[token] = view, path, answer
            else:
                self._queue.append((view, path, answer))
            self._start()
            self._changed.notify()
        if older:
            older[2](*_SUPERSEDED)

    def _start(self):
        if self._thread is None or not self._thread.is_alive():
            self._thread = threading.Thread(target=self._run, name="nacre-view", daemon=True)
            self._thread.start()

    def _next(self):
        with self._changed:
            while not self._queue and not self._moving:
                self._changed.wait()
            self._turn = not self._turn  # the queue and the views in motion take turns
            if self._queue and (self._turn or not self._moving):
                return self._queue.popleft()
            return self._moving.pop(next(iter(self._moving)))

    def _run(self):
        while True:
            view, path, answer = self._next()
            try:
                answer(*view._answer(path))
            except Exception:  # a closed channel
                pass


channel = Channel()


def kernel():
    """Registers the comm target. @returns the id of this process's kernel; None outside kernels"""
    try:
        from ipykernel.connect import get_connection_file
        from ipykernel.kernelapp import IPKernelApp

        running = IPKernelApp.instance().kernel if IPKernelApp.initialized() else None
        if running is None:
            return None
        running.comm_manager.register_target("nacre", _opened)
        name = os.path.splitext(os.path.basename(get_connection_file()))[0]
    except (ImportError, RuntimeError, AttributeError):
        return None
    return name.removeprefix("kernel-")


def _opened(comm, _message):
    comm.on_msg(lambda message: channel.receive(message["content"]["data"], lambda data, buffers: comm.send(data, buffers=buffers)))
