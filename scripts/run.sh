#!/usr/bin/env bash
# Installs what is missing, builds Lodsmith and runs it.
#   scripts/run.sh              makes LODs for a model of media/ and says what to try next
#   scripts/run.sh sample ...   runs the sample client, a window in which levels change (docs/runtime.md)
#   scripts/run.sh editor ...   opens meshes, or directories of them, in the editor (docs/editor.md)
#   scripts/run.sh ARGUMENT...  runs `lodsmith ARGUMENT...`
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

readonly lodsmith=$root/build/release/bin/lodsmith
readonly demo_model=drake
readonly demo_levels=10:proportional:0.5,20:proportional:0.75,40:proportional:0.875,80:proportional:0.9375

install_packages build
configure release
build release lodsmith_cli

# Each first word that starts another program than `lodsmith` has its line here.
case "${1-}" in
"") ;;
sample)
    build release lodsmith_sample
    exec "$root/build/release/bin/lodsmith_sample" "${@:2}"
    ;;
editor)
    build release lodsmith_editor
    exec "$root/build/release/bin/lodsmith-editor" "${@:2}"
    ;;
*) exec "$lodsmith" "$@" ;;
esac

"$lodsmith" generate "$root/media/$demo_model/$demo_model.mesh" -o "$root/build/demo/" --force --levels "$demo_levels"
cat <<EOF

The mesh with its levels: $root/build/demo/$demo_model.mesh
The command itself:       $lodsmith

To try next, in $root:
    ./scripts/run.sh inspect build/demo/$demo_model.mesh
    ./scripts/run.sh measure build/demo/$demo_model.mesh
    ./scripts/run.sh generate media/ -o build/demo/all/ --force
    ./scripts/run.sh import YOUR-MODEL.obj -o build/demo/yours.mesh
    ./scripts/run.sh editor build/demo/$demo_model.mesh
    ./scripts/run.sh sample
    ./scripts/run.sh generate --help
EOF
