"""Reads what Mesa's drivers of tilers wrote: attachments that tiles load and store, depth tests, bins. For tools/tilers."""

import math
import re

TEXEL = {"8_8_8_8": 4, "32_FLOAT": 4, "32_UINT": 4, "16_16_16_16": 8, "16_16_FLOAT": 4, "10_10_10_2": 4, "32_32": 8, "8_UNORM": 1,
         "Z24": 4}


def bytes_of(name):
    for part, size in TEXEL.items():
        if part in name:
            return size
    raise ValueError(f"a format that nobody told of: {name}")


def of_turnip(text, pixels):
    """From cffdump. Each tile's commands are there; each counts as its share of the picture."""
    total = {"loads": 0.0, "stores": 0.0, "late": 0, "without_lrz": 0, "draws": 0}
    bins = bin_size = None
    share = 0.0  # of the tiles of a render pass that have been seen
    inside, kind, size, late, lrz, first, target = False, "", 0, False, False, False, 0
    passes = 0
    for line in text.splitlines():
        if m := re.search(r"RB_BIN_CONTROL: { BINW = (\d+) \| BINH = (\d+) \| RENDER_MODE = RENDERING", line):
            bin_size = (int(m[1]), int(m[2]))
            bins = math.ceil(pixels / bin_size[0]) * math.ceil(pixels / bin_size[1])
        elif m := re.search(r"RB_BLIT_SCISSOR_BR: { X = (\d+)", line):
            target = int(m[1]) + 1
        elif "MODE = RM6_BIN_RENDER_START" in line:
            inside, first = True, share % 1 < 1e-6
        elif "MODE = RM6_BIN_RENDER_END" in line and inside and bins:
            inside = False
            passes += first
            share = round((share + 1 / bins) * bins) / bins
        elif m := re.search(r"COLOR_FORMAT = (FMT6_\w+)", line) if "RB_BLIT_DST_INFO" in line else None:
            size = bytes_of(m[1])
        elif m := re.search(r"RB_BLIT_INFO: { TYPE = BLIT_EVENT_(\w+)", line):
            kind = m[1]
        elif line.strip() == "event BLIT" and inside and target == pixels:
            key = {"LOAD": "loads", "STORE": "stores"}.get(kind)
            if key:
                total[key] += size / bins
        elif m := re.search(r"GRAS_SU_DEPTH_PLANE_CNTL: { Z_MODE = A6XX_(\w+)", line):
            late = m[1] != "EARLY_Z"
        elif "GRAS_LRZ_CNTL: {" in line or "GRAS_LRZ_CNTL: 0" in line:
            lrz = "ENABLE" in line.split("GRAS_LRZ_CNTL:")[1].split("|")[0]
        elif "opcode: CP_DRAW_INDX" in line and inside and first:
            total["draws"] += 1
            total["late"] += late
            total["without_lrz"] += not lrz
    found = {k: round(v) for k, v in total.items()}
    return found | {"bins": f"{bin_size[0]}x{bin_size[1]}" if bin_size else "", "passes": passes}


V3D_DRAWS = ("VERTEX_ARRAY_PRIMS", "VERTEX_ARRAY_INSTANCED_PRIMS", "INDEXED_INSTANCED_PRIM_LIST")
V3D_TEXEL = {"srgb8_alpha8": 4, "rgba8": 4, "d32f": 4, "r32f": 4, "rgba16f": 8, "rg16f": 4, "r32ui": 4, "rgb10_a2": 4}


def of_v3dv(text, pixels):
    """From V3D_DEBUG=cl_nobin: the commands that every tile carries out. A job a subpass."""
    found = {"loads": 0, "stores": 0, "late": 0, "draws": 0, "passes": 0}
    for job in text.split("@add_render")[:-1]:
        packets = [(m[1], dict(re.findall(r"(?m)^    ([^:\n]+): (.*)$", m[2])))
                   for m in re.finditer(r"(?m)^([A-Z][A-Z0-9_]+)\n((?:    .*\n)*)", job)]
        widths = [int(v["Image Width (pixels)"]) for n, v in packets if n == "TILE_RENDERING_MODE_CFG_COMMON"]
        bits = [v["Early Z enable"] for n, v in packets if n == "CFG_BITS" and "Early Z enable" in v]
        draws = sum(n in V3D_DRAWS for n, _ in packets)
        if widths[:1] != [pixels] or draws == 0:
            continue  # copies to and fro
        found["passes"] += 1
        found["draws"] += draws
        if not bits:  # generation 7 decides for itself
            found.pop("late", None)
        else:
            found["late"] += sum(b.startswith("0") for b in bits)
        for name, values in packets:
            where = values.get("Buffer to Store" if name == "STORE" else "Buffer to Load", "None")
            if name in ("LOAD", "STORE") and "None" not in where:
                format = values["Output Image Format" if name == "STORE" else "Input Image Format"]
                found["loads" if name == "LOAD" else "stores"] += V3D_TEXEL[re.search(r"/\* (\w+) \*/", format)[1]]
    return found


