"""Builds Mesa's drivers of tilers over its kernel drivers that do nothing, for tools/tilers.

The drivers compile shaders, plan their tiles and write their command streams as on a phone; nothing executes. Mesa comes
as Debian's source (bookworm-backports), and is built once into the cache folder: some four minutes of processor time for
each of two processors. What was built is built on from, should that be stopped.

GPUs that this Mesa does not know come from the packages of a newer one (trixie-backports), unpacked beside it. They need
a newer libc: the program runs by that libc's loader.
"""

import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PACKAGES = """source:mesa/bookworm-backports meson/bookworm-backports python3-mako/bookworm python3-markupsafe/bookworm
python3-yaml/bookworm python3-ply/bookworm python3-packaging/bookworm python3-setuptools/bookworm
python3-pkg-resources/bookworm flex/bookworm bison/bookworm m4/bookworm libdrm-dev/bookworm-backports
libdrm2/bookworm-backports libdrm-nouveau2/bookworm-backports libdrm-amdgpu1/bookworm-backports
libdrm-radeon1/bookworm-backports libdrm-intel1/bookworm-backports libelf-dev/bookworm libelf1/bookworm
libarchive-dev/bookworm libarchive13/bookworm liblua5.3-dev/bookworm liblua5.3-0/bookworm libudev-dev/bookworm
libudev1/bookworm
libxml2-dev/bookworm libxml2/bookworm libicu-dev/bookworm libicu72/bookworm""".split()
NEWER = """mesa-vulkan-drivers/trixie-backports mesa-drm-shim/trixie-backports libc6/trixie libstdc++6/trixie libgcc-s1/trixie
libdrm2/trixie libdrm-amdgpu1/trixie libelf1t64/trixie libexpat1/trixie libpng16-16t64/trixie libdisplay-info2/trixie
libwayland-client0/trixie libx11-xcb1/trixie libxcb-dri3-0/trixie libxcb-present0/trixie libxcb-randr0/trixie
libxcb-shm0/trixie libxcb-sync1/trixie libxcb-xfixes0/trixie libxcb1/trixie libxshmfence1/trixie libzstd1/trixie
zlib1g/trixie libvulkan1/trixie""".split()
# Of the packages: the kernel driver that does nothing, and the driver.
PACKAGED = {"turnip 26": ("libfreedreno_noop_drm_shim.so", "libvulkan_freedreno.so"),
            "honeykrisp": ("libasahi_noop_drm_shim.so", "libvulkan_asahi.so")}
TARGETS = {
    "turnip": ["src/freedreno/drm-shim/libfreedreno_noop_drm_shim.so", "src/freedreno/vulkan/libvulkan_freedreno.so",
               "src/freedreno/decode/cffdump"],
    "v3dv": ["src/broadcom/drm-shim/libv3d_noop_drm_shim.so", "src/broadcom/vulkan/libvulkan_broadcom.so"],
    "panvk": ["src/panfrost/drm-shim/libpanfrost_noop_drm_shim.so", "src/panfrost/vulkan/libvulkan_panfrost.so"],
}
OPTIONS = """--wrap-mode=nodownload -Dbuildtype=plain -Db_ndebug=true -Dvulkan-drivers=freedreno,broadcom,panfrost
-Dgallium-drivers= -Dtools=drm-shim,freedreno,panfrost -Dfreedreno-kmds=msm -Dplatforms= -Dllvm=disabled -Dglx=disabled
-Degl=disabled -Dgbm=disabled -Dopengl=false -Dgles1=disabled -Dgles2=disabled -Dvideo-codecs= -Dxmlconfig=disabled
-Dshader-cache=enabled""".split()

