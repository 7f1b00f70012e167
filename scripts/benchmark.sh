#!/usr/bin/env bash
# Takes the figures of docs/benchmarks.md and docs/automatic-lod.md again, on a quiet machine in some hours:
#   scripts/benchmark.sh DIR [MEDIA]
# DIR gets lab.db (docs/benchmark-database.md), its tables and plots, and scale.md and runtime.md. Where a database is there
# already what it has is not measured again, so an interrupted run goes on. MEDIA: further meshes besides those of media/.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

if [[ $# -lt 1 || $# -gt 2 || $1 == -* ]]; then
    say "usage: scripts/benchmark.sh DIR [MEDIA]"
    exit 2
fi
mkdir -p "$1"
readonly results=$1 programs=$root/build/release/bin

install_packages build check
configure release -DLODSMITH_BENCHMARKS=ON -DLODSMITH_EXTRA_MEDIA="${2:+$(realpath "$2")}"
build release

"$programs/lodsmith_lab" run "$results/lab.db"
"$programs/lodsmith_lab" tables "$results/lab.db" > "$results/tables.md"
"$programs/lodsmith_lab" plots "$results/lab.db" -o "$results"
"$programs/lodsmith_scale" > "$results/scale.md"
"$programs/lodsmith_runtime" > "$results/runtime.md"
say "The figures are in $results."
