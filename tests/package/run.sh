#!/usr/bin/env bash
# run.sh BUILD_DIR: packs that build, looks at what is in the packages and what they need, and runs the demo with the
# unpacked programs. With CI=true, as root, also installs the packages, runs the demo in a foreign folder, builds the
# consumer project against them, and removes them.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$(realpath "$1")
if ! command -v dpkg-shlibdeps >/dev/null || ! command -v cpack >/dev/null; then echo "no dpkg-dev or cpack"; exit 77; fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
fail() { echo "package: $*" >&2; exit 1; }

# gzip: xz takes half a minute
(cd "$build" && cpack -G DEB -B "$scratch/packages" -D CPACK_DEBIAN_COMPRESSION_TYPE=gzip) >"$scratch/cpack.log" ||
  { cat "$scratch/cpack.log"; fail "cpack failed"; }
cd "$scratch/packages"
version=$("$build/bin/isostack" --version)
program=$(echo isostack_"$version"_*.deb) development=$(echo isostack-dev_"$version"_*.deb)
[[ -f $program && -f $development ]] || fail "no packages of version $version: $(ls)"

for package in *.deb; do
  dpkg-deb --field "$package" Package Version Depends
  [[ $(dpkg-deb --field "$package" Version) == "$version" ]] || fail "$package is of another version"
done
needs=$(dpkg-deb --field "$program" Depends)
for library in libvtk9.1 libgdcm3.0 libopenimageio2.4 libtbb12 libopenblas0 libssl3; do
  [[ $needs == *"$library "* || $needs == *"$library,"* ]] || fail "$program does not depend on $library"
done
[[ $needs != *-dev* ]] || fail "$program depends on packages for development"
dpkg-deb --field "$program" Recommends | grep -q xvfb || fail "$program does not recommend xvfb"

root=$scratch/root
for package in *.deb; do
  dpkg-deb --extract "$package" "$root"
  name=$(dpkg-deb --field "$package" Package)
  for file in copyright changelog.gz; do
    [[ -s $root/usr/share/doc/$name/$file ]] || fail "$package has no /usr/share/doc/$name/$file"
  done
done
for file in bin/isostack bin/isostack_demo bin/isostack_make_phantom share/man/man1/isostack.1.gz \
  share/man/man1/isostack_demo.1.gz share/bash-completion/completions/isostack share/zsh/vendor-completions/_isostack \
  share/isostack/cohort/Snakefile share/doc/isostack/README.md share/doc/isostack/docs/commands.md \
  include/isostack/recon/reconstruct.h; do
  [[ -s $root/usr/$file ]] || fail "/usr/$file is missing"
done
[[ -x $root/usr/share/isostack/cohort/profiles/slurm/slurm-status.py ]] || fail "the Slurm profile's program cannot be run"
if grep -rlF "$build" "$root/usr" --include='*.cmake' --include='*.h'; then fail "these files name the build folder"; fi
command -v lintian >/dev/null && lintian --allow-root --fail-on error,warning -- *.deb
apt-get install --simulate "./$program" >"$scratch/apt.log" || { cat "$scratch/apt.log"; fail "it cannot be installed"; }

check_demo() {  # in an empty folder
  mkdir -p "$1" && cd "$1"
  isostack_demo out >demo.log || { cat demo.log; fail "the demo failed"; }
  [[ -s out/organ.png ]] || fail "the demo drew no picture"
  isostack measure out/organ.stl --against out/sample/truth.stl --json >measures.json
  python3 - <<'PYTHON' || fail "the demo's surface is not the organ"
import json
measures = json.load(open("measures.json"))
assert measures["shape"]["genus"] == 0 and measures["shape"]["components"] == 1, measures["shape"]
assert measures["comparison"]["dice"] > 0.99, measures["comparison"]
PYTHON
  cd - >/dev/null
}

(PATH=$root/usr/bin:$PATH && check_demo "$scratch/unpacked")
echo "unpacked: the demo ran"

[[ ${CI:-} == true && $(id -u) -eq 0 ]] || exit 0
! dpkg-query --status isostack >/dev/null 2>&1 || fail "isostack is installed already; remove it first"
mapfile -t names < <(for package in *.deb; do dpkg-deb --field "$package" Package; done)
remove() { apt-get remove -q -y "${names[@]}" >>"$scratch/apt.log" 2>&1; }
trap 'remove || true; rm -rf "$scratch"' EXIT
DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends ./*.deb >"$scratch/apt.log" 2>&1 ||
  { cat "$scratch/apt.log"; fail "apt-get install failed"; }
hash -r
[[ $(type -P isostack) == /usr/bin/isostack ]] || fail "the installed program is not the one in the path"
check_demo "$scratch/installed"
cmake -G Ninja -S "$here/../install_consumer" -B "$scratch/consumer" -DCMAKE_BUILD_TYPE=Release >/dev/null
cmake --build "$scratch/consumer" >/dev/null
"$scratch/consumer/consumer" "$scratch/disc.ply"
remove || { cat "$scratch/apt.log"; fail "apt-get remove failed"; }
trap 'rm -rf "$scratch"' EXIT  # apt-get no longer knows the packages' names
[[ ! -e /usr/bin/isostack && ! -e /usr/share/isostack ]] || fail "removing left files behind"
echo "installed, used and removed"
