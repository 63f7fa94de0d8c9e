//! `env.json`: the machine, compiler and versions of a run.
//!
//! Timings mean nothing without the machine, and floating-point answers may depend on the CPU features that the
//! compiler was allowed to use.

use std::collections::BTreeMap;
use std::time::{SystemTime, UNIX_EPOCH};

use crate::moment;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

/// The machine, the compiler and the command.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Env {
    /// The time when the run began, in UTC: `2026-01-31T23:59:59Z`; `None` in folders of versions that did not record
    /// it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub started: Option<String>,
    /// The processor's name; `None` if the system does not report it.
    pub cpu: Option<String>,
    /// The number of threads that the process may run at once; `None` if unknown.
    pub cores: Option<u64>,
    /// The operating system and architecture, such as `linux x86_64`.
    pub os: String,
    /// The compiler's version, `rustc -V`; `None` if unknown.
    pub rustc: Option<String>,
    /// The CPU features that the compiler was allowed to use everywhere.
    pub compiled_features: Vec<String>,
    /// The CPU features that the processor has, among those that matter here.
    pub detected_features: Vec<String>,
    /// The profile that the tool was built with and the compiler's flags; `None` if unknown.
    pub opt_flags: Option<String>,
    /// The commit that the tool was built from; `None` if it was built outside of its repository, and in folders of
    /// versions that did not record it.
    #[serde(default)]
    pub commit: Option<String>,
    /// True if the files that the tool was built from differed from that commit; `None` if `commit` is `None`.
    #[serde(default)]
    pub dirty: Option<bool>,
    /// The frequency governor of the first core when the run began, such as `performance`; `None` if the system does
    /// not report it.
    #[serde(default)]
    pub governor: Option<String>,
    /// The machine's name; `None` if the system does not report it, and in folders of versions that did not record it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub node: Option<String>,
    /// The parts of a merged run, each with the name of its machine.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub parts: Vec<String>,
    /// The hash of the work plan of this run; `None` if there was no such plan.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub plan: Option<String>,
    /// True if debug assertions were compiled in: such timings are worthless.
    pub debug_assertions: bool,
    /// The version of the tool.
    pub package_version: String,
    /// The command line, argument by argument.
    pub command_line: Vec<String>,
    /// The versions of the libraries that the tool is compared with, by name.
    pub peers: BTreeMap<String, String>,
}

impl Env {
    /// The facts that the process can find out about its machine. The other fields are left empty for the caller: the
    /// compiler, its flags, the commit, and the peers.
    #[must_use]
    pub fn collect(package_version: &str) -> Env {
        Env {
            started: SystemTime::now().duration_since(UNIX_EPOCH).ok().map(|since| moment::text(since.as_secs())),
            cpu: std::fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| cpu_model(&text)),
            cores: std::thread::available_parallelism().ok().and_then(|n| u64::try_from(n.get()).ok()),
            os: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
            rustc: None,
            compiled_features: names(&compiled()),
            detected_features: names(&detected()),
            opt_flags: None,
            commit: None,
            dirty: None,
            governor: std::fs::read_to_string(GOVERNOR).ok().and_then(|text| trimmed(&text)),
            node: std::fs::read_to_string("/proc/sys/kernel/hostname").ok().and_then(|text| trimmed(&text)),
            parts: Vec::new(),
            plan: None,
            debug_assertions: cfg!(debug_assertions),
            package_version: package_version.to_owned(),
            command_line: std::env::args_os().map(|arg| arg.to_string_lossy().into_owned()).collect(),
            peers: BTreeMap::new(),
        }
    }
}

impl Env {
    /// The id of the machine's kind: twelve hex digits of a digest of processor, cores and system.
    ///
    /// Times from different kinds must not be compared. The machine's name is not included, as hosts of build services
    /// get a new one every night.
    #[must_use]
    pub fn fingerprint(&self) -> String {
        let cores = self.cores.map(|cores| cores.to_string());
        let mut sum = Sha256::new();
        for part in [self.cpu.as_deref(), cores.as_deref(), Some(&*self.os)] {
            sum.update(part.unwrap_or_default().as_bytes());
            sum.update([0]);
        }
        sum.finalize().iter().take(6).map(|byte| format!("{byte:02x}")).collect()
    }

