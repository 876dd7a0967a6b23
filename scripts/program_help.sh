# Sourced by scripts that build a program and run it: their --help tells that of the program, too.

# program_help NAME: by its newest build. Who asks for help waits for no compiler: without a build it says when there is more.
program_help()
{
  local program
  program=$(ls -t "$root"/out*/"$1" 2> /dev/null | head -n 1) || true
  # A program from before it had --help would take that for something else.
  if [ -n "$program" ] && [ "$program" -nt "$root/src/apps/command_line.cpp" ]; then
    printf '\nThe program itself, %s:\n\n' "${program#"$root"/}"
    "$program" --help
  else
    printf '\nOnce scripts/%s has built the program, this tells its own options, too.\n' "$1"
  fi
}
