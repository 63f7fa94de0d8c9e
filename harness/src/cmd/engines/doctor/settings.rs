//! The settings of compilers, and the build commands of an engine with a setting.

use std::path::Path;

/// The source that sets the rounding mode before `main`.
pub const ROUNDING: &str = "predicament_doctor_rounding.c";

/// Settings of C and C++ compilers: flags, and a rounding mode of `fenv.h` or an empty text.
const C: [(&str, &str); 13] = [
    ("-O0", ""),
    ("-O2", ""),
    ("-O3", ""),
    ("-Ofast", ""),
    ("-O2 -ffast-math", ""),
    ("-O2 -ffp-contract=off", ""),
    ("-O2 -ffp-contract=fast -march=native", ""),
    ("-O2 -march=native", ""),
    ("-O2 -mfpmath=387", ""),
    ("-O2 -flto", ""),
    ("-O2", "FE_UPWARD"),
    ("-O2", "FE_DOWNWARD"),
    ("-O2", "FE_TOWARDZERO"),
];

/// Settings of cargo: a name, and a variable with its value.
const RUST: [[&str; 3]; 6] = [
    ["opt-level=0", "CARGO_PROFILE_RELEASE_OPT_LEVEL", "0"],
    ["opt-level=3", "CARGO_PROFILE_RELEASE_OPT_LEVEL", "3"],
    ["lto=fat", "CARGO_PROFILE_RELEASE_LTO", "fat"],
    ["codegen-units=1", "CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "1"],
    ["debug-assertions=true", "CARGO_PROFILE_RELEASE_DEBUG_ASSERTIONS", "true"],
    ["target-cpu=native", "RUSTFLAGS", "-C target-cpu=native"],
];

/// The prefixes of flags that a setting replaces.
const REPLACED: [&str; 6] = ["-O", "-ffast-math", "-ffp-contract", "-march", "-mfpmath", "-flto"];

/// The macro with which the helper of C++ engines accepts -ffast-math.
const DEFINED: &str = "-DPREDICAMENT_DOCTOR";

/// The compilers that a build command may call.
const COMPILERS: [&str; 6] = ["c++", "g++", "clang++", "cc", "gcc", "clang"];

/// One way to build an engine.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Setting {
    /// The engine's own build commands.
    Own,
    C {
        clang: bool,
        flags: &'static str,
        rounding: &'static str,
    },
    Rust([&'static str; 3]),
}

impl Setting {
    /// The name in the table.
    pub fn name(&self) -> String {
        match self {
            Setting::Own => "own".to_owned(),
            Setting::C { clang, flags, rounding } => {
                let compiler = if *clang { "clang " } else { "" };
                let rounding = if rounding.is_empty() { String::new() } else { format!(", {rounding}") };
                format!("{compiler}{flags}{rounding}")
            }
            Setting::Rust([name, ..]) => (*name).to_owned(),
        }
    }

    /// The settings for an engine with these build commands; empty if it is not built by a known compiler.
    pub fn of(build: &[Vec<String>], has_clang: bool) -> Vec<Setting> {
        if build.iter().any(|words| is_cargo(words)) {
            return RUST.into_iter().map(Setting::Rust).collect();
        }
        if !build.iter().any(|words| tokens(words).iter().any(|word| compiler(word).is_some())) {
            return Vec::new();
        }
        let compilers = if has_clang { &[false, true][..] } else { &[false] };
        let with = |&clang: &bool| C.into_iter().map(move |(flags, rounding)| Setting::C { clang, flags, rounding });
        compilers.iter().flat_map(with).collect()
    }

    /// The variables of the build.
    pub fn variables(&self) -> Option<(String, String)> {
        let Setting::Rust([_, key, value]) = self else { return None };
        Some(((*key).to_owned(), (*value).to_owned()))
    }

    /// The source file that the engine is linked with.
    pub fn source(&self) -> Option<String> {
        let Setting::C { rounding, .. } = self else { return None };
        let set =
            format!("__attribute__((constructor)) static void predicament_doctor(void) {{ fesetround({rounding}); }}");
        (!rounding.is_empty()).then(|| format!("#include <fenv.h>\n{set}\n"))
    }

    /// A build command with this setting. The script of `sh -c` is changed word by word.
    pub fn applied(&self, words: &[String]) -> Vec<String> {
        let Setting::C { clang, flags, rounding } = self else { return words.to_vec() };
        let all = tokens(words);
        let Some(at) = all.iter().position(|word| compiler(word).is_some()) else { return words.to_vec() };
        let mut changed: Vec<String> = all[..at].to_vec();
        let is_cpp = all[at].contains("++");
        changed.push(match (clang, is_cpp) {
            (false, _) => all[at].clone(),
            (true, true) => "clang++".to_owned(),
            (true, false) => "clang".to_owned(),
        });
        changed.extend(flags.split(' ').chain([DEFINED]).map(str::to_owned));
        let stays = |word: &&String| !REPLACED.iter().any(|prefix| word.starts_with(prefix));
        changed.extend(all[at + 1..].iter().filter(stays).cloned());
        if !rounding.is_empty() && !all.iter().any(|word| word == "-c") {
            changed.extend([ROUNDING.to_owned(), "-lm".to_owned()]);
        }
        match words {
            [shell, option, _] if option == "-c" => vec![shell.clone(), option.clone(), changed.join(" ")],
            _ => changed,
        }
    }
}

/// The words of a command, or those of the script of `sh -c`.
fn tokens(words: &[String]) -> Vec<String> {
    match words {
        [_, option, script] if option == "-c" => script.split(' ').map(str::to_owned).collect(),
        _ => words.to_vec(),
    }
}

fn compiler(word: &str) -> Option<&'static str> {
    let name = Path::new(word).file_name()?.to_str()?;
    COMPILERS.into_iter().find(|compiler| *compiler == name)
}

fn is_cargo(words: &[String]) -> bool {
    words.first().is_some_and(|word| word == "cargo") && words.iter().any(|word| word == "build")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(line: &str) -> Vec<String> {
        line.split(' ').map(str::to_owned).collect()
    }

    /// Red if a flag of the engine is left that contradicts the setting, or another flag is lost.
    #[test]
    fn a_setting_replaces_flags_of_floating_point_only() {
        let own = words("c++ -std=c++17 -O3 -march=x86-64 -ffp-contract=off -frounding-math e.cpp -o e -lm");
        let fast = Setting::C { clang: false, flags: "-O2 -ffast-math", rounding: "" };
        assert_eq!(
            fast.applied(&own),
            words("c++ -O2 -ffast-math -DPREDICAMENT_DOCTOR -std=c++17 -frounding-math e.cpp -o e -lm")
        );
        let up = Setting::C { clang: true, flags: "-O2", rounding: "FE_UPWARD" };
        let script = ["sh", "-c", "exec c++ -O2 e.cpp lib-*.so -o e"].map(str::to_owned);
        let changed = format!("exec clang++ -O2 -DPREDICAMENT_DOCTOR e.cpp lib-*.so -o e {ROUNDING} -lm");
        assert_eq!(up.applied(&script), ["sh".to_owned(), "-c".to_owned(), changed]);
        assert!(up.source().unwrap().contains("fesetround(FE_UPWARD)") && up.name() == "clang -O2, FE_UPWARD");
        assert_eq!(Setting::of(&[own], true).len(), 26);
        assert_eq!(Setting::of(&[words("cargo build --release")], false).len(), 6);
        assert!(Setting::of(&[words("make")], false).is_empty());
    }
}