    /// The properties that two runs must share for their times to be compared, by name: the machine's kind, and how the
    /// tool was compiled for it.
    ///
    /// The machine's name is not among them: two machines of one kind are comparable, and a container gets a new name
    /// each time.
    #[must_use]
    pub fn comparable(&self) -> [(&'static str, String); 7] {
        let unknown = || "unknown".to_owned();
        [
            ("processor", self.cpu.clone().unwrap_or_else(unknown)),
            ("cores", self.cores.map_or_else(unknown, |cores| cores.to_string())),
            ("system", self.os.clone()),
            ("features", self.detected_features.join(" ")),
            ("frequency governor", self.governor.clone().unwrap_or_else(unknown)),
            ("flags", self.opt_flags.clone().unwrap_or_else(unknown)),
            ("debug assertions", self.debug_assertions.to_string()),
        ]
    }
}

/// The file in which Linux reports the frequency governor of the first core.
const GOVERNOR: &str = "/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor";

/// A line without its line end and blanks; `None` if the rest is empty.
fn trimmed(line: &str) -> Option<String> {
    let line = line.trim();
    (!line.is_empty()).then(|| line.to_owned())
}

/// The first `model name` of a Linux `/proc/cpuinfo`.
fn cpu_model(cpuinfo: &str) -> Option<String> {
    let lines = cpuinfo.lines().filter_map(|line| line.split_once(':'));
    let mut models = lines.filter(|(key, _)| key.trim() == "model name").map(|(_, model)| model.trim());
    models.find(|model| !model.is_empty()).map(str::to_owned)
}

fn names(features: &[(&str, bool)]) -> Vec<String> {
    features.iter().filter(|(_, present)| *present).map(|(name, _)| (*name).to_owned()).collect()
}

fn compiled() -> [(&'static str, bool); 4] {
    [
        ("avx2", cfg!(target_feature = "avx2")),
        ("avx512f", cfg!(target_feature = "avx512f")),
        ("fma", cfg!(target_feature = "fma")),
        ("neon", cfg!(target_feature = "neon")),
    ]
}

#[cfg(target_arch = "x86_64")]
fn detected() -> [(&'static str, bool); 3] {
    [
        ("avx2", std::is_x86_feature_detected!("avx2")),
        ("avx512f", std::is_x86_feature_detected!("avx512f")),
        ("fma", std::is_x86_feature_detected!("fma")),
    ]
}

#[cfg(target_arch = "aarch64")]
fn detected() -> [(&'static str, bool); 2] {
    // Armv8 has a fused multiply-add in its base instruction set.
    [("fma", true), ("neon", std::arch::is_aarch64_feature_detected!("neon"))]
}

#[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
fn detected() -> [(&'static str, bool); 0] {
    []
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cpu_model_is_read_where_there_is_one() {
        let text = "processor\t: 0\nmodel\t\t: 85\nmodel name\t: Example CPU @ 2.00GHz\nflags\t\t: fpu vme\n";
        assert_eq!(cpu_model(text).as_deref(), Some("Example CPU @ 2.00GHz"));
        assert_eq!(cpu_model("processor\t: 0\nBogoMIPS\t: 243.75\n"), None);
    }

    #[test]
    fn what_is_collected_survives_json() {
        let env = Env { rustc: Some("rustc 1.89.0".to_owned()), ..Env::collect("0.1.0") };
        let json = serde_json::to_string(&env).unwrap();
        assert_eq!(serde_json::from_str::<Env>(&json).unwrap(), env);
        let built =
            Env { commit: Some("abc".to_owned()), dirty: Some(true), governor: trimmed("powersave\n"), ..env.clone() };
        let json = serde_json::to_string(&built).unwrap();
        assert!(json.contains(r#""commit":"abc","dirty":true,"governor":"powersave""#), "{json}");
        assert_eq!(serde_json::from_str::<Env>(&json).unwrap(), built);
        assert!(env.compiled_features.iter().all(|f| env.detected_features.contains(f)));
    }

    #[test]
    fn folders_made_before_the_commit_was_written_down_are_read() {
        let old = std::fs::read_to_string("../tasks/tests/data/checked/env.json").unwrap();
        assert!(!old.contains("commit"));
        let env: Env = serde_json::from_str(&old).unwrap();
        assert_eq!((env.commit, env.dirty, env.governor), (None, None, None));
        assert_eq!(trimmed(" \n"), None);
    }
}
