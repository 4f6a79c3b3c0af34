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


def of_gpu_trace(text, pixels, layers=1):
    """From Turnip's MESA_GPU_TRACES: what it says of each render pass, of one of its layers."""
    found = {"loads": 0, "stores": 0, "draws": 0, "passes": 0}
    bins = ""
    for begin, end in re.findall(r"start_render_pass: (.*)[\s\S]*?end_render_pass: (.*)", text):
        values = dict(re.findall(r"(\w+)=([^,]*),", begin + end))
        if int(values["width"]) != pixels:
            continue
        found["passes"] += 1
        found["loads"] += int(values["loadCPP"]) * layers
        found["stores"] += int(values["storeCPP"]) * layers
        found["draws"] += int(values["drawCount"])
        bins = f"{values['binWidth']}x{values['binHeight']}"
    return found | {"bins": bins}


AGX_TEXEL = {"R8G8B8A8": 4, "R32": 4, "R16G16": 4, "R16G16B16A16": 8, "R10G10B10A2": 4}
AGX_LATE = "Punch through"  # the class whose fragments decide by their shader whether they hide others


def of_honeykrisp(text, pixels):
    """From agxdecode. A render pass has a program that loads its tiles' colours and one that stores them; depth has a
    word of its own. Each draw has a class for the removal of hidden surfaces."""
    found = {"loads": 0, "stores": 0, "late": 0, "draws": 0, "passes": 0}
    classes = {}
    for part in re.split(r"(?m)^flags = .*\n(?=vdm_ctrl)", text)[1:]:
        part = re.split(r"(?m)^flags = ", part)[0]
        width = re.search(r"(?m)^width_px = (\d+)", part)
        if not width or int(width[1]) != pixels:
            continue
        found["passes"] += 1
        layers = int(re.search(r"(?m)^layers = (\d+)", part)[1])
        for name, key in (("Load", "loads"), ("Store", "stores")):
            found[key] += 4 * layers * (f"  Z {name}: true" in part)
            program = re.search(rf"(?m)^{name} pipeline .*\n(?:.*\n)*?(?=\w+\.usc = |No preshader)", part)
            found[key] += layers * sum(AGX_TEXEL[c] for c in re.findall(r"(?m)^  Channels: (\w+)", program[0] if program else ""))
        draws = re.split(r"(?m)^ppp_ctrl", part)[0]
        kind = ""
        for of, drawn in re.findall(r"(?m)^Fragment control 2\n(?:  .*\n)*?  Pass type: (.*)$|^(Index List|Draw)$", draws):
            kind = of or kind
            if drawn:
                classes[kind] = classes.get(kind, 0) + 1
    found["draws"], found["late"] = sum(classes.values()), classes.get(AGX_LATE, 0)
    return found | {"classes": classes}


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
    flags = 0
    for word, draw in re.findall(r"(?m)^ *(?:MOVE32 r57, #0x(\w+)|(RUN_IDVS))", text):  # later generations' streams
        flags = int(word, 16) if word else flags
        if draw:
            found["draws"] += 1
            found["late"] += flags >> 4 & 3 == 3
    if found["draws"]:
        return found
    kills = re.findall(r"(?m)^ +ZS update operation: (.*)$", text)
    found["draws"], found["late"] = len(kills), sum("Early" not in k for k in kills)
    return found


LOOKS = ("ball and stick", "cartoons")  # whose pipelines bear their names
WORDS = {"instructions": ("Instruction Count", "Instructions", "instructions"), "loads": ("loads",),
         "registers": ("Max Register Count", "Registers used", "GPRs", "registers"), "spills": ("Spills", "STP Count", "Spill Size", "spills")}


