#!/usr/bin/env bash
# Compiles the consumers with what pkg-config says about an installed Lodsmith, and runs them.
#   pkg-config.sh COMPILER PREFIX LIBDIR OUTPUT-DIRECTORY CONSUMER...   (CONSUMER: core, loddef, cache, ogre or panel)
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
compiler=$1 libdir=$2/$3 output=$4
export PKG_CONFIG_PATH=$libdir/pkgconfig LD_LIBRARY_PATH=$libdir

# compile PACKAGE PROGRAM SOURCE...
compile() {
    local package=$1 program=$2
    local -a flags libraries
    shift 2
    # xargs takes pkg-config's quoting of spaces apart.
    mapfile -t flags < <(pkg-config --cflags "$package" | xargs -n 1)
    mapfile -t libraries < <(pkg-config --libs "$package" | xargs -n 1)
    "$compiler" -std=c++17 "${flags[@]}" "$@" -o "$program" "${libraries[@]}"
}

mkdir -p "$output"
cd "$output"
for consumer in "${@:5}"; do
    case $consumer in
    core) compile lodsmith-core ./core_consumer "$here/CoreConsumer.cpp" ;;
    loddef) compile lodsmith-loddef ./loddef_consumer "$here/LoddefConsumer.cpp" ;;
    cache) compile lodsmith-cache ./cache_consumer "$here/CacheConsumer.cpp" ;;
    ogre) compile lodsmith ./ogre_consumer "$here/OgreConsumer.cpp" "$here/AddLods.cpp" ;;
    panel) compile lodsmith-panel ./panel_consumer "$here/PanelConsumer.cpp" ;;
    esac
    "./${consumer}_consumer"
done
