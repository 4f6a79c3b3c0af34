"""check_usdz.py FILE.usdz: checks a package by the rules of usdchecker and of the USDZ specification, and prints what stands
in it as JSON. Exits with 1 at the first rule that is broken. Reads archive, picture and text with Python's own modules.
"""

import json
import re
import struct
import sys
import zipfile
import zlib

KINDS = {"usda", "usdc", "usd", "png", "jpg", "jpeg", "exr", "avif", "m4a", "mp3", "wav"}
PRIMS = {"Xform", "Scope", "Mesh", "Material", "Shader"}
SHADERS = {"UsdPreviewSurface", "UsdUVTexture", "UsdPrimvarReader_float2", "UsdTransform2d"}
TOKEN = re.compile(r'\s*("[^"\\]*"|@[^@]*@|<[^<>]*>|[A-Za-z_][\w:.]*(?:\[\])?|[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?|[()\[\]{}=,])')


def require(condition, why):
    if not condition:
        sys.exit(f"{sys.argv[1]}: {why}")


class Layer:
    """The part of the text format that a scene of meshes needs; anything else is an error."""

    def __init__(self, text):
        require(text.startswith("#usda 1.0\n"), "the layer does not begin with #usda 1.0")
        self.tokens, at, text = [], 0, text[len("#usda 1.0\n"):].rstrip()
        while at < len(text):
            found = TOKEN.match(text, at)
            require(found, f"not the text format: {text[at:at + 40]!r}")
            self.tokens.append(found[1])
            at = found.end()
        self.at, self.prims = 0, {}
        self.metadata = self.fields()
        while self.at < len(self.tokens):
            self.prim("")

    def next(self, expected=None):
        require(self.at < len(self.tokens), "the layer ends too early")
        token = self.tokens[self.at]
        require(expected is None or token == expected, f"{token!r} in place of {expected!r}")
        self.at += 1
        return token

    def peek(self):
        return self.tokens[self.at] if self.at < len(self.tokens) else None

    def value(self):
        token = self.next()
        if token in ("[", "("):
            end, values = {"[": "]", "(": ")"}[token], []
            while self.peek() != end:
                values.append(self.value())
                if self.peek() != end:
                    self.next(",")
            self.next(end)
            return values
        require(token not in ("]", ")", "{", "}", "=", ","), f"{token!r} is no value")
        return token[1:-1] if token[0] in '"<@' else float(token) if token[0] in "+-0123456789" else token

    def fields(self):
        found = {}
        if self.peek() == "(":
            self.next()
            while self.peek() != ")":
                name = self.next()
                if name == "prepend":
                    name = self.next()
                self.next("=")
                found[name] = self.value()
            self.next()
        return found

    def prim(self, parent):
        self.next("def")
        kind = self.next()
        path = f"{parent}/{self.next()[1:-1]}"
        require(re.fullmatch(r"(/[A-Za-z_]\w*)+", path), f"{path} is no path")
        require(path not in self.prims, f"{path} stands there twice")
        prim = self.prims[path] = {"kind": kind, "metadata": self.fields(), "interpolation": {}}
        self.next("{")
        while self.peek() != "}":
            if self.peek() == "def":
                self.prim(path)
                continue
            words = [self.next()]
            while re.match(r"[A-Za-z_]", self.peek()) and len(words) < 3:
                words.append(self.next())
            if self.peek() == "=":
                self.next()
                prim[words[-1]] = self.value()
            prim["interpolation"][words[-1]] = self.fields().get("interpolation")
        self.next("}")


def checked_archive(path):
    with open(path, "rb") as file:
        data = file.read()
    with zipfile.ZipFile(path) as archive:
        require(archive.testzip() is None, "a checksum is wrong")
        files = {}
        for info in archive.infolist():
            require(info.compress_type == zipfile.ZIP_STORED, f"{info.filename} is compressed")
            require(info.flag_bits & 1 == 0, f"{info.filename} is encrypted")
            name, extra = struct.unpack("<HH", data[info.header_offset + 26:info.header_offset + 30])
            start = info.header_offset + 30 + name + extra
            require(start % 64 == 0, f"{info.filename} begins at byte {start}")
            fields = data[start - extra:start]
            while fields:
                require(len(fields) >= 4, f"{info.filename}: the extra field is cut off")
                fields = fields[4 + struct.unpack("<H", fields[2:4])[0]:]
            require(info.filename.rsplit(".")[-1] in KINDS, f"{info.filename} is of no kind that a package may have")
            files[info.filename] = data[start:start + info.file_size]
    return files


def pixels_of(png):
    """Rows of RGB. Knows the filter "up" alone."""
    require(png[:8] == b"\x89PNG\r\n\x1a\n", "the texture is no PNG")
    at, packed, size = 8, b"", (0, 0)
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        body = png[at + 8:at + 8 + length]
        require(zlib.crc32(kind + body) == struct.unpack(">I", png[at + 8 + length:at + 12 + length])[0], f"{kind}: checksum")
        if kind == b"IHDR":
            size = struct.unpack(">II", body[:8])
            require(body[8:] == b"\x08\x02\0\0\0", "the texture is not 8-bit RGB")
        packed += body if kind == b"IDAT" else b""
        at += 12 + length
    raw, row = zlib.decompress(packed), size[0] * 3 + 1
    require(len(raw) == row * size[1] and set(raw[::row]) == {2}, "the texture has another size or filter than expected")
    rows = [bytes(row - 1)]
    for y in range(size[1]):
        rows.append(bytes(a + b & 255 for a, b in zip(rows[-1], raw[y * row + 1:(y + 1) * row])))
    return rows[1:], size


