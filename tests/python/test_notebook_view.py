"""A view in a notebook in headless Chromium, over the one port of a notebook server that is 100 ms away each way."""
import contextlib
import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import time

import nacre
import pytest

sys.path.insert(0, os.path.dirname(__file__))
from slow_proxy import SlowProxy  # noqa: E402

SOURCE = pathlib.Path(os.environ.get("NACRE_SOURCE", "."))
NOTEBOOK = SOURCE / "docs/python/view.ipynb"
OUTPUT_AREA = SOURCE / "build/jupyterlab/outputs.js"


def wait_for(browser, condition, seconds=90):
    from selenium.webdriver.support.ui import WebDriverWait
    return WebDriverWait(browser, seconds, poll_frequency=0.1).until(condition)


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


@contextlib.contextmanager
def server(folder, program="jupyter-notebook", path="notebooks", app="NotebookApp"):
    """The port of a notebook server."""
    if not shutil.which(program):
        pytest.skip(f"{program} is not installed (tools/packages_test.txt)")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    log = open(folder / "log", "w")
    running = subprocess.Popen([program, "--no-browser", "--allow-root", "--ip=127.0.0.1", f"--port={port}", f"--{app}.token=",
                                f"--{app}.disable_check_xsrf=True", f"--notebook-dir={folder}"], stderr=log, stdout=log,
                               env=os.environ | {"HOME": str(folder), "JUPYTER_RUNTIME_DIR": str(folder / "runtime")})
    try:
        for _ in range(600):
            if "is running at" in (folder / "log").read_text():
                break
            time.sleep(0.1)
        else:
            pytest.fail((folder / "log").read_text())
        yield port
    finally:
        running.terminate()
        running.wait(30)
        log.close()


class Notebook:
    """A notebook of Notebook 6 in a browser."""

    def __init__(self, browser, address):
        self.browser = browser
        browser.get(address)
        self.connect()

    def connect(self):
        wait_for(self.browser, lambda b: b.execute_script(
            "return window.Jupyter && Jupyter.notebook && Jupyter.notebook.kernel && Jupyter.notebook.kernel.is_connected()"))

    def run(self, cell):
        self.browser.execute_script("Jupyter.notebook.get_cell(arguments[0]).execute()", cell)

    def output(self, cell):
        return self.browser.execute_script("return Jupyter.notebook.get_cell(arguments[0]).output_area.toJSON()", cell)

    def says(self, cell):
        """Runs a cell. @returns its result's text"""
        self.browser.execute_script("Jupyter.notebook.get_cell(arguments[0]).clear_output()", cell)
        self.run(cell)
        return wait_for(self.browser, lambda b: self.output(cell))[0]["data"]["text/plain"]

    def evaluate(self, expression):
        """What an expression is in the kernel, as its repr."""
        return self.says(self.browser.execute_script(
            "const cell = Jupyter.notebook.insert_cell_at_bottom('code'); cell.set_text(arguments[0]); "
            "return Jupyter.notebook.find_cell_index(cell)", f"[{expression}]"))[1:-1]

    def page(self, number=0):
        """The frame of a view that shows its page."""
        frame = wait_for(self.browser, lambda b: b.find_elements("css selector", ".output iframe")[number:])[0]
        wait_for(self.browser, lambda b: b.execute_script("return arguments[0].style.visibility", frame) == "visible")
        self.browser.execute_script("arguments[0].scrollIntoView()", frame)
        return frame


def shown(browser):
    return int(browser.execute_script("return document.body.dataset.shown || 0"))


def at_rest(browser, before):
    wait_for(browser, lambda b: b.execute_script("return document.body.dataset.state === 'rest'") and shown(b) > before)


# The hand of somebody who turns the molecule for some seconds, 60 moves per second. Moves are counted: a busy
# browser sends them later, not fewer.
DRAG = """
const [seconds, done] = arguments, stage = document.getElementById("stage"), box = stage.getBoundingClientRect();
const send = (kind, x) => stage.dispatchEvent(new PointerEvent(kind, {pointerId: 1, bubbles: true, buttons: 1,
  clientX: box.left + x, clientY: box.top + box.height / 2}));
stage.setPointerCapture = () => {};
const start = performance.now(), times = [];
let last = document.body.dataset.shown;
const watch = new MutationObserver(() => {
  if (document.body.dataset.shown !== last) { last = document.body.dataset.shown; times.push(performance.now() - start); }
});
watch.observe(document.body, {attributes: true});
send("pointerdown", 20);
const moves = Math.round(seconds * 60);
let sent = 0;
const timer = setInterval(() => {
  if (++sent <= moves) return send("pointermove", 20 + sent / moves * (box.width - 40));
  clearInterval(timer);
  send("pointerup", box.width - 20);
  watch.disconnect();
  done({times, share: typeof share === "undefined" ? null : share});
}, 16);
"""


