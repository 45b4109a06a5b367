# SPDX-License-Identifier: LGPL-2.1-or-later
# For the scripts of the project, to be sourced: quiet steps with a log, and how many processes to
# start.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
logs=$root/build/log
mkdir -p "$logs"

# step LOG TEXT COMMAND...: says what is done, keeps what the command prints in a file, shows its
# end on failure.
step() {
  local log=$logs/$1.log text=$2 start=$SECONDS status=0
  shift 2
  printf '%-58s ' "$text"
  "$@" >"$log" 2>&1 </dev/null || status=$?
  if [ $status = 0 ]; then
    echo "done ($((SECONDS - start)) s)"
  else
    echo "FAILED (status $status)"
    tail -n 40 "$log" | sed 's/^/    /'
    echo "    all of it: $log"
  fi
  return $status
}

# One process for each processor, fewer where memory is short: a compiler may take 1 GB.
jobs_here() {
  local processors memory_gb
  processors=$(nproc)
  memory_gb=$(awk '/^MemAvailable/ {print int($2 / 1000000)}' /proc/meminfo)
  echo $((processors < memory_gb ? processors : memory_gb > 1 ? memory_gb : 1))
}
