// Draws a scene by Mol* and by Nacre, and compares cameras and colours (docs/molviewspec.md):
//   npm install molstar pngjs
//   node tools/beside_molstar/judge.mjs SCENE NACRE [STEP [MOMENT]]
// in the folder of node_modules. What the scene names lies beside it. STEP: pixels between those compared, 6. MOMENT: ms
// of the scene's animation. CHROMIUM names another browser. Writes molstar.png and nacre.png beside the scene.
import {execFileSync, spawn} from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import {createRequire} from 'node:module';
import os from 'node:os';
import path from 'node:path';

const {PNG} = createRequire(process.cwd() + '/')('pngjs');
const [scene, nacre, step = '6', moment = '0'] = process.argv.slice(2);
const folder = path.dirname(path.resolve(scene)), own = path.dirname(new URL(import.meta.url).pathname);

/// What the page sends.
async function byMolstar() {
    const types = {'.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css'}, sent = {};
    let done;
    const finished = new Promise(resolve => done = resolve);
    const server = http.createServer((request, response) => {
        const name = decodeURIComponent(new URL(request.url, 'http://a').pathname);
        if (request.method === 'POST') {
            const parts = [];
            request.on('data', part => parts.push(part)).on('end', () => {
                sent[path.basename(name)] = Buffer.concat(parts).toString();
                response.end();
                if (sent.seen || sent.error) done();
            });
            return;
        }
        const file = [folder, own, process.cwd()].map(where => path.join(where, name))
            .find(f => fs.existsSync(f) && fs.statSync(f).isFile());
        response.writeHead(file ? 200 : 404, {'Content-Type': types[path.extname(name)] ?? 'application/octet-stream'});
        file ? fs.createReadStream(file).pipe(response) : response.end();
    });
    await new Promise(listening => server.listen(0, '127.0.0.1', listening));
    const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'molstar-'));
    const browser = spawn(process.env.CHROMIUM ?? 'chromium',
        ['--headless=new', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--hide-scrollbars',
         '--window-size=800,800', `--user-data-dir=${profile}`,
         `http://127.0.0.1:${server.address().port}/page.html?step=${step}&moment=${moment}&scene=${path.basename(scene)}`], {stdio: 'ignore'});
    await finished;
    const ended = new Promise(resolve => browser.on('exit', resolve));
    browser.kill();
    await ended;
    server.close(), server.closeAllConnections();
    fs.rmSync(profile, {recursive: true, force: true, maxRetries: 9, retryDelay: 200});
    if (sent.error) throw new Error(sent.error);
    fs.writeFileSync(path.join(folder, 'molstar.png'), Buffer.from(sent.picture.split(',')[1], 'base64'));
    return JSON.parse(sent.seen);
}

const column = (m, v) => [0, 1, 2, 3].map(i => m[i] * v[0] + m[4 + i] * v[1] + m[8 + i] * v[2] + m[12 + i] * v[3]);
function placeByMolstar(seen, place) {
    const clip = column(seen.projection, column(seen.view, [...place, 1]));
    return [(clip[0] / clip[3] + 1) / 2, (1 - clip[1] / clip[3]) / 2];
}
function placeByNacre(view, place) {
    const from = place.map((x, i) => x - view.center[i]);
    const at = view.rotation.map(row => row.reduce((sum, x, i) => sum + x * from[i], 0));
    const scale = view.pixels_per_angstrom * view.eye_distance / (view.eye_distance - at[2]);
    return [0.5 + at[0] * scale / view.width, 0.5 - at[1] * scale / view.height];
}
/// Hue in degrees; nothing for greys.
function hue(color) {
    const most = Math.max(...color), range = most - Math.min(...color), [r, g, b] = color;
    if (most < 10 || range / most < 0.12) return undefined;
    return 60 * (most === r ? (g - b) / range : most === g ? 2 + (b - r) / range : 4 + (r - g) / range);
}
function sameHue(a, b) {
    const p = hue(a), q = hue(b);
    if (p === undefined || q === undefined) return p === q;
    const turn = Math.abs(p - q) % 360;
    return Math.min(turn, 360 - turn) < 25;
}
function colorAt(image, x, y, seen) {
    const i = Math.floor((x + 0.5) * image.width / seen.width), j = Math.floor((y + 0.5) * image.height / seen.height);
    return [...image.data.subarray(4 * (j * image.width + i)).subarray(0, 3)];
}

const seen = await byMolstar();
const stats = execFileSync(nacre, ['render', scene, '-o', path.join(folder, 'nacre.png'), '--size',
                                   `${seen.width}x${seen.height}`, '--stats', '-'], {stdio: ['ignore', 'pipe', 'inherit']});
if (+moment) {
    const frames = path.join(folder, 'frames/');
    execFileSync(nacre, ['movie', scene, '-o', frames, '--size', `${seen.width}x${seen.height}`, '--fps', `${1000 / moment}`]);
    fs.copyFileSync(path.join(frames, 'frame_00002.png'), path.join(folder, 'nacre.png'));
}
const view = JSON.parse(stats).view, read = name => PNG.sync.read(fs.readFileSync(path.join(folder, name)));
const theirs = read('molstar.png'), ours = read('nacre.png');
const places = seen.places.slice(0, 208), errors = places.map(place => {
    const [a, b] = [placeByMolstar(seen, place), placeByNacre(view, place)];
    return Math.hypot(a[0] - b[0], a[1] - b[1]);
});
const grid = new Map(seen.picks.map(([x, y, name]) => [`${x},${y}`, name])), parts = new Map();
for (const [x, y, name] of seen.picks) {
    const around = [[1, 0], [-1, 0], [0, 1], [0, -1]]
        .filter(([i, j]) => grid.get(`${x + i * step},${y + j * step}`) === name);
    if (around.length < 2) continue;
    const told = parts.get(name) ?? parts.set(name, {same: 0, all: 0}).get(name);
    told.all += 1;
    told.same += sameHue(colorAt(theirs, x, y, seen), colorAt(ours, x, y, seen)) ? 1 : 0;
}
const same = [...parts.values()].filter(told => 2 * told.same >= told.all).length;
console.log(`${path.basename(scene)}: camera within ${(100 * Math.max(0, ...errors)).toFixed(2)} % (${places.length} places), ` +
            `${same} of ${parts.size} residues, primitives and maps in the same colour`);
