#!/usr/bin/env bash
# outside: the completion scripts are scripts of their shells, and bash's completes.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for shell in bash zsh fish; do
  "$FLEXSLIP" completions "$shell" > "$folder/$shell"
  if command -v "$shell" > /dev/null; then "$shell" -n "$folder/$shell"; fi
done

source "$folder/bash"
# completes WORDS... = REPLY...: what the last of the words completes to.
completes() {
  COMP_WORDS=()
  while [[ $1 != = ]]; do
    COMP_WORDS+=("$1")
    shift
  done
  shift
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  _flexslip || true # compgen's status when nothing fits
  if [[ "${COMPREPLY[*]}" != "$*" ]]; then
    echo "${COMP_WORDS[*]}: '${COMPREPLY[*]}' instead of '$*'" >&2
    exit 1
  fi
}
completes flexslip sim = simulate
completes flexslip simulate --no = --noise
completes flexslip design --dec = --decide
completes flexslip completions "" = bash zsh fish
completes flexslip state --S = --S
completes flexslip simulate "" = # a file, which is bash's own default
