"""A bare Debian bookworm in a folder, and commands in it by chroot. Needs root and debootstrap."""
import pathlib
import re
import shutil
import subprocess

PATH = "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin"
MOUNTS = """set -eu
mount -t proc proc "$0/proc"
mount -t tmpfs tmpfs "$0/dev"
for device in null zero full random urandom; do touch "$0/dev/$device"; mount --bind "/dev/$device" "$0/dev/$device"; done
ln -s /proc/self/fd "$0/dev/fd"; mkdir "$0/dev/shm"; mount -t tmpfs tmpfs "$0/dev/shm"
if [ -n "${CACHE:-}" ]; then mkdir -p "$0/ccache"; mount --bind "$CACHE" "$0/ccache"; fi
unset CACHE
exec chroot "$0" "$@"
"""


def make_debian(folder):
    """A bare Debian with this machine's mirrors and proxy."""
    if folder.exists():
        return
    listed = subprocess.run(["apt-get", "indextargets", "--format", "deb $(REPO_URI) $(RELEASE) $(COMPONENT)",
                             "Created-By: Packages", "Origin: Debian"], capture_output=True, text=True, check=True).stdout
    archives = sorted({line for line in listed.splitlines() if re.match(r"deb \S+ bookworm(-updates|-security)? ", line)})
    mirror = next(line.split()[1] for line in archives if line.split()[2] == "bookworm")
    part = folder.with_suffix(".part")
    shutil.rmtree(part, ignore_errors=True)
    part.parent.mkdir(parents=True, exist_ok=True)
    subprocess.run(["debootstrap", "--variant=minbase", "--include=ca-certificates", "bookworm", part, mirror], check=True)
    (part / "etc/apt/sources.list").write_text("\n".join(archives) + "\n")
    host = subprocess.run(["apt-config", "dump", "Acquire"], capture_output=True, text=True, check=True).stdout
    (part / "etc/apt/apt.conf.d/90host").write_text(host)
    part.rename(folder)


def copy_root(base, folder):
    shutil.rmtree(folder, ignore_errors=True)
    subprocess.run(["cp", "-a", "--reflink=auto", base, folder], check=True)
    if pathlib.Path("/etc/resolv.conf").exists():
        shutil.copy("/etc/resolv.conf", folder / "etc/resolv.conf")


def run_in(folder, *words, network=True, **options):
    """Runs a command in it, without a network if asked for."""
    environment = ["/usr/bin/env", "-i", f"PATH={PATH}", "HOME=/root", "LANG=C.UTF-8", "DEBIAN_FRONTEND=noninteractive"]
    space = ["unshare", "--mount", "--propagation", "private", *([] if network else ["--net"])]
    return subprocess.run([*space, "sh", "-c", MOUNTS, str(folder), *environment, *map(str, words)], **options)
