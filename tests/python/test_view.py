"""Structure.view(): its page, its answers, and the cell of a notebook in headless Chromium."""
import base64
import contextlib
import html
import http.server
import json
import os
import pathlib
import re
import shutil
import socket
import subprocess
import threading
import time
import urllib.error
import urllib.parse
import urllib.request

import nacre
import numpy as np
import pytest


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
    assert len(json.loads(ask(page + "info?input=x")[2])["bbox"]) == 2
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


def test_without_a_browser_it_is_a_picture(dna):
    bundle = dna.view(size=(64, 48))._repr_mimebundle_()
    assert list(bundle) == ["text/plain", "image/png", "text/html"]
    picture = base64.b64decode(bundle["image/png"])
    assert picture.startswith(b"\x89PNG") and bundle["image/png"] in bundle["text/html"]
    assert "visibility:hidden" in bundle["text/html"]  # until it has drawn


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
    for wrong in ("", "x", view._token[:-1], view._token + "x", view._token.swapcase(), "%00" + view._token, "\u00e4"):
        assert ask(view.url.replace(view._token, urllib.parse.quote(wrong)))[0] == 404
    assert view._token not in "".join(capfd.readouterr())


NOTEBOOK = pathlib.Path(os.environ.get("NACRE_SOURCE", ".")) / "docs/python/view.ipynb"


def wait_for(browser, condition, seconds=90):
    from selenium.webdriver.support.ui import WebDriverWait
    return WebDriverWait(browser, seconds).until(condition)


@contextlib.contextmanager
def chromium():
    pytest.importorskip("selenium")
    if not shutil.which("chromedriver"):
        pytest.skip("chromedriver is not installed")
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    options = webdriver.ChromeOptions()
    for word in ("--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--window-size=1100,1000"):
        options.add_argument(word)
    browser = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
    try:
        yield browser
    finally:
        if os.environ.get("NACRE_SCREENSHOT"):
            browser.save_screenshot(os.environ["NACRE_SCREENSHOT"])
        browser.quit()


# JupyterLab puts a trusted output's HTML in an element, makes its scripts anew so that they run, and attaches it; cells
# out of sight are detached. There is nothing else that classic Notebook has: no jQuery, no require, no IPython.
LAB = b"""<!doctype html><div id="cell"></div><script>
fetch("repr").then(answer => answer.text()).then(html => {
  window.host = document.createElement("div");
  host.innerHTML = html;
  for (const old of host.querySelectorAll("script")) {
    const script = document.createElement("script");
    script.textContent = old.textContent;
    old.replaceWith(script);
  }
  document.getElementById("cell").append(host);
});</script>"""


def test_the_html_alone_turns(dna):
    """As JupyterLab shows it, which Debian does not have."""
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By

    view = dna.view(size=(400, 300), style="ball-and-stick")
    answers = {"/": LAB, "/repr": view._repr_mimebundle_()["text/html"].encode()}

    class Handler(http.server.BaseHTTPRequestHandler):
        def log_message(self, *_):
            pass

        def do_GET(self):
            self.send_response(200 if self.path in answers else 404)
            self.send_header("Content-Type", "text/html; charset=utf-8")
            self.end_headers()
            self.wfile.write(answers.get(self.path, b""))

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        with chromium() as browser:
            browser.get(f"http://127.0.0.1:{server.server_port}/")

            def shown():
                frame = wait_for(browser, lambda b: b.find_elements(By.CSS_SELECTOR, "iframe[src*='127.0.0.1']"))[0]
                wait_for(browser, lambda b: b.execute_script("return arguments[0].style.visibility", frame) == "visible")
                return frame

            browser.switch_to.frame(shown())
            before = int(browser.execute_script("return document.body.dataset.pictures"))
            ActionChains(browser).click_and_hold(browser.find_element(By.ID, "stage")).move_by_offset(60, 20).release().perform()
            wait_for(browser, lambda b: b.execute_script("return document.body.dataset.state === 'rest' && "
                                                         "Number(document.body.dataset.pictures) > arguments[0]", before))
            browser.switch_to.default_content()
            turned = view.description["orientation"]
            assert abs(turned[0]) < 0.999
            # Out of sight and back: the frame is loaded again.
            browser.execute_script("host.remove(); view = host; setTimeout(() => document.getElementById('cell').append(view), 100)")
            browser.switch_to.frame(shown())
            wait_for(browser, lambda b: b.execute_script("return document.body.dataset.state === 'rest'"))
            assert view.description["orientation"] == pytest.approx(turned, abs=1e-5)
    finally:
        server.shutdown()
        server.server_close()


