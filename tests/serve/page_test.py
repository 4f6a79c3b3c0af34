"""The page of `nacre serve` in headless Chromium. page_test.py PROGRAM

NACRE_LOAD=1 prints frames per second, which nothing here judges. NACRE_SCREENSHOTS=FOLDER keeps pictures of the page.
"""
import importlib.util
import os
import pathlib
import shutil
import sys
import tempfile
import unittest
import urllib.parse
import urllib.request

from served import PDB, Server

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "support"))
import test_data  # noqa: E402

PROGRAM = sys.argv.pop(1)

# WCAG 2: contrast of an element's text with the nearest background that is painted behind it.
CONTRAST = """
const parts = text => (text.match(/[\\d.]+/g) || []).map(Number);
const light = c => { const l = c.slice(0, 3).map(v => v / 255).map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
  return 0.2126 * l[0] + 0.7152 * l[1] + 0.0722 * l[2]; };
const over = (top, under) => { const a = top[3] === undefined ? 1 : top[3]; return under.map((v, i) => top[i] * a + v * (1 - a)); };
const behind = e => { let layers = []; for (; e; e = e.parentElement) { const c = parts(getComputedStyle(e).backgroundColor); layers.push(c);
  if (c[3] === undefined || c[3] === 1) break; } return layers.reverse().reduce((under, top) => over(top, under), [255, 255, 255]); };
const told = [];
const check = (name, element, style, alpha) => { const back = behind(element), ink = parts(style.color); ink[3] = alpha * (ink[3] === undefined ? 1 : ink[3]);
  const a = light(over(ink, back)), b = light(back); told.push([name, (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05)]); };
for (const e of document.querySelectorAll("h1, label, input, select, button, a, small, #error")) {
  check(e.id || e.textContent.trim().slice(0, 20), e, getComputedStyle(e), Number(getComputedStyle(e).opacity));
  if (e.placeholder) { const p = getComputedStyle(e, "::placeholder"); check(e.id + " placeholder", e, p, Number(p.opacity)); }
}
return told;
"""


@unittest.skipUnless(shutil.which("chromedriver") and importlib.util.find_spec("selenium"),
                     "chromedriver or python3-selenium is not installed")
class PageTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        from selenium import webdriver
        from selenium.webdriver.chrome.service import Service
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="nacre-page-"))
        cls.root = test_data.needed_folder() if os.environ.get("NACRE_LOAD") else cls.folder
        cls.addClassCleanup(shutil.rmtree, cls.folder)
        cls.server = Server(PROGRAM, cls.folder, "--root", str(cls.root))
        cls.addClassCleanup(cls.server.stop)
        options = webdriver.ChromeOptions()
        for word in ("--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--window-size=900,700"):
            options.add_argument(word)
        cls.browser = webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
        cls.addClassCleanup(cls.browser.quit)

    def tearDown(self):
        if os.environ.get("NACRE_SCREENSHOTS"):
            self.browser.save_screenshot(os.path.join(os.environ["NACRE_SCREENSHOTS"], f"{self._testMethodName}.png"))
        self.browser.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})
        self.browser.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": False})

    def phone(self, width=360, height=640):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": width, "height": height, "deviceScaleFactor": 2,
                                                                            "mobile": True})
        self.browser.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": True, "maxTouchPoints": 2})

    def open(self, query="?input=sample:glucose"):
        self.browser.get(self.server.url + query)
        return self.at_rest()

    def at(self, name):
        from selenium.webdriver.common.by import By
        return self.browser.find_element(By.ID, name)

    def count(self):
        return int(self.browser.execute_script("return document.body.dataset.pictures || 0"))

    def at_rest(self, more_than=0):
        """The picture's pixels once it is at rest: a hash, and the share that is not white."""
        from selenium.webdriver.support.ui import WebDriverWait
        WebDriverWait(self.browser, 90).until(lambda b: b.execute_script(
            "return document.body.dataset.state === 'rest' && Number(document.body.dataset.pictures) > arguments[0] "
            "&& document.getElementById('picture').naturalWidth > 0", more_than))
        return self.browser.execute_script(
            "const i = document.getElementById('picture'), c = document.createElement('canvas');"
            "c.width = i.naturalWidth; c.height = i.naturalHeight; const g = c.getContext('2d'); g.drawImage(i, 0, 0);"
            "const d = g.getImageData(0, 0, c.width, c.height).data; let h = 0, ink = 0;"
            "for (let k = 0; k < d.length; k += 4) { h = (h * 31 + d[k] + 3 * d[k+1] + 7 * d[k+2]) >>> 0;"
            " if (d[k] < 250) ++ink; } return [h, ink / (c.width * c.height)];")

    def after(self, act):
        """The pixels that an action leads to."""
        before = self.count()
        act()
        return self.at_rest(before)[0]

    def shared(self):
        """What the link to the picture asks for."""
        address = urllib.parse.urlsplit(self.at("link").get_attribute("href"))
        self.assertEqual(address.path, "/picture")
        return dict(urllib.parse.parse_qsl(address.query))

    def test_a_mouse_turns_moves_and_zooms(self):
        from selenium.webdriver.common.action_chains import ActionChains
        from selenium.webdriver.common.actions.wheel_input import ScrollOrigin
        first, ink = self.open("?input=sample:dna")
        self.assertGreater(ink, 0.1)
        stage = self.at("stage")
        dragged = self.after(lambda: ActionChains(self.browser).click_and_hold(stage).move_by_offset(80, 30).release().perform())
        self.assertNotEqual(dragged, first)
        turned = [float(part) for part in self.shared()["orientation"].split(",")]
        self.assertGreater(turned[2], abs(turned[1]))  # to the right is about the vertical axis
        zoomed = self.after(lambda: ActionChains(self.browser).scroll_from_origin(ScrollOrigin.from_element(stage), 0, -300).perform())
        self.assertNotEqual(zoomed, dragged)
        self.assertGreater(float(self.shared()["zoom"]), 1.2)
        chain = ActionChains(self.browser)
        chain.w3c_actions.pointer_action.move_to(stage).pointer_down(button=2).move_by(40, 0).pointer_up(button=2)
        self.assertNotEqual(self.after(chain.perform), zoomed)
        self.assertGreater(float(self.shared()["pan"].split(",")[0]), 0)
        self.assertEqual(self.after(self.at("reset").click), first)

    def test_fingers_turn_and_pinch(self):
        self.phone()
        first = self.open()[0]

        def touch(kind, *points):
            self.browser.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": [{"x": x, "y": y, "id": n} for n, (x, y) in
                                                                                                    enumerate(points)]})

        def drag():
            touch("touchStart", (150, 150))
            for step in range(1, 5):
                touch("touchMove", (150 + 15 * step, 150))
            touch("touchEnd")

        def pinch():
            touch("touchStart", (150, 150), (210, 150))
            for step in range(1, 5):
                touch("touchMove", (150 - 10 * step, 150), (210 + 10 * step, 150))
            touch("touchEnd")

        turned = self.after(drag)
        self.assertNotEqual(turned, first)
        self.assertIn("orientation", self.shared())
        self.assertNotEqual(self.after(pinch), turned)
        self.assertGreater(float(self.shared()["zoom"]), 1.5)
        self.assertEqual(self.browser.execute_script("return scrollY"), 0)  # the page itself stays

    def test_keys(self):
        from selenium.webdriver.common.keys import Keys
        first = self.open()[0]
        stage, seen = self.at("stage"), {first}
        for key in (Keys.ARROW_LEFT, Keys.ARROW_UP, ",", "+", "-"):
            seen.add(self.after(lambda: stage.send_keys(key)))
        self.assertGreaterEqual(len(seen), 5)
        self.assertEqual(self.after(lambda: stage.send_keys("r")), first)
        # Tab reaches the picture and each control, and shows where it is.
        self.browser.execute_script("document.activeElement.blur()")
        reached = []
        for _ in range(20):
            self.browser.switch_to.active_element.send_keys(Keys.TAB)
            focused = self.browser.switch_to.active_element
            reached.append(focused.get_attribute("id"))
            if reached[-1]:
                self.assertEqual(focused.value_of_css_property("outline-style"), "solid", reached[-1])
        for name in ("stage", "input", "upload", "style", "color", "look", "show", "label", "clip", "reset", "whole", "link"):
            self.assertIn(name, reached)

    def test_choices_are_the_tables(self):
        from selenium.webdriver.support.ui import Select
        seen = {self.open()[0]}
        for name, choice in (("style", "licorice"), ("color", "chain"), ("look", "illustrative")):
            select = Select(self.at(name))
            self.assertIn(choice, [option.text for option in select.options])
            seen.add(self.after(lambda: select.select_by_visible_text(choice)))
        for name, text in (("show", "element O=spacefill"), ("label", "id 1=here")):
            seen.add(self.after(lambda: self.at(name).send_keys(text + "\n")))
        cut = "const c = document.getElementById('clip'); c.value = 0; c.dispatchEvent(new Event('input'))"
        seen.add(self.after(lambda: self.browser.execute_script(cut)))
        self.assertEqual(len(seen), 7)
        asked = self.shared()
        self.assertEqual([asked[key] for key in ("style", "color", "look", "show", "label", "clip")],
                         ["licorice", "chain", "illustrative", "element O=spacefill", "id 1=here", "0.00"])
        # The link is the picture, and the address is the page as it is now.
        picture = urllib.request.urlopen(self.at("link").get_attribute("href")).read()
        self.assertTrue(picture.startswith(b"\x89PNG"))
        last = self.at_rest()[0]
        self.browser.get(self.browser.current_url)
        self.assertEqual(self.at_rest()[0], last)

    def test_files_are_chosen_and_dropped(self):
        first = self.open()[0]
        path = self.folder / "gly.pdb"
        path.write_text(PDB)
        uploaded = self.after(lambda: self.at("file").send_keys(str(path)))
        self.assertNotEqual(uploaded, first)
        self.assertTrue(self.shared()["input"].startswith("upload:"))
        drop = ("const t = new DataTransfer(); t.items.add(new File([arguments[0]], 'x.pdb'));"
                "document.dispatchEvent(new DragEvent('drop', {bubbles: true, cancelable: true, dataTransfer: t}))")
        dropped = self.after(lambda: self.browser.execute_script(drop, PDB.replace("1.450", "2.450")))
        self.assertNotEqual(dropped, uploaded)
        before = self.count()
        self.browser.execute_script(drop, "no structure\n")
        self.at_rest(before)
        self.assertIn("the input", self.at("error").text)

    def test_errors_are_seen_and_go(self):
        self.phone()
        self.open()
        field = self.at("input")
        for text, words in (("sample:nothing", "sample"), ("pdb:9xyz", "cache"), ("../x", "no input")):
            field.clear()
            before = self.count()
            field.send_keys(text + "\n")
            self.at_rest(before)
            error = self.at("error")
            self.assertIn(words, error.text)
            box = error.rect
            self.assertTrue(box["x"] >= 0 and box["x"] + box["width"] <= 360 and 0 <= box["y"] and box["y"] + box["height"] <= 640, box)
        self.assertEqual(error.get_attribute("role"), "alert")
        field.clear()
        before = self.count()
        field.send_keys("sample:dna\n")
        self.at_rest(before)
        self.assertEqual(self.at("error").text, "")
        self.assertFalse(self.at("error").is_displayed())

    def test_everything_is_readable(self):
        for scheme in ("light", "dark"):
            self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": scheme}]})
            self.open()
            told = self.browser.execute_script(CONTRAST)
            self.assertGreater(len(told), 15)
            for name, ratio in told:
                self.assertGreaterEqual(ratio, 4.5, f"{name}, {scheme}")

    def test_narrow_screens_hide_nothing(self):
        for width, height in ((360, 640), (320, 568), (640, 360), (768, 1024)):
            self.phone(width, height)
            self.open()
            self.assertLessEqual(self.browser.execute_script("return document.documentElement.scrollWidth - innerWidth"), 0)
            picture = self.at("stage").rect
            self.assertGreater(picture["width"] * picture["height"], 0.4 * width * height)
            for name in ("input", "upload", "style", "color", "look", "show", "label", "clip", "reset", "whole", "link"):
                control = self.at(name)
                self.browser.execute_script("arguments[0].scrollIntoView()", control)
                inside, size = self.browser.execute_script(
                    "const r = arguments[0].getBoundingClientRect(); return [r.left >= 0 && r.right <= innerWidth && r.top >= -1 && "
                    "r.bottom <= innerHeight + 1, r.height]", control)
                self.assertTrue(inside, (name, width))
                self.assertGreaterEqual(size, 15, name)

    @unittest.skipUnless(os.environ.get("NACRE_LOAD"), "NACRE_LOAD is not set: rates are for a quiet machine")
    def test_rates(self):
        """4HHB at 640 x 480: frames per second while a pointer moves, and the time from one move to its picture."""
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": 640 + 272, "height": 480, "deviceScaleFactor": 1,
                                                                            "mobile": False})
        for style in ("cartoon", "spacefill"):
            self.open("?input=4hhb.pdb&style=" + style)
            self.browser.set_script_timeout(60)
            frames, times = self.browser.execute_async_script("""
                const done = arguments[0], stage = document.getElementById('stage'), times = [];
                const send = (type, x) => stage.dispatchEvent(new PointerEvent(type, {pointerId: 1, clientX: x, clientY: 200, bubbles: true}));
                stage.setPointerCapture = () => {};
                const pictures = () => Number(document.body.dataset.pictures);
                const picture = async () => { const n = pictures(); while (pictures() === n) await new Promise(f => setTimeout(f, 1)); };
                (async () => {
                  send('pointerdown', 100); send('pointermove', 101); await picture(); await picture();
                  for (let i = 0; i < 20; ++i) { const t = performance.now(); send('pointermove', 102 + i); await picture();
                    times.push(performance.now() - t); }
                  const start = performance.now(), n = pictures();
                  let x = 130;
                  while (performance.now() - start < 5000) { send('pointermove', 130 + (x++ % 200)); await new Promise(f => setTimeout(f, 8)); }
                  const rate = (pictures() - n) / (performance.now() - start) * 1000;
                  send('pointerup', x); done([rate, times]);
                })();""")
            self.assertEqual(self.at("error").text, "")
            times.sort()
            print(f"4HHB, {style}, 640 x 480: {frames:.1f} frames per second; from a move to its picture {times[0]:.0f} ms at least, "
                  f"median {times[10]:.0f} ms")


if __name__ == "__main__":
    unittest.main(verbosity=2)
