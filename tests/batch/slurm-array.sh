#!/usr/bin/env bash
# src/samples/batch/slurm-array.sh under a real controller and a real node, both started here for the purpose: a task that is
# requeued half-way, one that is killed and submitted again, and the bytes of one machine in the end.
set -euo pipefail
# shellcheck source=tests/batch/common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

need munged slurmctld slurmd sbatch scontrol squeue
[ "$(id -u)" -eq 0 ] || skip "only root may run slurmd without further ado"

free_port() {
    local port
    while port=$((20000 + RANDOM % 10000)) && (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null; do :; done
    echo "$port"
}

start_slurm() {
    local slurm=$work/slurm host
    host=$(hostname -s)
    mkdir -p "$slurm/state" "$slurm/spool"
    (umask 077 && head -c 1024 /dev/urandom >"$slurm/munge.key")
    cat >"$slurm/slurm.conf" <<END
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$slurm/munge.socket
SlurmctldPidFile=$slurm/slurmctld.pid
SlurmdPidFile=$slurm/slurmd.pid
StateSaveLocation=$slurm/state
SlurmdSpoolDir=$slurm/spool
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
MpiDefault=none
MailProg=/bin/true
KillWait=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
SlurmdParameters=config_overrides
END
    export SLURM_CONF=$slurm/slurm.conf
    munged --foreground --force --key-file="$slurm/munge.key" --socket="$slurm/munge.socket" \
        --pid-file="$slurm/munged.pid" --seed-file="$slurm/munge.seed" >"$slurm/munged.log" 2>&1 &
    servers+=($!)
    until_true 30 test -S "$slurm/munge.socket" || fail "munged does not start"
    slurmctld -D >"$slurm/slurmctld.log" 2>&1 &
    servers+=($!)
    slurmd -D >"$slurm/slurmd.log" 2>&1 &
    servers+=($!)
    until_true 60 node_is_idle || fail "the node does not come up"
}

node_is_idle() { sinfo --noheader --format=%t | grep -qx idle; }
queue_is_empty() { [ -z "$(squeue --noheader)" ]; }
# Of the meshes of the task that will be killed, one is done: `part` has them all.
has_begun() {
    local mesh
    for mesh in part/*/*.mesh; do
        [ ! -e "out/${mesh#part/}" ] || return 0
    done
    return 1
}

# state_of TASK
state_of() { scontrol show job "$1" 2>/dev/null | sed -n 's/^ *JobState=\([A-Z]*\).*/\1/p' | head -n 1; }
is_pending() { [ "$(state_of "$1")" = PENDING ]; }

submit() { sbatch --parsable "--array=$1" "$samples/slurm-array.sh" 4 in out; }

lodsmith generate in -o part --shard 2/4 >/dev/null 2>&1 || fail "one machine cannot make a part"
start_slurm
job=$(submit 1-4)
until_true 60 has_begun || fail "the second task makes nothing"
# Two of the four run at a time, on two processors. One is requeued, the other one killed.
[ "$(state_of "${job}_1")$(state_of "${job}_2")" = RUNNINGRUNNING ] || fail "the tasks were too fast to be disturbed"
scontrol requeue "${job}_1"
kill_shards 2/4
until_true 60 is_pending "${job}_1" || fail "the task is not requeued"
scontrol update "jobid=${job}_1" StartTime=now # rather than in two minutes
until_true 120 queue_is_empty || fail "the array does not end"
grep -q "DUE TO JOB REQUEUE" "lodsmith-$job-1.log" || fail "the task was not running when it was requeued"
diff -r clean out >/dev/null 2>&1 && fail "the task that was killed has left nothing undone"

again=$(submit 2)
until_true 120 queue_is_empty || fail "the task that was lost does not end"
grep -qE '[1-9][0-9]* made, [1-9][0-9]* up to date, 0 failed' "lodsmith-$again-2.log" \
    || fail "the task that was lost does everything again, or nothing"
same_as_clean
lodsmith generate in -o out --json >report.jsonl 2>sum || fail "something is missing"
grep -q '^0 made' sum || fail "the tasks have left something undone: $(<sum)"
