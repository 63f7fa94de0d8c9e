#!/bin/sh
# Slurm on this machine alone, to try slurm.sh: slurm-here.sh FOLDER [NODES] starts it, and prints what to set; slurm-here.sh FOLDER stop ends it
# Debian's slurm-wlm, as whoever calls this, without munge, systemd or cgroups. It is no set-up for a cluster: everybody is believed.
# Of two nodes or more each is a process namespace (root makes them): kill -9 $(cat FOLDER/node-2.pid) is the second one without power.
set -eu
mkdir -p "$1"
folder=$(cd "$1" && pwd) host=$(hostname -s) user=$(id -un) nodes=${2:-1} port=${SLURM_TRY_PORT:-16817}
if [ "$nodes" = stop ]; then
    for pid in "$folder"/slurmctld.pid "$folder"/node-*.pid; do [ -f "$pid" ] && kill -9 "$(cat "$pid")" && rm "$pid" || :; done
    exit 0
fi
mkdir -p "$folder/state"
cat >"$folder/slurm.conf" <<CONF
ClusterName=parts
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
AuthType=auth/none
CredType=cred/none
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SlurmUser=$user
SlurmdUser=$user
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool-%n
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd-%n.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd-%n.log
SlurmdTimeout=10
ReturnToService=2
$(seq "$nodes" | while read -r n; do
    echo "NodeName=node-$n NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + n)) CPUs=$(nproc) State=UNKNOWN"
done)
PartitionName=all Nodes=ALL Default=YES State=UP
CONF
export SLURM_CONF="$folder/slurm.conf"
PATH=$PATH:/usr/sbin
slurmctld -c
for n in $(seq "$nodes"); do
    alone=
    [ "$nodes" = 1 ] || alone='unshare --pid --mount-proc --fork --kill-child'
    $alone slurmd -D -c -N "node-$n" >"$folder/node-$n.out" 2>&1 &
    echo $! >"$folder/node-$n.pid"
done
for try in $(seq 50); do
    [ "$(sinfo --noheader --format=%D:%T 2>/dev/null)" = "$nodes:idle" ] && break
    sleep 0.2
done
[ "$(sinfo --noheader --format=%D:%T)" = "$nodes:idle" ] || { echo "no node, or not all; see the logs in $folder" >&2; exit 1; }
echo "export SLURM_CONF='$folder/slurm.conf'"
