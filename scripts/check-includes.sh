#!/usr/bin/env bash
# Includes point left only: a room includes itself and the rooms and packages that stand left of it in the table below.
# Prints each include that does not, and then fails. docs/architecture.md has the reasons.
set -euo pipefail
# shellcheck source=scripts/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# check ROOM LEFT PACKAGES [FOLDER]: LEFT and PACKAGES are extended regular expressions, the latter of whole include names.
# The room's sources are in FOLDER, else in src/ROOM.
# The standard library's headers have neither slash nor dot and are allowed everywhere.
cd "$root"
status=0
check() {
    local room=$1 allowed="^(lodsmith/($2)/.*|[a-z_0-9]+|$3)$" file line name
    while IFS=: read -r file line name; do
        case $name in
        \"*) # A private header: of this room, or of one to its left.
            name=${name//\"/}
            [[ $name =~ ^(\.\./(src/)?($2)/)?[A-Za-z0-9]+\.h$ ]] && [ -f "$(dirname "$file")/$name" ] && continue
            ;;
        *)
            name=${name//[<>]/}
            [[ $name =~ $allowed ]] && continue
            ;;
        esac
        say "$file:$line: $room may not include $name"
        status=1
    done < <(find "include/lodsmith/$room" "${4-src/$room}" \( -name '*.h' -o -name '*.cpp' \) -print0 2>/dev/null \
        | xargs -0 grep -HnoE '^ *#include *[<"][^>"]+[>"]' | sed -E 's/#include *//; s/: +/:/')
}

check core core 'boost/.*'
check analysis 'core|analysis' 'boost/.*|embree3/.*'
check generators 'core|analysis|generators' 'boost/.*'
check files 'core|files' 'fcntl\.h|unistd\.h|sys/[a-z]+\.h'
check loddef 'core|files|loddef' 'tinyxml2\.h'
check cache 'core|files|cache' 'xxhash\.h'
check ogre 'core|analysis|generators|files|loddef|cache|ogre' 'Ogre[A-Za-z]*\.h|zlib\.h|meshoptimizer\.h|sigc\+\+/[a-z_]+\.h'
check render 'core|analysis|ogre|render' 'Ogre[A-Za-z]*\.h'
check lua 'core|loddef|ogre|lua' 'Ogre[A-Za-z]*\.h|sigc\+\+/[a-z_/]+\.h|lua\.hpp|tolua\+\+\.h' lua-bindings
check panel 'core|analysis|loddef|ogre|render|lua|panel' 'Ogre[A-Za-z]*\.h|CEGUI/.*|lua\.hpp|tolua\+\+\.h|dlfcn\.h'
check editor 'core|files|ogre|render|cli|lua|panel|editor' 'Ogre[A-Za-z]*\.h|CEGUI/.*|lua\.hpp|poll\.h|sys/[a-z]+\.h|unistd\.h|SDL(_syswm)?\.h|CLI/CLI\.hpp|nlohmann/json\.hpp'
check samples 'core|ogre|panel|editor|samples' 'CLI/CLI\.hpp|Ogre[A-Za-z]*\.h|CEGUI/.*|SDL(_syswm)?\.h|lua\.hpp'
exit "$status"
