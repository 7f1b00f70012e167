#!/usr/bin/env bash
# Keeps the documentation's examples true.
#   check-examples.sh [LODSMITH]
# Each C++ example of README.md has to stand, line for line, in tests/consumer/AddLods.cpp, which is compiled and run.
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

blocks cpp "$root/README.md" >"$work/readme.cpp"
if [ ! -s "$work/readme.cpp" ]; then
    say "README.md has no C++ example"
    status=1
elif [[ $(<"$root/tests/consumer/AddLods.cpp") != *"$(<"$work/readme.cpp")"* ]]; then
    say "README.md: the C++ example differs from tests/consumer/AddLods.cpp"
    status=1
fi

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
