# Bash completion for lodsmith.

_lodsmith() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}
    local write="--output --force --mesh-version --endian --time-limit --help" options files="*.mesh"
    COMPREPLY=()

    if ((COMP_CWORD == 1)); then
        mapfile -t COMPREPLY < <(compgen -W "generate inspect measure cost render report import strip validate --help --version" -- "$word")
        return
    fi
    case $before in
    --strategy) options="distance pixelcount" ;;
    --metric) options="quadric curvature" ;;
    --automatic) options="balanced classic" ;;
    --preset) options="seed viewer honest" ;;
    --sizes) options="raw zlib" ;;
    --mesh-version) options="1.0 1.4 1.41 1.8 1.10" ;;
    --endian) options="native little big" ;;
    --loddef) files="*.loddef" ;;
    --cache | --materials) files="*/" ;;
    --levels | --repeat | --jobs | -j | --memory | --shard | --time-limit | --samples | --size | --*-weight) return ;;
    --constants | --metres | --viewport | --fov | --at | --optimise | --pixels) return ;;
    esac
    if [[ -z $options && $word == -* ]]; then
        case ${COMP_WORDS[1]} in
        generate)
            options="$write --levels --automatic --pixels --strategy --loddef --no-loddef --metric --normal-weight --uv-weight --colour-weight"
            options+=" --bone-weight --lock-borders --lock-seams --share-buffers --separate-meshes --repeat --jobs --memory --shard"
            options+=" --cache --json"
            ;;
        inspect) options="--json --time-limit --help" ;;
        measure) options="--against --samples --json --time-limit --help" ;;
        cost)
            options="--preset --constants --sizes --metres --preset-distances --viewport --fov --at --optimise --jobs"
            options+=" --time-limit --json --help"
            ;;
        render) options="--output --materials --size --force --json --time-limit --help" ;;
        report) options="--output --pixels --samples --jobs --force --time-limit --help" ;;
        import | strip) options=$write ;;
        validate) options="--json --help" ;;
        esac
    fi
    if [[ -n $options || $word == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$options" -- "$word")
        return
    fi
    [[ ${COMP_WORDS[1]} == import ]] && files="*"
    [[ ${COMP_WORDS[1]} == validate ]] && files="*.loddef"
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -d -- "$word"; compgen -f -X "!$files" -- "$word")
}

complete -F _lodsmith lodsmith
