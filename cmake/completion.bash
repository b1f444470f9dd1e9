# Completion of rubber-suspension for bash, written by the build from what the commands print with --help-all.
_rubber_suspension() {
  local word=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]-} options= files= folders=
  COMPREPLY=()
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W "@COMMANDS@ generate_track live_plot render_report --help --version" -- "$word"))
    return
  fi
  case $command in
    @CASES@
    # A command that is not in this table, as the Python scripts, is asked itself.
    *) options=$("${COMP_WORDS[@]:0:2}" --help 2>/dev/null | grep -oE -- '--[a-z][a-z-]*' | sort -u) ;;
  esac
  # An option may have several values: the one that the word belongs to is the last before it.
  local i option=
  for ((i = COMP_CWORD - 1; i > 1; --i)); do
    [[ ${COMP_WORDS[i]} == -* ]] && { option=${COMP_WORDS[i]}; break; }
  done
  if [[ $word == -* ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$word"))
  elif [[ " $folders " == *" $option "* ]]; then
    compopt -o filenames
    COMPREPLY=($(compgen -d -- "$word"))
  elif [[ $option == --component ]]; then
    local config=
    for ((i = 2; i < COMP_CWORD; ++i)); do
      [[ ${COMP_WORDS[i]} == --config ]] && config=${COMP_WORDS[i + 1]}
    done
    COMPREPLY=($(compgen -W "$(sed -nE 's/^  ([A-Za-z][A-Za-z0-9_]*):.*/\1/p' "$config" 2>/dev/null)" -- "$word"))
  elif [[ -z $option || " $files " == *" $option "* ]]; then
    compopt -o filenames
    COMPREPLY=($(compgen -f -- "$word"))
  fi
}
complete -F _rubber_suspension rubber-suspension

# rosrun rubber_suspension COMMAND as rubber-suspension COMMAND; all else as rosbash has it, which bash may not have loaded.
_rubber_suspension_rosrun() {
  if [ "$COMP_CWORD" -gt 2 ] && [ "${COMP_WORDS[1]}" = rubber_suspension ]; then
    local COMP_WORDS=(rubber-suspension "${COMP_WORDS[@]:2}") COMP_CWORD=$((COMP_CWORD - 1))
    _rubber_suspension
  else
    if ! declare -F _roscomplete_exe >/dev/null && [ -r /usr/share/bash-completion/completions/rosrun ]; then
      . /usr/share/bash-completion/completions/rosrun
      complete -F _rubber_suspension_rosrun rosrun
    fi
    ! declare -F _roscomplete_exe >/dev/null || _roscomplete_exe
  fi
}
complete -F _rubber_suspension_rosrun rosrun
