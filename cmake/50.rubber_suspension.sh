# setup.sh of the workspace sources this file: completion of rubber-suspension and of rosrun for its commands, in bash.
if [ -n "${BASH_VERSION:-}" ] &&
    [ -r "${CATKIN_ENV_HOOK_WORKSPACE:-}/share/bash-completion/completions/rubber-suspension" ]; then
  . "$CATKIN_ENV_HOOK_WORKSPACE/share/bash-completion/completions/rubber-suspension"
fi
