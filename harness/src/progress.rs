//! The progress bar on stderr. It is hidden without a terminal and with `--quiet`.

use std::io::IsTerminal;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// A bar over `total` units of work.
pub fn bar(total: u64, unit: &str) -> ProgressBar {
    if crate::out::is_quiet() || !std::io::stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::with_draw_target(Some(total), ProgressDrawTarget::stderr());
    let style = format!("{{elapsed_precise}} [{{bar:32}}] {{human_pos}}/{{human_len}} {unit} ({{eta}}) {{msg}}");
    if let Ok(style) = ProgressStyle::with_template(&style) {
        bar.set_style(style.progress_chars("=> "));
    }
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