def of_panvk(text, pixels):
    """From pandecode. A framebuffer a subpass; what it loads it draws before the frame."""
    found = {"loads": 0, "stores": 0, "late": 0, "draws": 0, "passes": 0}
    # Each framebuffer is there once by itself; what it holds is indented.
    for part in re.split(r"(?m)^Framebuffer @", text)[1:]:
        values = re.findall(r"(?m)^ *([A-Z][\w ]+): (.*)$", part)
        get = lambda name: next((v for n, v in values if n == name), "")
        if get("Width") and int(get("Width")) != pixels:
            continue
        found["passes"] += 1
        depth = 4
        if get("Z Write Enable") == "true" and get("ZS Writeback Base") not in ("", "0x0"):
            found["stores"] += depth
        for target in re.split(r"Color Render Target \d+:", part)[1:]:
            format = re.search(r"Writeback Format: (\w+)", target)
            written = re.search(r"(?<!Pixel )(?<!CRC )Write Enable: true", target)
            if written and format:
                found["stores"] += {"RAW32": 4, "RAW64": 8, "RAW16": 2}.get(format[1], 4)
        if get("Z Preload Enable") == "true":
            found["loads"] += depth
        for frame, name in (("Pre Frame 0", "colour"), ("Pre Frame 1", "depth")):
            if get(frame) not in ("", "Never"):
                found["loads"] += depth
    if not found["passes"]:  # Mali's command streams of later generations, which are decoded no further
        return {"passes": len(re.findall(r"(?m)^ *RUN_FRAGMENT", text)), "draws": len(re.findall(r"(?m)^ *RUN_IDVS", text))}
    kills = re.findall(r"(?m)^ +ZS update operation: (.*)$", text)
    found["draws"], found["late"] = len(kills), sum("Early" not in k for k in kills)
    return found


WORDS = {"instructions": ("Instruction Count",), "code_bytes": ("Code Size",),
         "registers": ("Max Register Count", "Registers used"), "spills": ("STP Count", "Spill Size")}


def pipelines_of(records):
    """{"impostor colour, spheres, fragment": {"instructions": 202}}; the most of those that share a name."""
    found = {}
    for record in records:
        numbers = found.setdefault(f"{record['pipeline']}, {record['stage']}", {})
        for key, names in WORDS.items():
            value = next((record["statistics"][n] for n in names if n in record["statistics"]), None)
            if value is not None:
                numbers[key] = max(numbers.get(key, 0), value)
    return found


def table(rows):
    """The numbers as a page of Markdown."""
    lines = []
    for name, row in rows.items():
        lines += [f"## {name} ({row['driver']})", "", f"Path by default: `{row['visibility']}`: {row['why']}. Encoded depth "
                  f"{row['encoded_format']}; render passes by "
                  f"{'dynamic rendering' if row['dynamic_rendering'] else 'VkRenderPass'}.", "",
                  "| path | plan: passes, loads, stores | driver: passes, loads, stores | late depth tests | bins | "
                  "fragment instructions |", "|---|---|---|---|---|---|"]
        for path, entry in row["paths"].items():
            if "lacks" in entry:
                lines.append(f"| {path} | {entry['lacks']} | | | | |")
                continue
            plan, stream = entry["plan"], entry["stream"]
            fragments = ", ".join(f"{p.rsplit(', ', 1)[0]} " + (f"{n['instructions']}" if "instructions" in n else f"{n['code_bytes']} B") +
                                  (f" ({n['spills']} spilled)" if n.get("spills") else "")
                                  for p, n in entry["pipelines"].items() if p.endswith("fragment") and n)
            bins = stream.get("bins", "") + ("" if stream.get("tiles_by_default", True) else "; none by default")
            late = f"{stream['late']} of {stream['draws']}" if "late" in stream else "not told"
            late += f"; {stream['without_lrz']} without LRZ" if "without_lrz" in stream else ""
            written = f"{stream['loads']}, {stream['stores']} B" if "loads" in stream else "not told"
            lines.append(f"| {path} | {plan['render_passes']}, {plan['loads']}, {plan['stores']} B | {stream['passes']}, "
                         f"{written} | {late} | {bins} | {fragments} |")
        lines.append("")
    return "\n".join(lines)