@pytest.fixture
def notebook(tmp_path):
    """The address of Debian's notebook server in a folder with view.ipynb."""
    if not shutil.which("jupyter-notebook"):
        pytest.skip("jupyter-notebook is not installed (tools/packages_dev.txt)")
    shutil.copy(NOTEBOOK, tmp_path)
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    log = open(tmp_path / "log", "w")
    server = subprocess.Popen(["jupyter-notebook", "--no-browser", "--allow-root", "--ip=127.0.0.1", f"--port={port}", "--NotebookApp.token=",
                               "--NotebookApp.disable_check_xsrf=True", f"--notebook-dir={tmp_path}"], stderr=log, stdout=log,
                              env=os.environ | {"HOME": str(tmp_path), "JUPYTER_RUNTIME_DIR": str(tmp_path / "runtime")})
    try:
        for _ in range(600):
            if "is running at" in (tmp_path / "log").read_text():
                break
            time.sleep(0.1)
        else:
            pytest.fail((tmp_path / "log").read_text())
        yield f"http://127.0.0.1:{port}/notebooks/view.ipynb"
    finally:
        server.terminate()
        server.wait(30)
        log.close()


def test_a_cell_turns(notebook):
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By

    with chromium() as browser:
        browser.get(notebook)
        wait_for(browser, lambda b: b.execute_script(
            "return window.Jupyter && Jupyter.notebook && Jupyter.notebook.kernel && Jupyter.notebook.kernel.is_connected()"))

        def run(cell):
            browser.execute_script("Jupyter.notebook.get_cell(arguments[0]).execute()", cell)

        def output(cell):
            return browser.execute_script("return Jupyter.notebook.get_cell(arguments[0]).output_area.toJSON()", cell)

        run(0)
        frame = wait_for(browser, lambda b: b.find_elements(By.CSS_SELECTOR, "iframe[src*='127.0.0.1']"))[0]
        wait_for(browser, lambda b: b.execute_script("return arguments[0].style.visibility", frame) == "visible")
        browser.execute_script("arguments[0].scrollIntoView()", frame)
        browser.switch_to.frame(frame)
        stage = browser.find_element(By.ID, "stage")
        before = int(browser.execute_script("return document.body.dataset.pictures"))
        ActionChains(browser).click_and_hold(stage).move_by_offset(60, 20).release().perform()
        wait_for(browser, lambda b: b.execute_script("return document.body.dataset.state === 'rest' && "
                                                     "Number(document.body.dataset.pictures) > arguments[0]", before))
        browser.switch_to.default_content()
        run(1)
        told = wait_for(browser, lambda b: output(1))[0]["data"]["text/plain"]
        turned = [float(part) for part in re.search(r"orientation': \[([^]]*)\]", told).group(1).split(",")]
        assert len(turned) == 4 and abs(turned[0]) < 0.999, told
        run(2)
        assert "(480, 640, 4)" in wait_for(browser, lambda b: output(2))[0]["data"]["text/plain"]
        run(3)  # a movie, inline
        movie = wait_for(browser, lambda b: output(3))[0]["data"]
        assert "image/png" in movie or "text/html" in movie
        assert wait_for(browser, lambda b: b.execute_script(
            "const i = Jupyter.notebook.get_cell(3).output_area.element.find('img')[0]; return i && i.naturalWidth"))
