#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# sweep_test.sh killed|parallel|slurm TREE BUILD: a sweep in eight shards gives the rows of one run, when
#   killed    two of the shards of 256 scenes are killed at their work and begun again, some ten times each; until
#             there were FOLDLESS_KILLS of them; tells how many;
#   parallel  GNU parallel makes them, with the lines of docs/sweeps.md as they are pasted, of fewer scenes;
#   slurm     a Slurm array does, of a cluster of this machine alone, which is begun here and ended.
# Status 77: the engine is not installed, or does not begin here.
set -euo pipefail
mode=$1 tree=$(realpath "$2")
PATH=$(realpath "$3"):$PATH
export PATH
work=$(mktemp -d)
cd "$work"

end_slurm() {
  local daemon pids=()
  for daemon in slurmctld slurmd munged; do
    [ ! -s "run/$daemon.pid" ] || pids+=("$(cat "run/$daemon.pid")")
  done
  [ ${#pids[@]} -gt 0 ] || return 0
  kill "${pids[@]}" 2>/dev/null || true
  # What they still write would come between rm and its folder.
  for daemon in "${pids[@]}"; do
    timeout 20 tail --follow --sleep-interval=0.1 --pid="$daemon" /dev/null || kill -KILL "$daemon" 2>/dev/null || true
  done
}
trap 'end_slurm; rm -rf "$work"' EXIT

skip_without() {
  local name
  for name in "$@"; do
    PATH=$PATH:/usr/sbin command -v "$name" >/dev/null || {
      echo "SKIPPED: $name is not installed"
      exit 77
    }
  done
}

# rows_of FOLDER: results.json without what differs from run to run.
rows_of() {
  python3 -c "import json, sys
for row in json.load(open(sys.argv[1] + '/results.json')):
    print(json.dumps({k: v for k, v in row.items() if k != 'seconds'}))" "$1"
}

# expect_same ARGUMENT...: tables/ has the rows of the sweep of these arguments in one run, which is made once.
expect_same() {
  [ -d whole ] || foldless bench --suite random "$@" -o whole >/dev/null
  rows_of whole >whole.rows
  rows_of tables >tables.rows
  [ "$(wc -l <whole.rows)" -ge 16 ] || { echo "there are hardly rows" && exit 1; }
  diff whole.rows tables.rows
}

# block_of N: the N-th block for a shell in the page, of eight scenes and two methods.
few=(--count 8 --method foldless,lim --time-limit 600)
block_of() {
  awk -v n="$1" '/^```$/ { on = 0 } on { print } /^```sh$/ { on = ++i == n }' "$tree/docs/sweeps.md" |
    sed "s/--count 256/${few[*]}/"
}

killed() {
  # Every sixth scene is an easy one.
  local round shard at_work=0 sweep=(--seed 5 --count 1536 --only "$(seq --separator=, 0 6 1530)" --method foldless)
  make() { foldless bench --suite random "${sweep[@]}" --shard "$1/8" --append "$1.jsonl" >/dev/null 2>&1; }
  for shard in {3..8}; do make "$shard"; done
  for ((round = 0; at_work < ${FOLDLESS_KILLS:-1}; round++)); do kill_shards $((1 + round % 3)); done
  echo "$at_work times a shard was killed at its work, with some of its 32 rows written"
}

# kill_shard SHARD LINES: begins it again and again, and kills it a moment after it has so many lines more. It may end
# before that is seen, on a quick machine or a busy one: then it is begun anew.
kill_shard() {
  local shard=$1 try victim status lines rows before=$at_work
  for try in {1..50}; do
    rm -f "$shard.jsonl"
    lines=0 status=137
    while [ $status -eq 137 ] && [ "$lines" -lt 32 ]; do
      foldless bench --suite random "${sweep[@]}" --shard "$shard/8" --append "$shard.jsonl" >/dev/null 2>&1 &
      victim=$! status=0
      while kill -0 "$victim" 2>/dev/null; do
        rows=()
        [ ! -e "$shard.jsonl" ] || mapfile -t rows <"$shard.jsonl"
        [ ${#rows[@]} -lt $((lines + $2)) ] || break
        sleep 0.01
      done
      sleep "0.0$((at_work % 4))"
      kill -KILL "$victim" 2>/dev/null || true
      wait "$victim" 2>/dev/null || status=$?
      lines=$(cat "$shard.jsonl" 2>/dev/null | wc -l)
      [ $status -ne 137 ] || [ "$lines" -ge 32 ] || at_work=$((at_work + 1))
    done
    [ $status -eq 0 ] || [ $status -eq 137 ] || { echo "shard $shard ended with $status" && exit 1; }
    [ "$at_work" -eq "$before" ] || return 0
  done
  echo "shard $shard ended before it was killed, $try times" && exit 1
}

# kill_shards LINES: two of them, which are begun again then.
kill_shards() {
  rm -rf tables
  for shard in 1 2; do kill_shard "$shard" "$1"; done
  for shard in 1 2; do make "$shard"; done
  foldless bench --merge ?.jsonl -o tables >/dev/null 2>notes
  [ ! -s notes ] || { cat notes && exit 1; }
  expect_same "${sweep[@]}"
  [ "$(wc -l <tables.rows)" -eq 256 ]
}

parallel_() {
  skip_without parallel
  block_of 2 >sweep.sh
  grep --quiet 'parallel foldless' sweep.sh
  HOME=$work bash -e sweep.sh >/dev/null 2>&1
  expect_same "${few[@]}"
}

begin_slurm() {
  local host user
  host=$(hostname -s) user=$(id -un)
  mkdir run state spool
  head --bytes=1024 /dev/urandom >munge.key
  chmod 400 munge.key
  munged --force --key-file="$work/munge.key" --socket="$work/run/munge.socket" --pid-file="$work/run/munged.pid" \
    --log-file="$work/run/munged.log" --seed-file="$work/run/seed"
  cat >slurm.conf <<END
ClusterName=one
SlurmctldHost=$host(127.0.0.1)
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
AuthInfo=socket=$work/run/munge.socket
CredType=cred/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/run/slurmctld.pid
SlurmdPidFile=$work/run/slurmd.pid
SlurmctldLogFile=$work/run/slurmctld.log
SlurmdLogFile=$work/run/slurmd.log
SlurmctldPort=$((20000 + $$ % 20000))
SlurmdPort=$((40000 + $$ % 20000))
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
  export SLURM_CONF=$work/slurm.conf
  slurmctld -c && slurmd -c || return
  local second
  for second in {1..20}; do
    [ "$(sinfo --noheader --format=%T 2>/dev/null)" != idle ] || return 0
    sleep 1
  done
  return 1
}

slurm() {
  PATH=$PATH:/usr/sbin
  skip_without munged slurmctld slurmd sbatch
  # A machine that lends neither ports nor process groups has no cluster on it.
  begin_slurm || {
    tail --lines=3 run/*.log
    echo "SKIPPED: no cluster could be begun here"
    exit 77
  }
  block_of 3 >sweep.sh
  grep --quiet '^#SBATCH --array=1-8$' sweep.sh
  sbatch sweep.sh >/dev/null
  for second in {1..120}; do # sbatch --wait looks but twice a minute
    [ -n "$(squeue --noheader)" ] || break
    sleep 1
  done
  [ "$(cat ?.jsonl | wc -l)" -eq 16 ] || { tail run/*.log slurm-*.out && exit 1; }
  foldless bench --merge ?.jsonl -o tables >/dev/null
  expect_same "${few[@]}"
}

case $mode in parallel) parallel_ ;; killed | slurm) "$mode" ;; esac
