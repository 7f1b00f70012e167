#!/usr/bin/env bash
# Keeps the documentation's examples true.
#   check-examples.sh [LODSMITH]
# Each C++ example of README.md, docs/runtime.md and docs/embedding.md has to stand, line for line, in a source that is compiled and run.
# Each `lodsmith` command in a block marked `sh` of README.md and docs/ is run with LODSMITH, the program, in a directory
# of its own that holds media/; without LODSMITH that part is left out.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0

# blocks LANGUAGE FILE: the lines of the file's blocks in that language.
blocks() {
    awk -v language="$1" '$0 == "```" language { inside = 1; next } /^```/ { inside = 0 } inside' "$2"
}

# check_examples PAGE SOURCE...: each block of C++ of the page is part of the source that has its place in the list.
check_examples() {
    local page=$1 example number=0
    shift
    while IFS= read -r -d $'\f' example; do
        number=$((number + 1))
        example=${example%$'\n'}
        if [ -z "${1-}" ] || [[ $(<"$root/$1") != *"$example"* ]]; then
            say "$page: C++ example $number differs from ${1-the sources, which have none for it}"
            status=1
        fi
        shift || true
    done < <(awk '$0 == "```cpp" { inside = 1; next } /^```/ { if (inside) printf "\f"; inside = 0 } inside' "$root/$page")
    if [ $# -gt 0 ]; then
        say "$page has no C++ example for $*"
        status=1
    fi
}

check_examples README.md tests/consumer/AddLods.cpp src/samples/LibraryLods.h
check_examples docs/embedding.md src/samples/GameGui.cpp src/samples/LodPanel.cpp src/samples/Game.cpp src/samples/LodPanel.cpp src/samples/LodPanel.cpp
check_examples docs/runtime.md src/samples/LibraryLods.h tests/ogre/DefinedLodConfigTest.cpp tests/ogre/BackgroundLods.h

# run_commands FILE: runs its `lodsmith` commands in their order.
run_commands() {
    local directory=$work/${1##*/} command
    mkdir "$directory"
    ln -s "$root/media" "$directory/media"
    while IFS= read -r command; do
        if ! (cd "$directory" && bash -c "$command" </dev/null >output 2>&1); then
            say "${1#"$root/"}: failed: $command"
            cat "$directory/output" >&2
            status=1
        fi
    done < <(blocks sh "$1" | sed -e ':a' -e '/\\$/N; s/\\\n *//; ta' | grep -E '^lodsmith ')
}

if [ -n "${1-}" ]; then
    mkdir "$work/bin"
    ln -s "$(realpath "$1")" "$work/bin/lodsmith"
    PATH=$work/bin:$PATH
    for page in "$root/README.md" "$root"/docs/*.md; do
        run_commands "$page"
    done
fi
exit "$status"
