"""A connection of 100 ms each way to one port: what a notebook on another machine is like."""
import asyncio
import threading
import time

DELAY = 0.1


async def _pour(reader, writer):
    """Passes bytes on, each DELAY after it came, in order and however many are under way."""
    waiting = asyncio.Queue()

    async def deliver():
        while True:
            when, data = await waiting.get()
            await asyncio.sleep(max(0, when - time.monotonic()))
            if not data:
                return writer.close()
            writer.write(data)
            await writer.drain()

    task = asyncio.ensure_future(deliver())
    try:
        while data := await reader.read(1 << 16):
            waiting.put_nowait((time.monotonic() + DELAY, data))
    except OSError:
        pass
    waiting.put_nowait((time.monotonic() + DELAY, b""))
    await asyncio.wait([task])


class SlowProxy:
    """Listens on `port` while the block runs."""

    def __init__(self, target):
        self.target, self._loop, self._ready = target, asyncio.new_event_loop(), threading.Event()

    def __enter__(self):
        threading.Thread(target=self._run, daemon=True).start()
        self._ready.wait()
        return self

    def __exit__(self, *_):
        self._loop.call_soon_threadsafe(self._loop.stop)

    def _run(self):
        asyncio.set_event_loop(self._loop)
        self._loop.set_exception_handler(lambda *_: None)  # connections that are cut at the end
        server = self._loop.run_until_complete(asyncio.start_server(self._serve, "127.0.0.1", 0))
        self.port = server.sockets[0].getsockname()[1]
        self._ready.set()
        self._loop.run_forever()

    async def _serve(self, reader, writer):
        there, back = await asyncio.open_connection("127.0.0.1", self.target)
        await asyncio.gather(_pour(reader, back), _pour(there, writer))
