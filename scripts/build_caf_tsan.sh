#!/usr/bin/env bash
# Builds CAF with ThreadSanitizer into build/caf-tsan/lib, for the tsan preset. usage: scripts/build_caf_tsan.sh
# Actors hand messages over by atomics inside CAF's libraries. In Debian's build ThreadSanitizer does not see
# them and takes every message for a race; these libraries stand in for Debian's when the tests run.
set -euo pipefail
cd "$(dirname "$0")/.."

version=0.17.6  # Of libcaf-dev: headers and libraries must match.
hash=e2bf5bd243f08bb7d8adde197cfe3e6d71314ed3378fe0692f8932f4c3b3928c
folder=build/caf-tsan
[ -e "$folder/lib/libcaf_io.so.$version" ] && exit 0

# Most machines list no source packages: the archives that they have are named once more, beside apt's own lists.
apt=$PWD/$folder/apt
mkdir -p "$folder/source" "$apt/sources" "$apt/lists/partial"
sed -n 's/^deb /deb-src /p' /etc/apt/sources.list 2>/dev/null >"$apt/sources/old.list" || true
if [ -e /etc/apt/sources.list.d/debian.sources ]; then
  sed 's/^Types:.*/Types: deb-src/' /etc/apt/sources.list.d/debian.sources >"$apt/sources/debian.sources"
fi
options=(-qq -o Dir::Etc::sourcelist=/dev/null -o Dir::Etc::sourceparts="$apt/sources" -o Dir::State::lists="$apt/lists")
apt-get "${options[@]}" update
archive=actor-framework_$version.orig.tar.gz
(cd "$folder" && apt-get "${options[@]}" source --download-only --tar-only actor-framework)
echo "$hash  $folder/$archive" | sha256sum --quiet -c
tar -xzf "$folder/$archive" --strip-components=1 -C "$folder/source"
# limits: a header that CAF forgets to include.
cmake -S "$folder/source" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo \
  -DCMAKE_CXX_FLAGS="-O1 -g1 -w -include limits -fsanitize=thread -fno-omit-frame-pointer" \
  -DCAF_NO_TOOLS=yes -DCAF_NO_EXAMPLES=yes -DCAF_NO_UNIT_TESTS=yes -DCAF_NO_OPENSSL=yes \
  -DCAF_NO_OPENCL=yes -DCAF_NO_PYTHON=yes -DCMAKE_CXX_COMPILER_LAUNCHER=ccache >"$folder/configure.log"
cmake --build "$folder" -j2
