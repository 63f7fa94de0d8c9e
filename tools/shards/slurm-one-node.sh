#!/bin/sh
# Slurm on this machine alone, to try slurm.sh: slurm-one-node.sh FOLDER starts it, and prints what to set; slurm-one-node.sh FOLDER stop ends it
# Debian's slurm-wlm, as whoever calls this, without munge, systemd or cgroups. It is no set-up for a cluster: everybody is believed.
set -eu
mkdir -p "$1"
folder=$(cd "$1" && pwd) host=$(hostname -s) user=$(id -un)
if [ "${2:-}" = stop ]; then
    for pid in "$folder"/slurmd.pid "$folder"/slurmctld.pid; do [ -f "$pid" ] && kill "$(cat "$pid")" || :; done
    exit 0
fi
mkdir -p "$folder/state" "$folder/spool"
cat >"$folder/slurm.conf" <<CONF
ClusterName=parts
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=${SLURM_TRY_PORT:-16817}
SlurmdPort=$((${SLURM_TRY_PORT:-16817} + 1))
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
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ReturnToService=2
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES State=UP
CONF
export SLURM_CONF="$folder/slurm.conf"
PATH=$PATH:/usr/sbin
slurmctld -c && slurmd -c
for try in $(seq 50); do
    [ "$(sinfo --noheader --format=%T 2>/dev/null)" = idle ] && break
    sleep 0.2
done
[ "$(sinfo --noheader --format=%T)" = idle ] || { echo "the node does not come up; see $folder/slurmctld.log" >&2; exit 1; }
echo "export SLURM_CONF='$folder/slurm.conf'"