# Pictures of a second where each waits for the one before it, 100 ms away. 20 and more are usual: the rest is on its way.
PER_ROUND_TRIP = 10


def best_second(times):
    """The most pictures in a second."""
    return max((sum(1 for other in times if 0 <= other - time < 1000) for time in times), default=0)


def test_a_cell_turns_100_ms_away(tmp_path):
    shutil.copy(NOTEBOOK, tmp_path)
    with server(tmp_path) as port, SlowProxy(port) as proxy, chromium() as browser:
        book = Notebook(browser, f"http://127.0.0.1:{proxy.port}/notebooks/view.ipynb")
        book.run(0)
        first = wait_for(browser, lambda b: book.output(0))[0]["data"]["image/png"]
        browser.switch_to.frame(book.page())
        at_rest(browser, 0)
        browser.set_script_timeout(60)
        rate = 0
        for _ in range(3):  # what else runs only takes from it
            told = browser.execute_async_script(DRAG, 6)
            rate = max(rate, best_second(told["times"]))
            print(f"pictures: {len(told['times'])} in 6 s, {best_second(told['times'])} in the best second, share {told['share']}")
            at_rest(browser, 0)
            if rate > PER_ROUND_TRIP:
                break
        browser.switch_to.default_content()
        described = book.says(1)
        turned = [float(part) for part in re.search(r"orientation': \[([^]]*)\]", described).group(1).split(",")]
        assert len(turned) == 4 and abs(turned[0]) < 0.999, described
        assert "(480, 640, 4)" in book.says(2)
        # A movie, inline.
        book.run(3)
        movie = wait_for(browser, lambda b: book.output(3))[0]["data"]
        assert "image/png" in movie or "text/html" in movie
        # Nothing but the notebook's port: no page on loopback was ever started.
        assert book.evaluate("__import__('nacre._page')._page._running") == "None"
        # What is saved is the last picture.
        wait_for(browser, lambda b: book.output(0)[0]["data"]["image/png"] != first)
        exported(book, tmp_path, first)
        # Style, zoom and a pick.
        browser.switch_to.frame(book.page())
        before = shown(browser)
        browser.execute_script("const s = document.getElementById('style'); s.value = 'spacefill'; s.dispatchEvent(new Event('change'))")
        at_rest(browser, before)
        pick(browser)
        before = shown(browser)
        browser.find_element("id", "play").click()
        wait_for(browser, lambda b: shown(b) > before + 5)
        browser.find_element("id", "play").click()
        at_rest(browser, before)
        browser.switch_to.default_content()
        assert "'style': 'spacefill'" in book.says(1)
        assert int(book.evaluate("view.picked")) >= 0
        a_hundred_cells(book)
        as_jupyterlab_shows_it(book)
        assert rate > PER_ROUND_TRIP


def pick(browser):
    """Clicks until an atom is hit: which ones stand in the middle is the drag's doing."""
    from selenium.webdriver.common.action_chains import ActionChains

    stage = browser.find_element("id", "stage")
    for x in range(-75, 90, 15):
        ActionChains(browser).move_to_element_with_offset(stage, x, 20).click().perform()
        time.sleep(1)
        if re.fullmatch(r"D[ACGT] \d+ \S+, chain [AB]", browser.find_element("id", "picked").text):
            return
    pytest.fail("no atom was picked")


def exported(book, folder, first):
    """A page without a kernel shows the last picture."""
    browser, last = book.browser, book.output(0)[0]["data"]["image/png"]
    browser.execute_async_script("Jupyter.notebook.save_notebook().then(arguments[0])")
    subprocess.run([sys.executable, "-m", "nbconvert", "--to", "html", "view.ipynb"], cwd=folder, check=True, capture_output=True)
    html = (folder / "view.html").read_text()
    assert last in html and first not in html
    notebook = browser.current_window_handle
    browser.switch_to.new_window("tab")
    browser.get((folder / "view.html").as_uri())
    image = browser.find_element("css selector", "div[id^='nacre-'] img")
    browser.execute_script("arguments[0].scrollIntoView()", image)
    time.sleep(2)  # a page would come now
    assert browser.execute_script("return arguments[0].naturalWidth", image) > 100
    assert not browser.find_elements("css selector", "iframe")
    browser.close()
    browser.switch_to.window(notebook)


