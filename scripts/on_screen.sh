# Sourced by the commands that run a scene in RViz on a screen in memory. They set `root` and `name` before.
#
#   open_screen [WIDTHxHEIGHT]    the environment, something built, and a screen: sets DISPLAY
#   open_scene ARGUMENTS ...      roslaunch of sim.launch, or of `launch_file` if set, until the scene is drawn: sets `launch`, its process
#   close_scene                   ends it
#   wait_for WHAT COMMAND ...     until the command succeeds
#   fail TEXT                     ends with the launch's last words
# `work` is a directory for files; everything ends with the command that sources this.
deadline=60  # for each thing that is waited for [s]

export PATH="/usr/bin:$PATH"
export ROS_HOSTNAME="${ROS_HOSTNAME:-localhost}"

work=$(mktemp -d)
screen='' launch=''
close_scene() {
  [ -n "$launch" ] || return 0
  kill -INT "$launch" 2> /dev/null || true
  # roslaunch ends its nodes and then itself; whoever is left after that is not waited for.
  for _ in $(seq 100); do
    kill -0 "$launch" 2> /dev/null || break
    sleep 0.1
  done
  kill -KILL "$launch" 2> /dev/null || true
  wait "$launch" 2> /dev/null || true
  launch=''
}
finish() {
  close_scene
  if [ -n "$screen" ]; then kill "$screen" 2> /dev/null || true; fi
  rm -rf "$work"
}
trap finish EXIT

fail() { echo "$name: $1" >&2; tail -n 20 "$work/launch.log" >&2 2> /dev/null || true; exit 1; }

# wait_for WHAT COMMAND ...: until the command succeeds, at most `deadline` seconds, and only while all is alive.
wait_for() {
  local what=$1 end=$((SECONDS + deadline))
  shift
  until "$@"; do
    [ "$SECONDS" -lt "$end" ] || fail "no $what within $deadline s"
    if [ -n "$launch" ]; then kill -0 "$launch" 2> /dev/null || fail "the launch ended early"; fi
    sleep 0.2
  done
}

# A function: the setup file must not see our arguments.
# shellcheck disable=SC1091
enter() { set +u; source "$root/out/devel/setup.bash"; set -u; }

open_screen() {
  "$root/scripts/install-dependencies" core ros rviz display
  [ -x "$root/out/devel/lib/ping_pong_sim/ping_pong_sim" ] || "$root/scripts/build" -- -DCATKIN_ENABLE_TESTING=OFF
  enter
  Xvfb -displayfd 3 -noreset -screen 0 "${1:-1280x800}x24" 3> "$work/display" > "$work/screen.log" 2>&1 &
  screen=$!
  wait_for "screen" test -s "$work/display"
  DISPLAY=:$(cat "$work/display")
  export DISPLAY
}

window_there() { xwininfo -root -tree 2> /dev/null | grep -q 'RViz'; }
# An empty view is dark all over; balls and lines are bright.
scene_drawn() {
  local brightest
  brightest=$(import -silent -window root -crop 1200x680+40+70 -colorspace Gray \
    -format '%[fx:round(100*maxima)]' info:- 2> /dev/null) || return 1
  [ "${brightest:-0}" -gt 45 ]
}

open_scene() {
  # A master of its own, so that nothing else that runs here is disturbed.
  local port
  port=$(/usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])')
  export ROS_MASTER_URI="http://localhost:$port"
  # Ctrl-C must reach roslaunch though it runs in the background, hence its own process group.
  set -m
  roslaunch -p "$port" ping_pong_sim "${launch_file:-sim.launch}" rviz:=true "$@" > "$work/launch.log" 2>&1 &
  launch=$!
  set +m
  wait_for "window of RViz" window_there
  wait_for "scene in RViz" scene_drawn
}
