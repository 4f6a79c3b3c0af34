"""Structure.view(): what it answers, over loopback and over the kernel's channel. test_notebook_view.py has the browser."""
import base64
import html
import json
import re
import threading
import time
import urllib.error
import urllib.parse
import urllib.request

import nacre
import numpy as np
import pytest
from nacre._channel import Channel


@pytest.fixture(scope="module")
def dna():
    return nacre.open("sample:dna")


def ask(url, **headers):
    try:
        with urllib.request.urlopen(urllib.request.Request(url, headers=headers), timeout=120) as answer:
            return answer.status, answer.headers["Content-Type"], answer.read()
    except urllib.error.HTTPError as error:
        return error.code, error.headers["Content-Type"], error.read()


def test_what_it_answers(dna, tmp_path):
    view = dna.view(size=(96, 64), style="licorice", color="chain")
    page, _, query = view.url.partition("?")
    assert page.startswith("http://127.0.0.1:")
    assert {"input": "sample:dna", "style": "licorice", "color": "chain"} == dict(urllib.parse.parse_qsl(query))
    status, kind, body = ask(view.url)
    assert (status, kind) == (200, "text/html; charset=utf-8") and b'<body class="cell" ' in body
    assert "style" in json.loads(ask(page + "options")[2])["properties"]
    assert len(json.loads(ask(page + "info?input=x")[2])[0]["bbox"]) == 2
    status, kind, body = ask(page + "picture?style=licorice&color=chain&size=96x64&zoom=1.5&orientation=0.6,0.8,0,0&pan=1,2")
    assert (status, kind) == (200, "image/png")
    # It reads back where it was turned to, and that draws the same.
    assert view.description == {"style": "licorice", "color": "chain", "zoom": 1.5, "orientation": [0.6, 0.8, 0, 0], "pan": [1, 2]}
    dna.save(tmp_path / "a.png", size=(96, 64), **view.description)
    assert (tmp_path / "a.png").read_bytes() == body
    assert np.array_equal(view.picture(), dna.render(size=(96, 64), **view.description))
    assert view.picture(size=(32, 32)).shape == (32, 32, 4)
    view.save(tmp_path / "b.png")
    assert (tmp_path / "b.png").read_bytes() == body
    moving = ask(page + "picture?style=licorice&zoom=2&moving=1&session=x&supersample=1&format=jpg&size=40x30")
    assert moving[1] == "image/jpeg" and moving[2].startswith(b"\xff\xd8")
    assert view.description == {"style": "licorice", "color": "chain", "zoom": 2}


def test_options_of_the_cell_stay(dna):
    values = np.arange(len(dna), dtype=float)
    view = dna.view(size=(48, 48), color=values, palette="plasma", zoom=3)
    assert view.description["zoom"] == 3
    ask(view.url.partition("?")[0] + "picture?size=48x48&zoom=1")
    assert view.description["zoom"] == 1 and view.description["color"] is values
    assert np.array_equal(view.picture(), dna.render(size=(48, 48), color=values, palette="plasma", zoom=1))


def test_nobody_else_is_answered(dna):
    view = dna.view()
    page, _, _ = view.url.partition("?")
    host = urllib.parse.urlsplit(page).netloc
    assert ask(f"http://{host}/")[0] == 404
    assert ask(f"http://{host}/{'x' * 32}/picture?zoom=1")[0] == 404
    assert ask(page + "picture?zoom=1&size=32x32", Host="evil.example")[0] == 404
    assert ask(page + "../../etc/passwd")[0] == 404
    assert ask(page + "nothing")[0] == 404
    status, kind, body = ask(page + "picture?style=blob&size=32x32")
    assert (status, kind) == (400, "application/problem+json") and "spacefill" in json.loads(body)["detail"]
    # What names files is no option of a page.
    assert ask(page + "picture?size=32x32&output=/tmp/x.png&look=/etc/passwd")[0] == 400


def test_outside_a_notebook_it_is_a_picture(dna):
    bundle = dna.view(size=(64, 48))._repr_mimebundle_()
    assert list(bundle) == ["text/plain", "image/png"]
    assert base64.b64decode(bundle["image/png"]).startswith(b"\x89PNG")


