#!/usr/bin/env python3
"""A run in N parts by HyperQueue (PyPI: hyperqueue): hyperqueue_parts.py N FOLDER [ARGUMENTS OF run...]

A server and a worker of this machine; on a cluster give `Client(server_dir)` in place of `LocalCluster`. A part whose worker is lost is
started again by HyperQueue, one that fails by this script, twice at most.
"""
import os, pathlib, subprocess, sys
from hyperqueue import Job, LocalCluster

n, folder, more = int(sys.argv[1]), pathlib.Path(sys.argv[2]).absolute(), sys.argv[3:]
folder.mkdir(parents=True, exist_ok=True)
part = str(pathlib.Path(__file__).resolve().parent / "part.sh")
environment = {name: os.environ[name] for name in ("PATH", "HOME", "PREDICAMENT") if name in os.environ}
with LocalCluster() as cluster:
    cluster.start_worker()
    for attempt in range(3):
        job = Job(default_workdir=str(folder))
        for k in range(1, n + 1):
            job.program([part, str(k), str(n), str(folder), *more], env=environment)
        if cluster.client().wait_for_jobs([cluster.client().submit(job)], raise_on_error=False):
            break
whole = [str(folder / str(k)) for k in range(1, n + 1)]
sys.exit(subprocess.call([os.environ.get("PREDICAMENT", "predicament"), "merge", *whole, "--out", str(folder / "whole")]))
