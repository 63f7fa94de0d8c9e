"""Runs, tables, gates and reports in this process; and the command line tool."""

import os
import signal
import subprocess
import sys
import threading
import time

import pytest

import predicament
from predicament import Run, ToolError, tool


@pytest.fixture(scope="module")
def done():
    return predicament.run("decimals", backends=["exact", "naive"])


def test_tables_are_typed(done):
    summary = done.table("summary")
    assert done.code in (0, 100) and "answers judged" in done.text
    assert {row["backend"] for row in summary} == {"exact", "naive"}
    assert all(isinstance(row["queries"], int) for row in summary)
    assert sum(row["sign_flip"] + row["overreach"] + row["missed_zero"] for row in summary if row["backend"] == "exact") == 0
    findings = done.table("findings")
    assert findings and {row["backend"] for row in findings} == {"naive"}
    assert all(row["log2_relative_det"] is None or isinstance(row["log2_relative_det"], float) for row in findings)
    assert {"summary", "findings"} <= set(done.tables)
    assert Run(done.folder).table() == summary and "<td>naive</td>" in done._repr_html_()
    with pytest.raises(ValueError, match="has no table 'nothing'"):
        done.table("nothing")
    with pytest.raises(FileNotFoundError):
        Run(done.folder.parent)


def test_gates(done, tmp_path):
    gate = done.gate()
    assert gate and "rows" in gate.text
    nothing = tmp_path / "expected.toml"
    nothing.write_text("")
    strict = done.gate(expected=nothing)
    assert not strict and strict.code == 100 and "unexpected" in strict.text, "naive is wrong, and nobody expects it"


def test_reports_are_pages(done, tmp_path):
    report = done.report()
    assert report.html.lstrip().lower().startswith("<!doctype html") and "naive" in report.markdown
    shown = report._repr_html_()
    assert shown.startswith("<iframe srcdoc=") and "<script" not in shown, "the page is quoted"
    assert report.save(tmp_path / "report").read_text() == report.html


def test_folders_stay_where_they_are_named(tmp_path):
    folder = tmp_path / "run"
    predicament.run("filters", backends="exact", out=folder)
    assert (folder / "summary.csv").exists()
    own = tmp_path / "own.toml"
    own.write_text('title = "own"\n[[scene]]\nname = "mine"\ntask = "orient2d"\npoints = [[0, 0], [1, 0], [0, 1]]\n')
    assert predicament.run(own, backends=["exact"]).table()[0]["scene"] == "mine"
    kept = predicament.run(own, backends=["exact"])
    folder = kept.folder
    assert folder.exists()
    del kept
    assert not folder.exists(), "a folder without a name goes with its run"


def test_failures_are_exceptions_and_other_codes_are_results():
    for args, code in [(("run", "no-such-suite"), 2), (("frobnicate",), 2), (("run", "filters", "-f", "^nothing$"), 4)]:
        with pytest.raises(ToolError) as error:
            tool(*args)
        assert error.value.code == code and str(error.value)
        assert tool(*args, check=False).code == code
    wrong = tool("ask", "orient2d", "0.5,0x1.0000000000001p-1", "12,12", "24,24", "-b", "exact,naive")
    assert wrong.code == 100 and "overreach" in wrong.out and wrong.err.endswith("exit code 100\n")
    assert "Exit codes" in tool("--help").out and tool("--version").out.strip().endswith(predicament.__version__)


def test_calls_from_threads_wait_for_each_other():
    results = []
    one = lambda word: results.append(tool("ask", "orient2d", "0,0", "1,0", f"0,{word}", "-b", "exact").out)  # noqa: E731
    threads = [threading.Thread(target=one, args=(word,)) for word in ("1", "-1", "0")]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sorted(result.split("exact value")[1].split()[0] for result in results) == ["+", "-", "0"]


def test_a_process_keeps_its_pool_of_threads(tmp_path):
    predicament.cases("orient2d", n=10)
    tool("run", "filters", "-b", "exact", "--out", tmp_path / "one")
    with pytest.raises(ToolError, match="--threads: this process already has a pool of"):
        tool("run", "filters", "--threads", "77", "--out", tmp_path / "two")


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
def test_ctrl_c_stops_a_run_and_stays_with_python(tmp_path):
    folder = tmp_path / "run"

    def press():
        while not (folder / "summary.csv").exists():
            time.sleep(0.01)
        os.kill(os.getpid(), signal.SIGINT)

    presser = threading.Thread(target=press)
    presser.start()
    with pytest.raises(KeyboardInterrupt):
        predicament.run(out=folder)
    presser.join()
    assert Run(folder).table() is not None, "finished scenes are kept"
    assert tool("--version").code == 0, "the next call is not stopped"
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def program(*args, **keys):
    return subprocess.run([sys.executable, "-m", "predicament", *args], capture_output=True, text=True, timeout=60, **keys)


def test_the_program_keeps_exit_codes_and_streams(tmp_path):
    asked = program("ask", "orient2d", "0.5,0x1.0000000000001p-1", "12,12", "24,24", "-b", "exact,naive")
    assert asked.returncode == 100 and "overreach" in asked.stdout and asked.stderr.endswith("exit code 100\n")
    wrong = program("run", "no-such-suite")
    assert wrong.returncode == 2 and wrong.stdout == "" and wrong.stderr.startswith("predicament: ")
    usage = program("run", "--no-such-option")
    assert usage.returncode == 2 and "Usage: predicament run" in usage.stderr
    shown = program("--version")
    assert shown.returncode == 0 and shown.stdout.strip() == f"predicament {predicament.__version__}"
    run = program("run", "filters", "-f", "orient2d", "-b", "exact,naive", "--out", str(tmp_path / "run"))
    assert run.returncode == 0
    assert "naive" in {row["backend"] for row in Run(tmp_path / "run").table()}


def test_the_program_starts_itself_as_a_worker(tmp_path):
    """A scene in a separate process is one of Python, with the tool inside."""
    words = ["run", "filters", "-f", "orient2d", "-b", "exact", "--isolate", "--out"]
    run = program(*words, str(tmp_path / "apart"))
    assert run.returncode == 0, run.stderr
    assert program(*[word for word in words if word != "--isolate"], str(tmp_path / "here")).returncode == 0
    rows = [Run(tmp_path / name).table() for name in ("apart", "here")]
    assert [row["agree"] for row in rows[0]] == [row["agree"] for row in rows[1]]
    assert tool(*words, str(tmp_path / "called")).code == 0


def test_numpy_is_not_loaded_by_the_program():
    code = "import sys, predicament.__main__; print('numpy' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout == "False\n"