def test_a_page_that_is_loaded_again_shows_what_was_seen(dna):
    view = dna.view(style="licorice", zoom=3)
    first = view.url
    assert b"zoom=3" in ask(first)[2]
    ask(first.partition("?")[0] + "picture?size=32x32&style=licorice&zoom=1.25&orientation=0.6,0.8,0,0")
    page = ask(first)[2].decode()
    query = urllib.parse.parse_qs(html.unescape(re.search('data-query="([^"]*)"', page).group(1)))
    assert (query["zoom"], query["orientation"]) == (["1.25"], ["0.6,0.8,0.0,0.0"])


def test_the_token_stays_secret(dna, capfd):
    view = dna.view()
    request = urllib.request.urlopen(view.url, timeout=60)
    # No address of the page goes to whoever is linked from it, into a cache, or into a log.
    assert request.headers["Referrer-Policy"] == "no-referrer" and request.headers["Cache-Control"] == "no-store"
    assert request.headers["Access-Control-Allow-Origin"] is None
    assert len(urllib.parse.urlsplit(view.url).path) >= 32
    for wrong in ("", "x", view._loopback[:-1], view._loopback + "x", view._loopback.swapcase(), "%00" + view._loopback, "\u00e4"):
        assert ask(view.url.replace(view._loopback, urllib.parse.quote(wrong)))[0] == 404
    assert view._loopback not in "".join(capfd.readouterr())


def test_what_is_picked(dna):
    view = dna.view(size=(64, 64))
    ids = dna.layers(size=(64, 64), zoom=1)["id"]
    y, x = np.argwhere(ids > 0)[0]
    answer = json.loads(ask(view.url.partition("?")[0] + f"pick?size=64x64&zoom=1&at={x},{y}")[2])
    assert view.picked == answer["atom"] == ids[y, x] - 1
    assert answer["text"].startswith(str(dna.atoms["residue_name"][view.picked]))
    y, x = np.argwhere(ids == 0)[0]
    assert json.loads(ask(view.url.partition("?")[0] + f"pick?size=64x64&zoom=1&at={x},{y}")[2]) == {"atom": None, "text": ""}
    assert view.picked is None


class Page:
    """The other end of a channel."""

    def __init__(self, channel, token):
        self.channel, self.token, self.answers, self.changed = channel, token, {}, threading.Condition()

    def ask(self, n, path):
        self.channel.receive({"n": n, "view": self.token, "path": path}, self.take)

    def take(self, data, buffers):
        with self.changed:
            self.answers[data["n"]] = data["status"], data["type"], buffers[0]
            self.changed.notify()

    def wait(self, *numbers):
        with self.changed:
            assert self.changed.wait_for(lambda: all(n in self.answers for n in numbers), 60)
        return [self.answers[n] for n in numbers]


def test_the_newest_view_wins(dna):
    channel, drawn, go = Channel(), [], threading.Event()

    class Slow:
        def _answer(self, path):
            go.wait(60)
            drawn.append(path)
            return 200, "image/jpeg", b"x"

    channel.add("slow", Slow())
    page = Page(channel, "slow")
    for n in range(6):
        page.ask(n, f"picture?zoom={n}&moving=1")
        if n == 0:  # it is being drawn
            wait_until(lambda: not channel._moving)
    go.set()
    answers = page.wait(*range(6))
    assert [status for status, _, _ in answers] == [200, 204, 204, 204, 204, 200]
    assert drawn == ["picture?zoom=0&moving=1", "picture?zoom=5&moving=1"]


def wait_until(condition):
    for _ in range(6000):
        if condition():
            return
        time.sleep(0.01)
    pytest.fail("it did not come")