def test_a_page_of_its_own_picks():
    view = nacre.open("sample:dna").view(size=(480, 360))
    with chromium() as browser:
        browser.get(view.url)
        at_rest(browser, 0)
        pick(browser)
        assert view.picked is not None
        assert browser.find_element("id", "picked").text.startswith(str(view.structure.atoms["residue_name"][view.picked]))


def a_hundred_cells(book):
    """All are alive: one channel, one thread, one renderer."""
    browser = book.browser
    number = browser.execute_script(
        "const cell = Jupyter.notebook.insert_cell_at_bottom('code'); cell.set_text(arguments[0]); cell.execute(); "
        "return Jupyter.notebook.find_cell_index(cell)",
        "many = [view.structure.view(size=(420, 60), zoom=1 + i / 100) for i in range(100)]\nfor one in many: display(one)")
    wait_for(browser, lambda b: len(book.output(number)) == 100)
    roots = browser.find_elements("css selector", ".output div[id^='nacre-']")[-100:]
    for i in (99, 50, 0):
        browser.execute_script("arguments[0].scrollIntoView()", roots[i])
        frame = wait_for(browser, lambda b: roots[i].find_elements("css selector", "iframe"))[0]
        wait_for(browser, lambda b: b.execute_script("return arguments[0].style.visibility", frame) == "visible")
        browser.switch_to.frame(frame)
        before = shown(browser)
        browser.execute_async_script(DRAG, 0.3)
        at_rest(browser, before)
        browser.switch_to.default_content()
        wait_for(browser, lambda b: book.evaluate(f"abs(many[{i}].description['orientation'][0]) < 0.999") == "True")


def imitate_output_area(browser, html):
    browser.execute_script("""
        const host = document.createElement("div");
        host.innerHTML = arguments[0];
        for (const old of host.querySelectorAll("script")) {
          const script = document.createElement("script");
          script.textContent = old.textContent;
          old.replaceWith(script);
        }
        document.body.append(host);""", html)


def as_jupyterlab_shows_it(book):
    """JupyterLab and Notebook 7, which Debian does not have, put a trusted output's HTML in an element and make its scripts
    anew: by their own output area where tools/jupyterlab_outputs has made it, else by an imitation. Nothing of Notebook 6
    is there: no Jupyter, no require. Their page says where the server is."""
    browser, data = book.browser, book.output(0)[0]["data"]
    html = data["text/html"]
    kernel = browser.execute_script("return Jupyter.notebook.kernel.id")
    assert kernel in html
    browser.get(browser.current_url.split("/notebooks")[0] + "/tree")
    browser.execute_script("""
        delete window.Jupyter;
        document.body.innerHTML = '<script id="jupyter-config-data" type="application/json">{"baseUrl": "/", "token": ""}</scr' + 'ipt>';""")
    if OUTPUT_AREA.exists():
        print("JupyterLab's own output area")
        browser.execute_script(OUTPUT_AREA.read_text() + "; showOutputs([arguments[0]], document.body)",
                               {"output_type": "display_data", "data": data, "metadata": {}})
    else:
        imitate_output_area(browser, html)
    frame = wait_for(browser, lambda b: b.find_elements("css selector", "iframe"))[0]
    wait_for(browser, lambda b: b.execute_script("return arguments[0].style.visibility", frame) == "visible")
    browser.switch_to.frame(frame)
    at_rest(browser, 0)
    browser.set_script_timeout(60)
    told = browser.execute_async_script(DRAG, 3)
    assert len(told["times"]) > 5
    # Without its kernel the last picture stands.
    at_rest(browser, 0)
    last = browser.execute_script("return document.getElementById('picture').src")
    browser.execute_async_script("fetch('/api/kernels/' + arguments[0], {method: 'DELETE'}).then(arguments[1])", kernel)
    browser.execute_async_script(DRAG, 0.5)
    assert browser.execute_script("return document.getElementById('picture').src") == last
