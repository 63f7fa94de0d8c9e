//! CSV, Markdown, JUnit, HTML, plots and pixel maps.
