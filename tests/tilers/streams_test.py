"""tools/tilers reads what drivers print: each reader against a few lines whose answer is counted by hand, and what makes a
number worse."""

import importlib.machinery
import importlib.util
import pathlib
import sys
import unittest

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"
sys.path.insert(0, str(TOOLS))
import tilers_streams

loader = importlib.machinery.SourceFileLoader("tilers", str(TOOLS / "tilers"))
tilers = importlib.util.module_from_spec(importlib.util.spec_from_loader("tilers", loader))
loader.exec_module(tilers)

BIN = """
 RB_BIN_CONTROL: { BINW = 1024 | BINH = 512 | RENDER_MODE = RENDERING_PASS }
 { MARKER_MODE = SET_RENDER_MODE | MODE = RM6_BIN_RENDER_START | USES_GMEM }
 RB_BLIT_SCISSOR_BR: { X = 1023 | Y = 1023 }
 RB_BLIT_DST_INFO: { TILE_MODE = TILE6_3 | COLOR_FORMAT = FMT6_32_FLOAT }
 RB_BLIT_INFO: { TYPE = BLIT_EVENT_LOAD | CLEAR_MASK = 0xf }
 event BLIT
 GRAS_LRZ_CNTL: { ENABLE | DIR = LRZ_DIR_LE }
 GRAS_SU_DEPTH_PLANE_CNTL: { Z_MODE = A6XX_EARLY_Z }
 opcode: CP_DRAW_INDX_OFFSET (38) (4 dwords)
 GRAS_LRZ_CNTL: { DIR = 0 | Z_FUNC = FUNC_NEVER }
 GRAS_SU_DEPTH_PLANE_CNTL: { Z_MODE = A6XX_LATE_Z }
 opcode: CP_DRAW_INDX_OFFSET (38) (4 dwords)
 RB_BLIT_DST_INFO: { TILE_MODE = TILE6_3 | COLOR_FORMAT = FMT6_16_16_16_16_FLOAT }
 RB_BLIT_INFO: { TYPE = BLIT_EVENT_STORE | CLEAR_MASK = 0 }
 event BLIT
 { MARKER_MODE = SET_RENDER_MODE | MODE = RM6_BIN_RENDER_END }
"""

JOB = """
TILE_RENDERING_MODE_CFG_COMMON
    Image Width (pixels): 1024
CFG_BITS
    Early Z enable: 0 /* false */
VERTEX_ARRAY_INSTANCED_PRIMS
    mode: 4
LOAD
    Buffer to Load: 9 /* Z */
    Input Image Format: 40 /* d32f */
STORE
    Buffer to Store: 0 /* Render target 0 */
    Output Image Format: 0 /* rgba16f */
STORE
    Buffer to Store: 8 /* None */
    Output Image Format: 0 /* srgb8_alpha8 */
@add_render 0
"""

FRAMEBUFFER = """
Framebuffer @f7fc3040:
  Width: 1024
  Pre Frame 0: Never
  Pre Frame 1: Always
  Z Write Enable: true
  Z Preload Enable: false
  ZS Writeback Base: 0xf77ab000
Color Render Targets @f7fc3100:
  Color Render Target 0:
    Write Enable: true
    Writeback Format: RAW64
    Clean Pixel Write Enable: true
    ZS update operation: Force Early
    ZS update operation: Force Late
"""


class Streams(unittest.TestCase):
    def test_each_tile_of_turnip_counts_as_its_share(self):
        found = tilers_streams.of_turnip(BIN + BIN, 1024)  # two tiles of one render pass
        self.assertEqual((found["loads"], found["stores"], found["passes"]), (4, 8, 1))
        self.assertEqual((found["draws"], found["late"], found["without_lrz"]), (2, 1, 1))
        self.assertEqual(found["bins"], "1024x512")
        self.assertEqual(tilers_streams.of_turnip(4 * BIN, 1024)["stores"], 16)  # two render passes

    def test_what_v3dv_loads_and_stores_is_its_jobs(self):
        found = tilers_streams.of_v3dv(JOB, 1024)
        self.assertEqual(found, {"loads": 4, "stores": 8, "late": 1, "draws": 1, "passes": 1})
        self.assertEqual(tilers_streams.of_v3dv(JOB, 512)["passes"], 0)  # another picture's

    def test_what_panvk_draws_before_a_frame_it_loads(self):
        found = tilers_streams.of_panvk(FRAMEBUFFER, 1024)
        self.assertEqual(found, {"loads": 4, "stores": 12, "late": 1, "draws": 2, "passes": 1})

    def test_the_most_of_pipelines_that_share_a_name(self):
        record = {"pipeline": "colour", "stage": "fragment"}
        found = tilers_streams.pipelines_of([{**record, "statistics": {"Instruction Count": 7, "STP Count": 0}},
                                             {**record, "statistics": {"Instruction Count": 9, "STP Count": 0}}])
        self.assertEqual(found, {"colour, fragment": {"instructions": 9, "spills": 0}})


class Worse(unittest.TestCase):
    def row(self, **stream):
        return {"paths": {"encoded": {"stream": {"loads": 0, "stores": 4, "late": 0, "tiles_by_default": True, **stream},
                                      "pipelines": {"colour, fragment": {"instructions": 10 + stream.get("stores", 4)}}}}}

    def test_the_same_and_less_are_not_worse(self):
        self.assertEqual(tilers.worse("A", self.row(), self.row()), [])
        self.assertEqual(tilers.worse("A", self.row(stores=8), self.row(stores=4)), [])

    def test_every_number_that_grows_is_told(self):
        self.assertEqual(tilers.worse("A", self.row(), self.row(stores=8)),
                         ["A, encoded: stores 4, now 8", "A, encoded, colour, fragment: instructions 14, now 18"])
        self.assertEqual(tilers.worse("A", self.row(), self.row(late=2)), ["A, encoded: late 0, now 2"])
        self.assertEqual(tilers.worse("A", self.row(), self.row(tiles_by_default=False)),
                         ["A, encoded: drawn past the tiles by default"])
        self.assertEqual(tilers.worse("A", self.row(), {"paths": {"encoded": {"lacks": "it ends the program"}}}),
                         ["A, encoded: it ends the program"])


if __name__ == "__main__":
    unittest.main()
