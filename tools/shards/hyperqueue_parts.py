#!/usr/bin/env python3
"""A run in N parts by HyperQueue (PyPI: hyperqueue): hyperqueue_parts.py N FOLDER [ARGUMENTS OF plan...]

A server and a worker of this machine; on a cluster give `Client(server_dir)` in place of `LocalCluster`. A part whose worker is lost is
started again by HyperQueue; a part that dies fails, and is submitted again, twice at most.
"""
import os, pathlib, subprocess, sys
from hyperqueue import Job, LocalCluster

n, folder, more = int(sys.argv[1]), pathlib.Path(sys.argv[2]).absolute(), sys.argv[3:]
here, tool = pathlib.Path(__file__).resolve().parent, os.environ.get("PREDICAMENT", "predicament")
folder.mkdir(parents=True, exist_ok=True)
if not (folder / "plan.json").exists():
    subprocess.check_call([tool, "plan", *more, "--shards", str(n), "--out", str(folder / "plan.json")])
left = list(range(1, n + 1))
with LocalCluster() as cluster:
    cluster.start_worker()
    client = cluster.client()
    for attempt in range(3):
        job = Job(default_workdir=folder, default_env=dict(os.environ), max_fails=None)
        tasks = {job.program([str(here / "part.sh"), str(k), str(n), str(folder)]).task_id: k for k in left}
        submitted = client.submit(job)
        if client.wait_for_jobs([submitted], raise_on_error=False):
            break
        left = [tasks[task] for task in client.get_failed_tasks(submitted)]
        print("died, and is submitted again:", *left, flush=True)
whole = [str(folder / str(k)) for k in range(1, n + 1)]
sys.exit(subprocess.call([tool, "merge", *whole, "--out", str(folder / "whole")]))
