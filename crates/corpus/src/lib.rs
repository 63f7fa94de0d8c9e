//! Scene format, content ids, generators, importers and the fetch manifest.