def pipelines_of(records, look):
    """{"impostor colour, spheres, fragment": {"instructions": 202}}; the most of those that share a name. What draws
    every kind of primitive bears the look's name."""
    found = {}
    for record in records:
        if not record["statistics"]:
            continue
        name = record["pipeline"] if "," in record["pipeline"] or look == "spheres" else f"{record['pipeline']} of {look}"
        numbers = found.setdefault(f"{name}, {record['stage']}", {})
        for key, names in WORDS.items():
            value = next((record["statistics"][n] for n in names if n in record["statistics"]), None)
            if value is not None:
                numbers[key] = max(numbers.get(key, 0), value)
    return found


MALI = re.compile(r"SHADER-DB: MESA_SHADER_(\w+) shader: (\d+) inst,.* ([\d.]+) (?:ls|ldst), \d+ quadwords, (\d) threads"
                  r".* (\d+):(\d+) spills")


def of_mali(text):
    """Records of what PanVK's compiler prints of a pipeline, up to where the layer says which it was. Vertices are two
    shaders: positions first, then what they hand on. A shader that has more than half of the 64 registers runs half of
    the threads."""
    made, records = {}, []
    for line in re.split(r"(?m)^nacre pipeline ", text):
        words = line.split("\n", 1)[0].split(" ", 2)
        if words[0] == "named" and words[1] in made:
            records += [{"pipeline": words[2], "stage": stage, "statistics": numbers}
                        for stage, numbers in made[words[1]].items()]
        if words[0] != "made":
            shaders = {}
            for stage, count, loads, threads, spills, fills in MALI.findall(line):
                stage = {"FRAGMENT": "fragment", "COMPUTE": "compute"}.get(stage, "vertex")
                numbers = shaders.setdefault(stage, {"instructions": 0, "loads": 0, "registers": 0, "spills": 0})
                numbers["instructions"] += int(count)
                numbers["loads"] += round(float(loads))
                numbers["registers"] = max(numbers["registers"], 64 // int(threads))
                numbers["spills"] += int(spills) + int(fills)
            last = shaders
        else:
            made[words[1]] = last
    return records


def blending_of_mali(text):
    """Blending that is a shader, which is made as it is drawn with: the encoding's MIN."""
    counts = [int(count) for stage, count, *_ in MALI.findall(text) if stage == "BLEND"]
    return {"depth encoding, blending, fragment": {"instructions": max(counts)}} if counts else {}


DEVICES_HEAD = """# Drivers of tilers, device by device

Generated by `tools/tilers --write`. [The frame on drivers of tilers](tilers.md) explains the columns and compares the devices.

"""
FEATURES = ("lazy_memory", "timestamps", "merge_feedback")


def written_into(page, tables):
    """A page of Markdown with each of these tables behind the comment of its name."""
    for name, lines in tables.items():
        before, marker, after = page.partition(f"<!-- {name} -->\n")
        if not marker:
            raise ValueError(f"the page has no place for the table of {name}")
        page = before + marker + "\n".join(lines) + "\n" + re.sub(r"\A(\|.*\n)*", "", after)
    return page


def devices_page(rows):
    """A page of Markdown with each device by itself."""
    return DEVICES_HEAD + "\n".join(line for name, row in rows.items() for line in device_page(name, row))


def instructions(row, path, *pipelines):
    """Of pipelines' fragments in a path, "39 + 12" where several are told."""
    found = [row["paths"].get(path, {}).get("pipelines", {}).get(f"{p}, fragment") for p in pipelines]
    return " + ".join(str(n["instructions"]) for n in found if n)


def summary(rows):
    lines = ["| device | path by default | encoded depth | render passes; loads, stores per pixel | "
             "late depth tests: `encoded`, `fragdepth` | instructions of a sphere: encoding, colour | of a stick |",
             "|---" * 7 + "|"]
    for name, row in rows.items():
        path = row["visibility"]
        plan = row["paths"][path]["plan"]
        late = ", ".join(f"{s['late']} of {s['draws']}" if "late" in s else "not told"
                         for s in (row["paths"][p].get("stream", {}) for p in ("encoded", "fragdepth")))
        costs = [f"{instructions(row, 'encoded', f'depth encoding, {kind}', 'depth encoding, blending')}; "
                 f"{instructions(row, path, f'impostor colour, {kind}') or instructions(row, path, f'impostor colour, fetched {kind}')}"
                 for kind in ("spheres", "cylinders")]
        lines.append(f"| {name} | `{path}` | {row['encoded_format']} | {plan['render_passes']}; {plan['loads']}, "
                     f"{plan['stores']} B | {late} | {costs[0]} | {costs[1]} |")
    return lines


def device_page(name, row):
    has = [f.replace("_", " ") for f in FEATURES if row["features"][f]]
    lines = [f"## {name} ({row['driver']})", "", f"`{row['visibility']}` by default: {row['why']}. Render passes by "
             f"{'dynamic rendering' if row['dynamic_rendering'] else 'VkRenderPass'}. Vulkan "
             f"{row['features']['api_version']}; has {', '.join(has) or 'none'} of "
             f"{', '.join(f.replace('_', ' ') for f in FEATURES)}.", "",
             "| path | plan: passes, loads, stores | driver: passes, loads, stores | late depth tests | bins |",
             "|---|---|---|---|---|"]
    pipelines = dict(row["bake"])
    for path, entry in row["paths"].items():
        if "lacks" in entry:
            lines.append(f"| {path} | {entry['lacks']} | | | |")
            continue
        plan, stream = entry["plan"], entry.get("stream")
        if path in (row["visibility"], "encoded"):  # docs/tilers.json has the others
            pipelines |= {f"{path}: {n}": v for n, v in entry["pipelines"].items()}
        planned = f"{plan['render_passes']}, {plan['loads']}, {plan['stores']} B"
        if not stream:
            lines.append(f"| {path} | {planned} | not told | | |")
            continue
        bins = stream.get("bins", "") + ("" if stream.get("tiles_by_default", True) else "; none by default")
        late = f"{stream['late']} of {stream['draws']}" if "late" in stream else "not told"
        late += "".join(f"; {n} {kind.lower()}" for kind, n in stream.get("classes", {}).items())
        late += f"; {stream['without_lrz']} without LRZ" if "without_lrz" in stream else ""
        local = stream.get("without_lrz_by_local_reads")
        late += "" if local is None else f" ({local} with local reads)"
        lines.append(f"| {path} | {planned} | {stream['passes']}, {stream['loads']}, {stream['stores']} B | {late} | {bins} |")
    return [*lines, "", *pipeline_table(pipelines), ""]


def pipeline_table(pipelines):
    """Instructions of both stages, registers and spills of the worse one; a line for all the paths that have the same."""
    stages = {}
    for name, numbers in pipelines.items():
        path, _, rest = name.rpartition(": ")
        pipeline, _, stage = rest.rpartition(", ")
        stages.setdefault((path, pipeline), {})[stage] = numbers
    same = {}
    for (path, pipeline), of in stages.items():
        counts = tuple(of[s]["instructions"] if s in of else "" for s in ("vertex", "fragment", "compute"))
        most = tuple(max((n[k] for n in of.values() if k in n), default="") for k in ("registers", "spills"))
        for look in LOOKS:  # which need no line where they change nothing
            plain = pipeline.removesuffix(f" of {look}")
            pipeline = plain if (plain, counts + most) in same else pipeline
        paths = same.setdefault((pipeline, counts + most), [])
        if path not in paths:
            paths.append(path)
    lines = ["| pipeline | of | vertex | fragment | compute | registers | spills |", "|---" * 7 + "|"]
    lines += [f"| {pipeline} | {', '.join(p for p in paths if p) or 'bake'} | {' | '.join(str(v) for v in values)} |"
              for (pipeline, values), paths in sorted(same.items(), key=lambda s: s[0][0])]
    return lines
