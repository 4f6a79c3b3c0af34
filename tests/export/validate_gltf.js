// node validate_gltf.js MODULE FILE.glb...: what Khronos' validator finds in files, a line each. Exits with 1 where that is
// an error or a warning.
const fs = require('fs');
const validator = require(process.argv[2]);

(async () => {
    let bad = 0;
    for (const name of process.argv.slice(3)) {
        const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(name)), {maxIssues: 20});
        const {numErrors, numWarnings, messages} = report.issues;
        bad += numErrors + numWarnings;
        const {totalTriangleCount, totalVertexCount} = report.info;
        console.log(`${name}: ${numErrors} errors, ${numWarnings} warnings, ${totalTriangleCount} triangles, ` +
                    `${totalVertexCount} vertices`);
        for (const m of messages) if (m.severity < 2) console.log(`  ${m.code} ${m.pointer ?? ''}: ${m.message}`);
    }
    process.exitCode = bad ? 1 : 0;
})();
