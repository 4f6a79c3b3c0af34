#pragma once
// Text of --help below the options.

namespace nacre::app {

inline constexpr const char* kExamples =
    "Examples:\n"
    "  nacre render sample:dna -o dna.png\n"
    "  nacre render pdb:4hhb -o blood.png --color chain\n"
    "  nacre movie pdb:4hhb -o blood.mp4 --spin y\n"
    "  nacre info 4hhb.cif.gz --json\n"
    "  nacre devices\n"
    "`nacre render --help` lists all options; `nacre help TOPIC` explains selections, colors, styles, labels,\n"
    "interactions, maps, formats, views, light and devices; `nacre help OPTION` explains an option.\n"
    "Environment variables for drivers in doubt; the picture stays the same:\n"
    "  NACRE_NO_MERGE=1      each pass is a render pass of its own\n"
    "  NACRE_NO_TRANSIENT=1  each attachment has memory and is stored\n"
    "Environment variables for downloads:\n"
    "  NACRE_CACHE=DIR|off   same as --cache\n"
    "  NACRE_PDB_URL, NACRE_PUBCHEM_URL, NACRE_AFDB_URL  other servers: URL/1bna.bcif.gz, URL/1bna.cif.gz;\n"
    "                        URL/compound/cid/2244/record/SDF?record_type=3d; URL/api/prediction/P69905\n"
    "  NACRE_DOWNLOAD_TIMEOUT=SECONDS  limit to connect, and to wait for data [30]\n"
    "  NACRE_CA_FILE=FILE    trusted certificates (PEM) instead of the system's\n"
    "  https_proxy, no_proxy  as for curl";
inline constexpr const char* kMovieExamples =
    "Examples:\n"
    "  nacre movie 4hhb.cif.gz -o blood.mp4 --spin y --color chain --supersample 2\n"
    "  nacre movie sample:dna -o dna.gif --rock 30 --size 400x600 --fps 25\n"
    "  nacre movie 2koc.cif.gz -o ensemble.webm --models --seconds 4 --style licorice\n"
    "  nacre movie -o flight.mp4 --views whole.json,pocket.json,ligand.json --seconds 8\n"
    "  nacre movie 1crn.pdb -o frames/ --spin 1,1,0 --seconds 10 --fps 24";
inline constexpr const char* kExportExamples =
    "Examples:\n"
    "  nacre export 4hhb.cif.gz -o blood.glb --style cartoon\n"
    "  nacre export 1crn.pdb -o crambin.stl --style surface --surface gaussian --cavities hide --scale 2\n"
    "  nacre export sample:dna -o dna.glb --atoms instanced --stats -";
inline constexpr const char* kRenderExamples =
    "Examples:\n"
    "  nacre render 1bna.pdb -o dna.png --size 1600x1200 --supersample 2\n"
    "  nacre render sample:glucose -o glucose.png --style ball-and-stick --background transparent\n"
    "  nacre render 4hhb.cif.gz -o blood.jpg --color chain --rotate -20,45,0 --projection perspective\n"
    "  nacre render 4hhb.pdb -o haem.png --color chain --show ligand=ball-and-stick --color-by ligand=element:orange\n"
    "  nacre render 3j6r.pdb.gz -o capsid.png --assembly 1 --color copy --occlusion 32\n"
    "  nacre render 1hpv.pdb -o drug.png --look-at ligand --zoom-to ligand --color chain-carbons --legend on \\\n"
    "    --label ligand=amprenavir --measure 1519,1525 --scale-bar angstrom\n"
    "  nacre render 1hpv.pdb -o pocket.png --style licorice --show ligand=ball-and-stick \\\n"
    "    --hide 'not byres (within 5 of (ligand))'\n"
    "  nacre render open=4ake.cif closed=1ake.cif -o pair.png --fit '/closed and name CA' '/open and name CA'\n"
    "  nacre render 1crn.pdb -o crambin.png --capture crambin.rdc\n"
    "  zcat 1crn.pdb.gz | nacre render - --format pdb -o crambin.exr --layers layers.exr --stats stats.json\n"
    "`nacre help selections` explains SEL, which is written as in PyMOL or ChimeraX.";
inline constexpr const char* kFigureExamples =
    "A panel is a line like {\"input\": \"1hpv.pdb\", \"style\": \"surface\"}: the options of `nacre render`\n"
    "without dashes. Options on the command line apply to all. Panels have the first panel's scale, and its\n"
    "camera unless they aim themselves. Only the last panel has a scale bar.\n"
    "Examples:\n"
    "  nacre figure panels.jsonl -o figure.png --width 85mm --scale-bar nm\n"
    "  nacre figure panels.jsonl -o figure.tif --columns 3 --letters A --gap 4 --size 800x800";
inline constexpr const char* kBatchExamples =
    "A job is a line like this, with the options of `nacre render` without dashes:\n"
    "  {\"input\": \"1crn.pdb\", \"output\": \"1crn.png\", \"color\": \"chain\", \"show\": [\"ligand=licorice\"]}\n"
    "Options on the command line apply to every job; its own override them. Each finished job prints a line of\n"
    "JSON on standard output:\n"
    "  {\"job\": 1, \"input\": \"1crn.pdb\", \"output\": \"1crn.png\", \"status\": \"done\",\n"
    "   \"ms\": 41.2, \"bytes\": 40213}\n"
    "\"status\" is \"done\", \"failed\" (with \"error\") or \"skipped\" (by --resume). A failed job stops no\n"
    "other; the exit status is 1 then.\n"
    "Examples:\n"
    "  nacre batch jobs.jsonl --size 256x256 --resume > report.jsonl\n"
    "  for f in *.pdb; do printf '{\"input\": \"%s\", \"output\": \"%s.png\"}\\n' \"$f\" \"$f\"; done | nacre batch -";
inline constexpr const char* kServeExamples =
    "  GET /picture?input=sample:dna&style=licorice&size=512x512   the options of `nacre render` as keys\n"
    "  GET /4hhb_assembly-1_front-512x512.webp                     a stable name\n"
    "  POST /picture                                               a structure or a saved view as the body\n"
    "  GET /info, /options, /health, /metrics                      JSON, JSON Schema, ok, Prometheus\n"
    "  GET /                                                       a page that turns molecules\n"
    "Examples:\n"
    "  nacre serve --root ~/structures\n"
    "  nacre serve --listen 0.0.0.0:8080 --allow-download";
inline constexpr const char* kViewExamples =
    "Examples:\n"
    "  nacre view 1bna.pdb\n"
    "  nacre view 4hhb.cif.gz --style spacefill --color chain --visibility encoded\n"
    "  nacre view --view pocket.view.json\n"
    "  nacre view 1bna.pdb --capture\n"
    "Without INPUT the window offers files, samples and the last session. `?` in the window lists keys and gestures.";

inline constexpr const char* kXrExamples =
    "Examples:\n"
    "  nacre xr 1bna.pdb\n"
    "  nacre xr 4hhb.cif.gz --style spacefill --color chain\n"
    "Needs the software of an OpenXR headset, which is running. Trigger: hold and turn the molecule; draw it nearer "
    "to\n"
    "enlarge it. Menu button: reset the view.";

}  // namespace nacre::app
