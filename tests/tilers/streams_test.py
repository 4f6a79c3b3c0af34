"""tools/tilers reads what drivers print: each reader against a few lines whose answer is counted by hand, and what makes a
number worse."""

import importlib.machinery
import importlib.util
import json
import pathlib
import sys
import unittest

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "tools"
sys.path.insert(0, str(TOOLS))
import tilers_costs
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

COMMANDS = """
  MOVE32 r57, #0x10183
  RUN_IDVS.varying_srt0 r0, #0
  RUN_IDVS.varying_srt0 r0, #0
  MOVE32 r57, #0x30
  RUN_IDVS.varying_srt0 r0, #200
"""

TRACE = """
000 +0: start_render_pass: maxSamples=1, clearCPP=12, loadCPP=4, storeCPP=8, width=1024, height=1024, binWidth=768, binHeight=1024, 
000 +0: start_gmem_store: format=r8g8b8a8_srgb, fast_path=1, 
000 +0: end_render_pass: tiledRender=true, drawCount=5, lrz=true, 
000 +0: start_render_pass: maxSamples=1, clearCPP=0, loadCPP=4, storeCPP=4, width=64, height=64, binWidth=64, binHeight=64, 
000 +0: end_render_pass: tiledRender=true, drawCount=1, lrz=false, 
"""

# Two draws of one class, one of another; colour is cleared and stored, depth stored. Compute, and another picture.
ENCODERS = """flags = 2
vdm_ctrl_stream_base = 0x1
Fragment control
  Pass type: Opaque
Fragment control 2
  Visibility mode: None
  Pass type: Opaque
Index List
  Primitive: Triangle strip
Index List
  Primitive: Triangle strip
Fragment control 2
  Visibility mode: None
  Pass type: Punch through
Index List
  Primitive: Triangles
ppp_ctrl = 0x202
ZLS Control
  Z Load: false
  Z Store: true
width_px = 1024
layers = 1
bg.usc = 0x1
Load pipeline (1, handle 14)
Shader
No preshader
eot.usc = 0x2
Store pipeline (2, handle 14)
PBE
  Channels: R16G16B16A16
No preshader
partial_bg.usc = 0x3
Partial reload pipeline (3, handle 14)
Texture
  Channels: R16G16B16A16
No preshader
flags = 0
cdm_ctrl_stream_base = 0x1
"""

