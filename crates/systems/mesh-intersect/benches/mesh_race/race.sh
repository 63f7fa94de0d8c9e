#!/usr/bin/env bash
# The race of the bench `mesh_race`: builds the peers, fetches the meshes and starts the bench.
#
#     crates/systems/mesh-intersect/benches/mesh_race/race.sh FOLDER [--pairs N] [--seed S] [--cap SECONDS]
#
# FOLDER gets programs, packages, meshes and times. The peers are CGAL of the system, and the libraries of the engines
# `manifold`, `trueform`, `igl-tasks` and `geogram-solids`; the engine `trimesh` has the reader of files. They are
# installed before (`predicament engines install`); `$PREDICAMENT_ENGINES` is their folder.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
engines=$(cd "${PREDICAMENT_ENGINES:-$here/../../../../../engines}" && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd)
shift

if [ ! -x "$folder/cgal" ]; then
    c++ -std=c++17 -O2 -DNDEBUG -ffp-contract=off -frounding-math "$here/cgal.cpp" -o "$folder/cgal" -lmpfr -lgmp
fi
packages=$engines/geogram-solids/packages
if [ ! -x "$folder/geogram" ]; then
    c++ -std=c++17 -O2 -ffp-contract=off -fopenmp -DGEO_NO_PARALLEL_STL -I "$here/../../../../../engines/include" \
        -isystem "$packages/include/geogram1" "$here/geogram.cpp" -o "$folder/geogram" -L"$packages/lib64" -lgeogram \
        "$packages"/geogram.libs/libtbb-*.so.2 -Wl,-rpath,"$packages/geogram.libs" -ldl
fi
if [ ! -f "$folder/meshes/meshes.csv" ]; then
    "$engines/trimesh/venv/bin/python" "$here/meshes.py" "$folder/meshes" "$folder/cgal"
fi

peers="cgal=$folder/cgal;geogram=$folder/geogram"
for library in manifold trueform; do
    peers="$library=$engines/$library/venv/bin/python $here/peers.py $library;$peers"
done
peers="$peers;libigl=$engines/igl-tasks/venv/bin/python $here/peers.py igl"
cd "$here"
MESH_RACE_PROGRAMS=$peers cargo bench -p predicament-benches --bench mesh_race -- \
    --meshes "$folder/meshes" --out "$folder" "$@"