def test_a_hundred_views_share_one_renderer(dna):
    channel = Channel()
    views = [dna.view(size=(48, 32), style="licorice") for _ in range(100)]
    pages = []
    for i, view in enumerate(views):
        channel.add(str(i), view)
        pages.append(Page(channel, str(i)))
    for i, page in enumerate(pages):
        page.ask(0, f"picture?size=48x32&zoom={1 + i / 100}&format=jpg&moving=1")
    for i, page in enumerate(pages):
        (status, kind, data), = page.wait(0)
        assert (status, kind) == (200, "image/jpeg") and data.startswith(b"\xff\xd8")
        assert views[i].description["zoom"] == 1 + i / 100
    assert len([t for t in threading.enumerate() if t.name == "nacre-view"]) <= 2  # this channel's, and an earlier test's


def test_who_knows_no_view_is_told_nothing(dna):
    page = Page(Channel(), "x" * 32)
    page.ask(1, "picture?zoom=1")
    assert page.wait(1)[0][0] == 404


def test_models_are_frames(tmp_path):
    atom = "HETATM    1  C   LIG A   1    {:8.3f}   0.000   0.000  1.00  0.00           C  \n"
    (tmp_path / "a.pdb").write_text("".join(f"MODEL {i + 1:8d}\n{atom.format(i * 4)}{atom.format(2 + i * 4)}ENDMDL\n" for i in range(3)))
    several = nacre.open(tmp_path / "a.pdb")
    assert several.frames == 3
    assert several.frame(3).atoms["position"][:, 0].tolist() == [8, 10]
    with pytest.raises(nacre.UsageError, match="frames 1 to 3"):
        several.frame(4)
    view = several.view(size=(32, 32))
    status, _, data = view._answer("picture?size=32x32&zoom=1&frame=2")
    assert status == 200 and view.frame == 2
    several.frame(2).save(tmp_path / "b.png", size=(32, 32), zoom=1)
    assert data == (tmp_path / "b.png").read_bytes()
    assert json.loads(view._answer("info?input=x")[2])[0]["frames"] == 3


def test_vs_code_is_answered_by_widget_messages(dna, monkeypatch, tmp_path):
    """By the package anywidget, which Debian does not have: this stands for it."""
    import shutil
    import subprocess
    import sys
    import types

    sent = []

    class AnyWidget:
        def on_msg(self, callback):
            self.callback = callback

        def send(self, content, buffers=None):
            sent.append((content, buffers))

        def _repr_mimebundle_(self, **_):
            return {"application/vnd.jupyter.widget-view+json": {"model_id": "x"}}, {}

    monkeypatch.setitem(sys.modules, "anywidget", types.SimpleNamespace(AnyWidget=AnyWidget))
    monkeypatch.setenv("VSCODE_PID", "1")
    view = dna.view(size=(48, 32))
    bundle = view._repr_mimebundle_()
    assert list(bundle) == ["text/plain", "image/png", "application/vnd.jupyter.widget-view+json"]
    widget = view._held
    widget.callback(widget, {"n": 7, "view": view._token, "path": "picture?size=48x32&zoom=1&format=jpg"}, [])
    wait_until(lambda: sent)
    (content, buffers), = sent
    assert content == {"n": 7, "status": 200, "type": "image/jpeg"} and buffers[0].startswith(b"\xff\xd8")
    if not shutil.which("node"):
        pytest.skip("node is not installed")
    # Its front end's module renders into an element and asks by the model.
    (tmp_path / "cell.mjs").write_text(widget._esm)
    (tmp_path / "run.mjs").write_text("""
import cell from "./cell.mjs";
const asked = [];
globalThis.IntersectionObserver = class { constructor(see) { this.see = see; }
  observe() { this.see([{isIntersecting: true}], {disconnect() {}}); } };
globalThis.document = {createElement: () => ({style: {}})};
const root = {querySelector: () => ({alt: "x"}), append() {}};
const el = {set innerHTML(html) { this.html = html; }, get firstElementChild() { return root; }};
cell.render({model: {on() {}, send: data => asked.push(data)}, el});
await new Promise(done => setTimeout(done, 50));
console.log(JSON.stringify({asked, picture: el.html.includes("data:image/png;base64,")}));
""")
    run = subprocess.run(["node", tmp_path / "run.mjs"], capture_output=True, text=True)
    told = json.loads(run.stdout)
    assert told == {"asked": [{"n": 1, "view": view._token, "path": ""}], "picture": True}, run.stderr
