#include "tests/frame/choices.h"

#include <sstream>

namespace nacre::test {

std::string withoutMotion(const std::string& table) {
    std::istringstream lines(table);
    std::string kept;
    for (std::string line; std::getline(lines, line);)
        if (!line.starts_with("motion:")) kept += line + "\n";
    return kept;
}

const std::map<std::string, std::string>& statedChoices() {
    static const std::map<std::string, std::string> stated{
        {"encoded",
         "edges: encoded, 1 per pixel, then 16 in blocks where colours change, picture, read back: plain, outlines, "
         "shadow, translucency, lens, fine\n"
         "edges: deferred, 1 per pixel, then 16 in blocks where colours change, picture, read back: outlines by "
         "groups, halos\n"
         "edges: encoded, 16 per pixel, in blocks, picture: thin shapes\n"
         "edges: encoded, 1 per pixel, read back: debug view\n"
         "one sample: encoded, 1 per pixel, read back: plain, outlines, shadow, translucency, fine, thin shapes, debug "
         "view\n"
         "one sample: deferred, 1 per pixel, read back: outlines by groups, halos\n"
         "one sample: encoded, 1 per pixel, picture: lens\n"
         "3 x 3: encoded, 9 per pixel, read back: plain, outlines, shadow, translucency, fine, thin shapes, debug "
         "view\n"
         "3 x 3: deferred, 9 per pixel, read back: outlines by groups, halos\n"
         "3 x 3: encoded, 9 per pixel, picture: lens\n"
         "edge frame: encoded, 16 at edges, picture: plain, outlines, shadow, translucency, lens, fine, thin shapes, "
         "debug view\n"
         "edge frame: deferred, 16 at edges, picture: outlines by groups, halos\n"
         "block: encoded, 16 per pixel, picture: plain, outlines, shadow, translucency, lens, fine, thin shapes, debug "
         "view\n"
         "block: deferred, 16 per pixel, picture: outlines by groups, halos\n"
         "distances: encoded, 1 per pixel, read back\n"
         "layers: encoded, 1 per pixel, read back\n"
         "pick: encoded, 1 per pixel, read back\n"
         "sample: encoded, 1 per pixel, sample of a window: plain, outlines, shadow, translucency, lens, fine, thin "
         "shapes, debug view\n"
         "sample: deferred, 1 per pixel, sample of a window: outlines by groups, halos\n"},
        {"raster-order",
         "edges: raster-order, 1 per pixel, then 16 in blocks where colours change, picture, read back: plain, "
         "outlines, shadow, translucency, lens, fine\n"
         "edges: deferred, 1 per pixel, then 16 in blocks where colours change, picture, read back: outlines by "
         "groups, halos\n"
         "edges: raster-order, 16 per pixel, in blocks, picture: thin shapes\n"
         "edges: fragdepth, 1 per pixel, read back: debug view\n"
         "one sample: raster-order, 1 per pixel, read back: plain, outlines, shadow, translucency, fine, thin shapes\n"
         "one sample: deferred, 1 per pixel, read back: outlines by groups, halos\n"
         "one sample: raster-order, 1 per pixel, picture: lens\n"
         "one sample: fragdepth, 1 per pixel, read back: debug view\n"
         "3 x 3: raster-order, 9 per pixel, read back: plain, outlines, shadow, translucency, fine, thin shapes\n"
         "3 x 3: deferred, 9 per pixel, read back: outlines by groups, halos\n"
         "3 x 3: raster-order, 9 per pixel, picture: lens\n"
         "3 x 3: fragdepth, 9 per pixel, read back: debug view\n"
         "edge frame: raster-order, 16 at edges, picture: plain, outlines, shadow, translucency, lens, fine, thin "
         "shapes\n"
         "edge frame: deferred, 16 at edges, picture: outlines by groups, halos\n"
         "edge frame: fragdepth, 16 at edges, picture: debug view\n"
         "block: raster-order, 16 per pixel, picture: plain, outlines, shadow, translucency, lens, fine, thin shapes\n"
         "block: deferred, 16 per pixel, picture: outlines by groups, halos\n"
         "block: fragdepth, 16 per pixel, picture: debug view\n"
         "distances: raster-order, 1 per pixel, read back\n"
         "layers: raster-order, 1 per pixel, read back\n"
         "pick: raster-order, 1 per pixel, read back\n"
         "sample: raster-order, 1 per pixel, sample of a window: plain, outlines, shadow, translucency, lens, fine, "
         "thin shapes\n"
         "sample: deferred, 1 per pixel, sample of a window: outlines by groups, halos\n"
         "sample: fragdepth, 1 per pixel, sample of a window: debug view\n"},
        {"fragdepth",
         "edges: fragdepth, 1 per pixel, then 16 in blocks where colours change, picture, read back: plain, outlines, "
         "shadow, translucency, lens, fine\n"
         "edges: deferred, 1 per pixel, then 16 in blocks where colours change, picture, read back: outlines by "
         "groups, halos\n"
         "edges: fragdepth, 16 per pixel, in blocks, picture: thin shapes\n"
         "edges: fragdepth, 1 per pixel, read back: debug view\n"
         "one sample: fragdepth, 1 per pixel, read back: plain, outlines, shadow, translucency, fine, thin shapes, "
         "debug view\n"
         "one sample: deferred, 1 per pixel, read back: outlines by groups, halos\n"
         "one sample: fragdepth, 1 per pixel, picture: lens\n"
         "3 x 3: fragdepth, 9 per pixel, read back: plain, outlines, shadow, translucency, fine, thin shapes, debug "
         "view\n"
         "3 x 3: deferred, 9 per pixel, read back: outlines by groups, halos\n"
         "3 x 3: fragdepth, 9 per pixel, picture: lens\n"
         "edge frame: fragdepth, 16 at edges, picture: plain, outlines, shadow, translucency, lens, fine, thin shapes, "
         "debug view\n"
         "edge frame: deferred, 16 at edges, picture: outlines by groups, halos\n"
         "block: fragdepth, 16 per pixel, picture: plain, outlines, shadow, translucency, lens, fine, thin shapes, "
         "debug view\n"
         "block: deferred, 16 per pixel, picture: outlines by groups, halos\n"
         "distances: fragdepth, 1 per pixel, read back\n"
         "layers: fragdepth, 1 per pixel, read back\n"
         "pick: fragdepth, 1 per pixel, read back\n"
         "sample: fragdepth, 1 per pixel, sample of a window: plain, outlines, shadow, translucency, lens, fine, thin "
         "shapes, debug view\n"
         "sample: deferred, 1 per pixel, sample of a window: outlines by groups, halos\n"},
        {"software",
         "edges: tiles by compute, 16 at edges, read back: plain, outlines, shadow, thin shapes\n"
         "edges: tiles by compute, 1 per pixel, then 16 in blocks where colours change, picture, read back: outlines "
         "by groups, halos\n"
         "edges: tiles, 1 per pixel, then 16 in blocks where colours change, picture, read back: translucency\n"
         "edges: tiles by compute, 16 at edges, picture: lens\n"
         "edges: tiles, 16 at edges, read back: fine\n"
         "edges: tiles, 1 per pixel, read back: debug view\n"
         "one sample: tiles by compute, 1 per pixel, read back: plain, outlines, outlines by groups, halos, shadow, "
         "thin shapes\n"
         "one sample: tiles, 1 per pixel, read back: translucency, fine, debug view\n"
         "one sample: tiles by compute, 1 per pixel, picture: lens\n"
         "3 x 3: tiles by compute, 9 per pixel, read back: plain, outlines, outlines by groups, halos, shadow, thin "
         "shapes\n"
         "3 x 3: tiles, 9 per pixel, read back: translucency, fine, debug view\n"
         "3 x 3: tiles by compute, 9 per pixel, picture: lens\n"
         "edge frame: tiles by compute, 16 at edges, picture: plain, outlines, outlines by groups, halos, shadow, "
         "lens, thin shapes\n"
         "edge frame: tiles, 16 at edges, picture: translucency, fine, debug view\n"
         "block: tiles by compute, 16 per pixel, picture: plain, outlines, outlines by groups, halos, shadow, lens, "
         "thin shapes\n"
         "block: tiles, 16 per pixel, picture: translucency, fine, debug view\n"
         "distances: tiles, 1 per pixel, read back\n"
         "layers: tiles, 1 per pixel, read back\n"
         "pick: tiles, 1 per pixel, read back\n"
         "sample: tiles, 1 per pixel, sample of a window: plain, outlines, shadow, translucency, lens, fine, thin "
         "shapes, debug view\n"
         "sample: deferred, 1 per pixel, sample of a window: outlines by groups, halos\n"},
    };
    return stated;
}

}  // namespace nacre::test
