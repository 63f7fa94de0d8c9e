//! Licence notices of the libraries that are embedded in a page.
//!
//! Tabulator and uPlot are under the MIT licence, which requires the notice in every copy. A written page is a copy.

/// A library in `web/vendor`: its name, its files and the text of its licence.
struct Library {
    name: &'static str,
    files: &'static [&'static str],
    licence: &'static str,
}

/// All libraries in `web/vendor`.
const LIBRARIES: [Library; 3] = [
    Library { name: "Tabulator", files: &["tabulator.js"], licence: include_str!("../web/vendor/tabulator.LICENSE") },
    Library { name: "uPlot", files: &["uplot.js", "uplot.css"], licence: include_str!("../web/vendor/uplot.LICENSE") },
    Library { name: "OGL", files: &["ogl.js"], licence: include_str!("../web/vendor/ogl.LICENSE") },
];

/// The notices of all libraries, as one HTML comment.
///
/// Every page gets all of them: an unnecessary notice does no harm, a missing one breaks a licence.
pub(crate) fn comment() -> String {
    let notices = LIBRARIES.iter().map(|library| {
        format!("\n{} ({}):\n\n{}\n", library.name, library.files.join(", "), library.licence.trim_end())
    });
    format!(
        "<!-- This page contains minified code of these libraries, under their licences.\n{}-->",
        notices.collect::<String>()
    )
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::path::Path;

    use super::*;
    use crate::drawing::{self, Drawing};
    use crate::web;

    /// The code files in `web/vendor`, with their texts.
    fn vendored() -> Vec<(String, String)> {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("web/vendor");
        let paths = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
        let code = paths.filter(|path| path.extension().is_some_and(|end| end == "js" || end == "css"));
        code.map(|path| {
            (path.file_name().unwrap().to_string_lossy().into_owned(), std::fs::read_to_string(&path).unwrap())
        })
        .collect()
    }

    /// The vendored files that this code contains and whose licence is missing from the page.
    fn unnoticed(code: &str, page: &str) -> BTreeSet<String> {
        let has_notice = |file: &str| {
            let library = LIBRARIES.iter().find(|library| library.files.contains(&file));
            library.is_some_and(|of| page.contains(of.licence.trim_end()) && page.contains(&of.files.join(", ")))
        };
        let contained = vendored().into_iter().filter(|(_, text)| code.contains(text));
        contained.map(|(file, _)| file).filter(|file| !has_notice(file)).collect()
    }

    #[test]
    fn every_vendored_file_has_its_notice_in_the_report_and_in_a_view() {
        let report = crate::html(&[], &[], &[]).unwrap();
        // The libraries of a report are embedded in compressed form.
        let code = [&web::LIBRARIES.concat(), web::STYLE].concat();
        assert!(vendored().len() >= 4 && vendored().iter().all(|(_, text)| code.contains(text)), "all are in a report");
        assert_eq!(unnoticed(&code, &report), BTreeSet::new());
        let view = Drawing { is_space: true, layers: vec![] }.page("a view").unwrap();
        assert!(view.contains(drawing::SCRIPTS[0]) && view.contains(web::STYLE), "a view contains OGL and the style");
        assert_eq!(unnoticed(&view, &view), BTreeSet::new());
    }

    #[test]
    fn a_missing_notice_is_seen() {
        let code = web::LIBRARIES.concat();
        for library in &LIBRARIES {
            let page = comment().replace(library.licence.trim_end(), "");
            let script = library.files[0].to_owned();
            assert!(unnoticed(&code, &page).contains(&script), "{script}");
        }
    }

    #[test]
    fn the_comment_ends_at_its_end() {
        let comment = comment();
        let inside = comment.strip_prefix("<!--").and_then(|text| text.strip_suffix("-->")).unwrap();
        assert!(!inside.contains("--"), "HTML allows no two hyphens within a comment");
        assert!(
            inside.contains("Copyright (c) 2015-2026 Oli Folkerd")
                && inside.contains("Copyright (c) 2022 Leon Sorokin")
        );
    }
}