# What the kernel drivers that do nothing lack, and what the drivers must not wait for. File, what stands there, what is
# to stand there.
ADDED = [
    ("src/freedreno/drm-shim/freedreno_noop.c", "   {\n      .gpu_id = 660,\n",
     "   {\n      .gpu_id = 650,\n      .chip_id = CHIPID(6, 5, 0, 2),\n      .gmem_size = 1024 * 1024 + 128 * 1024,\n"
     "   },\n   {\n      .gpu_id = 660,\n"),
    ("src/broadcom/drm-shim/v3d_noop.c", "        switch (gp->param) {\n",
     "        const char *version = getenv(\"V3D_VER\");\n"
     "        const int seven = version && atoi(version) == 71;\n"
     "        if (seven && gp->param == DRM_V3D_PARAM_V3D_CORE0_IDENT0) { gp->value = 0x07443356; return 0; }\n"
     "        if (seven && gp->param == DRM_V3D_PARAM_V3D_CORE0_IDENT1) { gp->value = 0x81001421; return 0; }\n"
     "        if (gp->param == DRM_V3D_PARAM_SUPPORTS_PERFMON) { gp->value = 0; return 0; }\n"
     "        switch (gp->param) {\n"
     "        case DRM_V3D_PARAM_SUPPORTS_MULTISYNC_EXT:\n"
     "        case DRM_V3D_PARAM_SUPPORTS_CPU_QUEUE:\n"
     "                gp->value = gp->param == DRM_V3D_PARAM_SUPPORTS_MULTISYNC_EXT;\n"
     "                return 0;\n"),
    ("src/broadcom/drm-shim/v3d_noop.c", "#include <stdio.h>\n", "#include <stdio.h>\n#include <stdlib.h>\n"),
    ("src/broadcom/drm-shim/v3d_noop.c", "        [DRM_V3D_SUBMIT_TFU] = v3d_ioctl_noop,\n",
     "        [DRM_V3D_SUBMIT_TFU] = v3d_ioctl_noop,\n        [DRM_V3D_SUBMIT_CSD] = v3d_ioctl_noop,\n"),
    # The driver's own thread would still be at commands that the program frees: their fences are signalled already.
    ("src/broadcom/vulkan/v3dv_device.c", "   result = vk_queue_enable_submit_thread(&queue->vk);\n",
     "   result = VK_SUCCESS;\n"),
    # What a traced submission counts up is counted by nobody here.
    ("src/panfrost/vulkan/csf/panvk_vX_queue.c",
     "            vk_queue_set_lost(&queue->vk, \"Incomplete job or timeout\");", "            continue;"),
    ("src/drm-shim/device.c", "   [_IOC_NR(DRM_IOCTL_SYNCOBJ_RESET)] = drm_shim_ioctl_stub,\n",
     "   [_IOC_NR(DRM_IOCTL_SYNCOBJ_RESET)] = drm_shim_ioctl_stub,\n"
     "   [_IOC_NR(DRM_IOCTL_SYNCOBJ_SIGNAL)] = drm_shim_ioctl_stub,\n"),
    # Pointers to framebuffers are values of registers, which nobody executes: told as they are prepared.
    ("src/panfrost/vulkan/csf/panvk_vX_cmd_draw.c", "#include \"genxml/gen_macros.h\"\n",
     "#include \"genxml/gen_macros.h\"\n#include \"genxml/decode.h\"\n"),
    ("src/panfrost/vulkan/csf/panvk_vX_cmd_draw.c",
     "   struct cs_builder *b = panvk_get_cs_builder(cmdbuf, PANVK_SUBQUEUE_FRAGMENT);\n\n   if (copy_fbds) {",
     "   if (dev->debug.decode_ctx) {\n"
     "      pandecode_user_msg(dev->debug.decode_ctx, \"\\n\");\n"
     "      GENX(pandecode_fbd)(dev->debug.decode_ctx, fbds.gpu, true, 0);\n"
     "      pandecode_map_read_write(dev->debug.decode_ctx);\n"
     "   }\n\n"
     "   struct cs_builder *b = panvk_get_cs_builder(cmdbuf, PANVK_SUBQUEUE_FRAGMENT);\n\n   if (copy_fbds) {"),
]


def fail(text):
    sys.exit(f"nacre: error: {text}")


def add_devices(source):
    """Each change once: the file that has it keeps its time, so that nothing is built again."""
    for name, before, after in ADDED:
        path = source / name
        text = path.read_text()
        if after in text and (before in after or before not in text):
            continue
        if before not in text:
            fail(f"{path} is not what the change for it was made for: {before.strip()}")
        path.write_text(text.replace(before, after, 1))


def environment(folder):
    root = folder / "root"
    libraries = root / "usr/lib/x86_64-linux-gnu"
    for path in (libraries / "pkgconfig").glob("*.pc"):
        text = path.read_text()
        if "prefix=/usr\n" in text:
            path.write_text(text.replace("prefix=/usr\n", f"prefix={root}/usr\n", 1))
    include = f"-O1 -I{root}/usr/include -I{root}/usr/include/x86_64-linux-gnu"
    return dict(os.environ, PATH=f"{root}/usr/bin:/usr/bin:/bin", PYTHONPATH=f"{root}/usr/lib/python3/dist-packages",
                BISON_PKGDATADIR=f"{root}/usr/share/bison", M4=f"{root}/usr/bin/m4",
                PKG_CONFIG_PATH=f"{libraries}/pkgconfig", CFLAGS=include, CXXFLAGS=include,
                LDFLAGS=f"-L{libraries} -Wl,-rpath,{libraries}")


def run(command, env, log):
    with open(log, "ab") as out:
        done = subprocess.run(command, env=env, stdout=out, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
    if done.returncode:
        tail = "\n".join(pathlib.Path(log).read_text(errors="replace").splitlines()[-15:])
        fail(f"Mesa could not be built; the whole log is {log}\n{tail}")


def packaged(build, driver):
    """Shim and driver of the newer packages, and the words by which a program starts with their libc."""
    root = build.parent / "newer/root/usr"
    libraries = root / "lib/x86_64-linux-gnu"
    shim, library = (libraries / name for name in PACKAGED[driver])
    path = f"{libraries}:/usr/lib/x86_64-linux-gnu"
    return library, [root / "lib64/ld-linux-x86-64.so.2", "--library-path", path, "--preload", shim]


def built(folder, drivers, jobs):
    """The folder that Mesa is built in, with what these drivers need; builds or unpacks what is missing."""
    build = folder / "mesa-build"
    if any(d in PACKAGED for d in drivers):
        subprocess.run([ROOT / "tools/unpack_beside", folder / "newer", *NEWER], check=True)
    drivers = [d for d in drivers if d not in PACKAGED]
    build.mkdir(exist_ok=True)
    if not drivers:
        return build
    targets = [t for d in drivers for t in TARGETS[d]]
    subprocess.run([ROOT / "tools/unpack_beside", folder, *PACKAGES], check=True)
    add_devices(folder / "mesa-source")
    env, log = environment(folder), folder / "build.log"
    python = "/usr/bin/python3"  # whose packages those are
    if not (build / "build.ninja").exists():
        print("nacre: Mesa's drivers are built, once: 5 to 20 minutes", file=sys.stderr)
        run([python, folder / "root/usr/bin/meson", "setup", build, folder / "mesa-source", *OPTIONS], env, log)
    run(["nice", "-n", "19", "ninja", f"-j{jobs}", "-C", build, *targets], env, log)
    return build