COMPILED = """
SHADER-DB: MESA_SHADER_COMPUTE shader: 5 inst, 1.000000 cycles, 0.3 fma, 1.000000 ls, 9 quadwords, 2 threads, 0 loops, 0:0 spills:fills
nacre pipeline begun
SHADER-DB: MESA_SHADER_POSITION shader: 50 inst, 4.000000 cycles, 0.5 fma, 4.000000 ls, 32 quadwords, 2 threads, 0 loops, 0:0 spills:fills
SHADER-DB: MESA_SHADER_VARYING shader: 10 inst, 3.000000 cycles, 0.1 fma, 3.000000 ls, 16 quadwords, 2 threads, 0 loops, 0:0 spills:fills
SHADER-DB: MESA_SHADER_FRAGMENT shader: 90 inst, 70 tuples, 2.0 arith, 0.5 vary, 2.000000 ldst, 24 quadwords, 1 threads, 0 preloads, 0 loops, 1:2 spills:fills
nacre pipeline made 0x1
nacre pipeline begun
nacre pipeline made 0x2
nacre pipeline named 0x1 colour, spheres
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

    def test_of_later_mali_generations_flags_of_draws_are_in_a_register(self):
        found = tilers_streams.of_panvk(FRAMEBUFFER.split("    ZS update")[0] + COMMANDS, 1024)
        self.assertEqual(found, {"loads": 4, "stores": 12, "late": 1, "draws": 3, "passes": 1})

    def test_turnip_tells_of_its_render_passes(self):
        found = tilers_streams.of_gpu_trace(TRACE, 1024)
        self.assertEqual(found, {"loads": 4, "stores": 8, "draws": 5, "passes": 1, "bins": "768x1024"})
        self.assertEqual(tilers_streams.of_gpu_trace(TRACE, 1024, 2)["stores"], 16)

    def test_honeykrisps_programs_load_and_store_tiles(self):
        found = tilers_streams.of_honeykrisp(ENCODERS, 1024)
        self.assertEqual(found, {"loads": 0, "stores": 12, "late": 1, "draws": 3, "passes": 1,
                                 "classes": {"Opaque": 2, "Punch through": 1}})
        self.assertEqual(tilers_streams.of_honeykrisp(ENCODERS, 512)["passes"], 0)
        both = ENCODERS.replace("layers = 1", "layers = 2").replace("Z Load: false", "Z Load: true")
        self.assertEqual((tilers_streams.of_honeykrisp(both, 1024)["loads"],
                          tilers_streams.of_honeykrisp(both, 1024)["stores"]), (8, 24))
        loaded = ENCODERS.replace("Load pipeline (1, handle 14)\n", "Load pipeline (1, handle 14)\nTexture\n  Channels: R32\n")
        self.assertEqual(tilers_streams.of_honeykrisp(loaded, 1024)["loads"], 4)

    def test_the_most_of_pipelines_that_share_a_name(self):
        record = {"pipeline": "colour", "stage": "fragment"}
        records = [{**record, "statistics": {"Instruction Count": 7, "STP Count": 0}},
                   {**record, "statistics": {"Instruction Count": 9, "STP Count": 0}}, {**record, "statistics": {}}]
        self.assertEqual(tilers_streams.pipelines_of(records, "spheres"), {"colour, fragment": {"instructions": 9, "spills": 0}})
        self.assertEqual(list(tilers_streams.pipelines_of(records, "cartoons")), ["colour of cartoons, fragment"])

    def test_what_panvks_compiler_prints_belongs_to_the_pipeline_that_is_named_after_it(self):
        found = tilers_streams.pipelines_of(tilers_streams.of_mali(COMPILED), "spheres")
        self.assertEqual(found, {"colour, spheres, vertex": {"instructions": 60, "loads": 7, "registers": 32, "spills": 0},
                                 "colour, spheres, fragment": {"instructions": 90, "loads": 2, "registers": 64, "spills": 3}})

    def test_a_shader_that_blends_is_told_beside_the_encoding(self):
        line = COMPILED.splitlines()[4].replace("VARYING", "BLEND")
        self.assertEqual(tilers_streams.blending_of_mali(COMPILED), {})
        found = tilers_streams.blending_of_mali(COMPILED + line)
        self.assertEqual(found, {"depth encoding, blending, fragment": {"instructions": 10}})
        found = tilers_streams.blending_of_mali(COMPILED + COMPILED.splitlines()[5].replace("FRAGMENT", "BLEND"))
        self.assertEqual(found, {"depth encoding, blending, fragment": {"instructions": 90}})
        self.assertEqual(tilers_streams.pipelines_of(tilers_streams.of_mali(COMPILED + line), "spheres"),
                         tilers_streams.pipelines_of(tilers_streams.of_mali(COMPILED), "spheres"))

    def test_a_page_is_written_anew_around_its_words(self):
        plan = {"render_passes": 1, "loads": 0, "stores": 4}
        row = {"driver": "turnip", "visibility": "encoded", "why": "it is a tiler", "encoded_format": "R32F",
               "dynamic_rendering": False, "features": {"api_version": "1.1.0", **{f: True for f in tilers_streams.FEATURES}},
               "bake": {}, "paths": {"encoded": {"plan": plan, "pipelines": {
                   "depth encoding, spheres, fragment": {"instructions": 39},
                   "depth encoding, blending, fragment": {"instructions": 12},
                   "impostor colour, spheres, fragment": {"instructions": 115}}}, "fragdepth": {"lacks": "all of it"}}}
        page = "first\n<!-- devices -->\n\nthen\n"
        tables = {"devices": tilers_streams.summary({"A": row})}
        once = tilers_streams.written_into(page, tables)
        self.assertIn("| A | `encoded` | R32F | 1; 0, 4 B | not told, not told | 39 + 12; 115 | 12;  |\n\nthen", once)
        devices = tilers_streams.devices_page({"A": row})
        self.assertIn("| depth encoding, spheres | encoded |  | 39 |", devices)
        self.assertIn("| fragdepth | all of it | | | |", devices)
        self.assertEqual(tilers_streams.written_into(once, tables), once)
        with self.assertRaisesRegex(ValueError, "no place for the table of others"):
            tilers_streams.written_into(page, {"others": []})

    def test_of_a_device_that_fetches_spheres_the_fetched_ones_are_told(self):
        entry = {"plan": {"render_passes": 1, "loads": 0, "stores": 4},
                 "pipelines": {"impostor colour, fetched spheres, fragment": {"instructions": 142}}}
        row = {"visibility": "encoded", "encoded_format": "R32F", "paths": {"encoded": entry, "fragdepth": {}}}
        self.assertIn("| ; 142 |", tilers_streams.summary({"A": row})[2])


class Costs(unittest.TestCase):
    def pipelines(self, kind):
        numbers = {"opaque prepass, spheres": (10, 1), "depth encoding, spheres": (20, 2), f"impostor colour, {kind}": (30, 3)}
        stages = {f"{name}, {stage}": {"instructions": n[i]} for name, n in numbers.items() for i, stage in
                  enumerate(("vertex", "fragment"))}
        return stages | {"depth encoding, blending, fragment": {"instructions": 5}}

    def test_a_frame_costs_its_vertices_and_fragments(self):
        fragments = {"opaque prepass": 1_000_000, "depth encoding": 2_000_000, "impostor colour": 3_000_000}
        shape = {"plates": "octagon", "impostor": "square", "fragments": fragments}
        # Of a million spheres: 8 plate corners and 4 impostor corners, vertices twice; the encoding blends.
        self.assertEqual(tilers_costs.frame_cost(self.pipelines("spheres"), shape, 10**6, False),
                         8 * (10 + 10) + 1 + 4 * (20 + 20) + 2 * (2 + 5) + 4 * (30 + 20) + 3 * 3)
        # Where outputs are stored: 16, 32 and 52 bytes of twenty instructions; 32 of fetched spheres.
        stored = [8 * (10 + 320) + 1 + 4 * (20 + 640) + 2 * (2 + 5) + 4 * (30 + 20 * size) + 3 * 3 for size in (52, 32)]
        for kind, cost in zip(("spheres", "fetched spheres"), stored):
            self.assertEqual(tilers_costs.frame_cost(self.pipelines(kind), shape, 10**6, True), cost)

    def test_one_frame_of_both_eyes_stands_beside_two(self):
        def entry(vertex, stores):
            numbers = {"vertex": vertex, "fragment": 40}
            return {"stream": {"loads": 0, "stores": stores, "draws": 5},
                    "pipelines": {f"{name}, spheres, {stage}": {"instructions": count + extra}
                                  for extra, name in enumerate(("depth encoding", "impostor colour"))
                                  for stage, count in numbers.items()}}
        rows = {"A": {"paths": {"encoded, an eye": entry(30, 4), "encoded, two eyes": entry(33, 8),
                                "fragdepth, an eye": entry(30, 4), "fragdepth, two eyes": {"lacks": "no multiview"}}}}
        self.assertEqual(tilers_costs.eyes_table(rows)[2:],
                         ["| A | `encoded` | 30, 31; 33, 34 | 40, 41; 40, 41 | 0, 8 B; 0, 8 B | 10; 5 |"])

    def test_a_packaged_mesa_is_compared_with_its_own_version_alone(self):
        def row(mesa, stores):
            entry = {"plan": {"render_passes": 1, "loads": 0, "stores": 4}, "pipelines": {},
                     "stream": {"passes": 1, "loads": 0, "stores": stores, "draws": 1}}
            return {"mesa": mesa, "visibility": "fragdepth", "bake": {}, "paths": {"fragdepth": entry}}
        name = "Apple M1"  # whose driver stores depth besides
        self.assertEqual(tilers.worse(name, row("26.1", 8), row("26.1", 8)), [])
        self.assertEqual(len(tilers.worse(name, row("26.1", 8), row("26.1", 12))), 2)  # by the plan, and by the table
        self.assertEqual(len(tilers.worse(name, row("26.1", 4), row("26.1", 4))), 1)
        self.assertEqual(tilers.worse(name, row("26.1", 8), row("26.2", 12)), [])
        self.assertEqual(len(tilers.worse("Adreno 740", row("25.0", 4), row("25.0", 8))), 2)

    def test_the_pages_are_those_of_the_numbers(self):
        rows = json.loads((TOOLS.parent / "docs/tilers.json").read_text())
        self.assertEqual(list(rows), list(tilers.DEVICES))
        for page, text in tilers.pages(rows).items():
            self.assertEqual((TOOLS.parent / page).read_text(), text, f"{page}: tools/tilers --write")


class Worse(unittest.TestCase):
    def row(self, **stream):
        stream = {"passes": 1, "loads": 0, "stores": 4, "late": 0, "bins": "160x256", "tiles_by_default": True, **stream}
        return {"visibility": "encoded", "bake": {"sums, compute": {"instructions": 5, "loads": stream["stores"]}},
                "paths": {"encoded": {
                    "plan": {"render_passes": stream["passes"], "loads": stream["loads"], "stores": stream["stores"]},
                    "stream": stream, "pipelines": {"colour, fragment": {"instructions": 10 + stream["stores"]}}}}}

    def test_the_same_and_less_are_not_worse(self):
        self.assertEqual(tilers.worse("A", self.row(), self.row()), [])
        self.assertEqual(tilers.worse("A", self.row(stores=8, passes=2), self.row()), [])
        self.assertEqual(tilers.worse("A", self.row(), self.row(bins="320x256")), [])

    def test_every_number_that_grows_is_told(self):
        self.assertEqual(tilers.worse("A", self.row(), self.row(stores=8)),
                         ["A, encoded: stores 4, now 8", "A, encoded, colour, fragment: instructions 14, now 18",
                          "A, bake, sums, compute: loads 4, now 8"])
        for name, value in (("late", 2), ("without_lrz", 1), ("passes", 2), ("loads", 4)):
            found = tilers.worse("A", self.row(), self.row(**{name: value}))
            self.assertEqual(found, [f"A, encoded: {name} {self.row()['paths']['encoded']['stream'].get(name, 0)}, now {value}"])
        self.assertEqual(tilers.worse("A", self.row(), self.row(tiles_by_default=False)),
                         ["A, encoded: drawn past the tiles by default"])
        self.assertEqual(tilers.worse("A", self.row(), self.row(bins="96x256")),
                         ["A, encoded: bins of 160x256, now 96x256"])
        lacking = {**self.row(), "paths": {"encoded": {"lacks": "it ends the program"}}}
        self.assertEqual(tilers.worse("A", self.row(), lacking), ["A, encoded: it ends the program"])
        self.assertEqual(tilers.worse("A", self.row(), {**self.row(), "visibility": "fragdepth"}),
                         ["A: fragdepth by default, in the table encoded"])

    def test_pipelines_are_compared_where_nobody_tells_of_a_stream(self):
        before, now = self.row(), self.row(stores=8)
        for row in (before, now):
            del row["paths"]["encoded"]["stream"]
        self.assertEqual(tilers.worse("A", before, now), ["A, encoded, colour, fragment: instructions 14, now 18",
                                                          "A, bake, sums, compute: loads 4, now 8"])

    def test_nothing_goes_by_being_told_no_more(self):
        now = self.row()
        del now["paths"]["encoded"]["stream"]["late"]
        now["paths"]["encoded"]["pipelines"] = {"colours, fragment": {"instructions": 1}}
        self.assertEqual(tilers.worse("A", self.row(), now),
                         ["A, encoded: late is told no more",
                          "A, encoded, colours, fragment is not in the table: --write",
                          "A, encoded, colour, fragment is told of no more"])

    def test_a_plan_that_is_not_what_the_driver_does_is_told_whatever_the_table_says(self):
        row = self.row(loads=4)
        row["paths"]["encoded"]["plan"] |= {"loads": 0, "render_passes": 2}
        self.assertEqual(tilers.worse("A", row, row),
                         ["A, encoded: loads 4, by the plan 0", "A, encoded: 1 passes, by the plan 2"])


if __name__ == "__main__":
    unittest.main()
