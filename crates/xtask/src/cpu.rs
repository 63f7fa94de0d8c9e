//! Processor time: the cost of a step, independent of other load.

/// The seconds of processor time of all ended children and their children; Linux only.
pub fn of_children() -> Option<f64> {
    parse(&std::fs::read_to_string("/proc/self/stat").ok()?)
}

/// Sums fields 16 and 17 of `/proc/self/stat`, in hundredths of a second.
///
/// The second field is the command, in brackets, and may contain anything.
fn parse(stat: &str) -> Option<f64> {
    let (_, rest) = stat.rsplit_once(')')?;
    let mut fields = rest.split_ascii_whitespace().skip(13);
    let [user, system] = [fields.next()?.parse::<u32>().ok()?, fields.next()?.parse::<u32>().ok()?];
    Some((f64::from(user) + f64::from(system)) / 100.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fields_of_children_are_read() {
        let stat = "42 (a ) b) S 1 42 42 0 -1 4194304 100 200 0 0 7 8 1250 350 20 0 1 0 12345";
        assert_eq!(parse(stat), Some(16.0));
        assert_eq!(parse("42 (xtask) S 1"), None);
    }
}