def color_at(rows, size, st):
    """Mean of the 2 x 2 pixels about a place, v upward; they must agree."""
    x, y = st[0] * size[0], (1 - st[1]) * size[1]
    near = {bytes(rows[int(y + dy)][3 * int(x + dx):3 * int(x + dx) + 3]) for dx in (-0.5, 0.5) for dy in (-0.5, 0.5)}
    require(len(near) == 1, f"a filter mixes colours at {st}")
    return near.pop().hex()


def checked_mesh(path, mesh, rows, size):
    points, corners = mesh["points"], [int(i) for i in mesh["faceVertexIndices"]]
    require(mesh["subdivisionScheme"] == "none", f"{path} would be subdivided")
    require(all(n == 3 for n in mesh["faceVertexCounts"]), f"{path}: not only triangles")
    require(len(corners) == 3 * len(mesh["faceVertexCounts"]), f"{path}: corners and faces disagree")
    require(set(corners) == set(range(len(points))), f"{path}: vertices without a face, or faces without a vertex")
    require(len(mesh["normals"]) == len(points) and mesh["interpolation"]["normals"] == "vertex", f"{path}: normals")
    require(all(abs(sum(v * v for v in n) - 1) < 1e-3 for n in mesh["normals"]), f"{path}: a normal is not of length 1")
    bounds = [[side(p[i] for p in points) for i in range(3)] for side in (min, max)]
    require(mesh["extent"] == bounds, f"{path}: extent {mesh['extent']}, points {bounds}")
    require(mesh["interpolation"]["primvars:st"] == "faceVarying", f"{path}: texture coordinates")
    places = [int(i) for i in mesh["primvars:st:indices"]]
    require(len(places) == len(corners), f"{path}: texture coordinates and corners disagree")
    colors = [color_at(rows, size, st) for st in mesh["primvars:st"]]
    count = {}
    for i in places[::3]:
        count[colors[i]] = count.get(colors[i], 0) + 1
    volume = 0
    for i in range(0, len(corners), 3):
        a, b, c = (points[k] for k in corners[i:i + 3])
        volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                   a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
    return {"triangles": len(corners) // 3, "volume": volume, "colors": count}


def main():
    files = checked_archive(sys.argv[1])
    root = next(iter(files))
    require(root.endswith(".usda"), f"{root} comes first, which is no root layer")
    layer = Layer(files[root].decode("utf-8"))
    require(layer.metadata.get("upAxis") in ("Y", "Z"), "no upAxis")
    require(layer.metadata.get("metersPerUnit", 0) > 0, "no metersPerUnit")
    top = [path for path in layer.prims if path.count("/") == 1]
    require(top == ["/" + layer.metadata.get("defaultPrim", "")], f"defaultPrim does not name the only root, {top}")
    pictures = {name: pixels_of(data) for name, data in files.items() if name.endswith(".png")}
    require(len(files) == 1 + len(pictures), "a file that is neither layer nor texture")
    parts, used = [], set()
    for path, prim in layer.prims.items():
        require(prim["kind"] in PRIMS, f"{path} is a {prim['kind']}")
        for name, target in prim.items():
            if name.endswith(".connect") or name == "material:binding":
                owner, _, output = target.partition(".")
                require(owner in layer.prims, f"{path}: {name} leads to {target}")
                require(not output or output in layer.prims[owner]["interpolation"], f"{path}: {name} leads to {target}")
        if prim["kind"] == "Shader":
            require(prim.get("info:id") in SHADERS, f"{path}: shader {prim.get('info:id')}")
        if "inputs:file" in prim:
            require(prim["inputs:file"] in pictures, f"{path}: no file {prim['inputs:file']}")
            used.add(prim["inputs:file"])
        if "material:binding" in prim:
            require("MaterialBindingAPI" in prim["metadata"].get("apiSchemas", []), f"{path}: no MaterialBindingAPI")
            require(layer.prims[prim["material:binding"]]["kind"] == "Material", f"{path}: no material")
        if prim["kind"] != "Mesh":
            continue
        parent = layer.prims[path.rsplit("/", 1)[0]]
        source = prim["metadata"].get("references", path)
        require(layer.prims.get(source, {}).get("kind") == "Mesh", f"{path}: no mesh {source}")
        parts.append(checked_mesh(source, layer.prims[source], *next(iter(pictures.values()))))
        surface = layer.prims[layer.prims[parent["material:binding"]]["outputs:surface.connect"].partition(".")[0]]
        parts[-1].update(name=path, opacity=surface["inputs:opacity"], transform=parent.get("xformOp:transform"))
    require(used == set(pictures), "a texture that no material has")
    print(json.dumps({"parts": parts, "metersPerUnit": layer.metadata["metersPerUnit"],
                      "scale": layer.prims[top[0]]["xformOp:scale"], "translate": layer.prims[top[0]]["xformOp:translate"]}))


main()
