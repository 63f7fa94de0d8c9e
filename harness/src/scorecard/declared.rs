//! All checks: those that tasks declare, those common to all tasks, and the guards of the tool itself.

use predicament_oracle::guards::{Guard, guards};
use predicament_tasks::{Catch, Check, Class, ON_EVERY_TASK};

use crate::tool::Tool;

/// A check, and the tasks that use it.
#[derive(Clone, PartialEq, Debug)]
pub struct Declared {
    pub of: Of,
    /// The tasks whose judges can report the check; empty for checks of every task and for guards.
    pub tasks: Vec<&'static str>,
}

/// A check of answers, or a guard of the tool.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Of {
    Judge(Check),
    Guard(Guard),
}

impl Declared {
    pub fn name(&self) -> &'static str {
        match self.of {
            Of::Judge(check) => check.name,
            Of::Guard(guard) => guard.name,
        }
    }

    /// The class of its findings, or `None` for a guard.
    pub fn class(&self) -> Option<Class> {
        match self.of {
            Of::Judge(check) => Some(check.class),
            Of::Guard(_) => None,
        }
    }

    pub fn means(&self) -> &'static str {
        match self.of {
            Of::Judge(check) => check.means,
            Of::Guard(guard) => guard.means,
        }
    }

    /// The place where the check is used, in words.
    pub fn place(&self) -> String {
        match self.of {
            Of::Guard(guard) => guard.area.name().to_owned(),
            Of::Judge(_) if self.tasks.is_empty() => "every task".to_owned(),
            Of::Judge(_) => self.tasks.join(", "),
        }
    }

    /// True if a task uses the check.
    pub fn is_tried_in(&self, task: &str) -> bool {
        matches!(self.of, Of::Judge(_)) && (self.tasks.is_empty() || self.tasks.contains(&task))
    }

    /// True if the check is a relation that is tested only by thorough runs.
    pub fn is_thorough(&self) -> bool {
        matches!(self.of, Of::Judge(check) if check.thorough)
    }

    /// True if the command line may call the check by this text: its name, `CLASS/NAME`, or either with `TASK:` in
    /// front.
    fn is_called(&self, text: &str) -> bool {
        let name = self.name();
        let with_class = self.class().map(|class| format!("{}/{name}", class.name()));
        let of_task = |task: &str| {
            let rest = text.strip_prefix(task).and_then(|rest| rest.strip_prefix(':'));
            rest.is_some_and(|rest| rest == name || with_class.as_deref() == Some(rest))
        };
        let places = self.tasks.iter().copied().any(of_task);
        text == name || with_class.as_deref() == Some(text) || places || of_task(&self.place())
    }
}

/// Displays `sign_flip (sign)`; for a guard, the part of the tool and the guard's name.
impl std::fmt::Display for Declared {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.of {
            Of::Judge(check) => check.fmt(f),
            Of::Guard(guard) => write!(f, "{} ({})", guard.area.name(), guard.name),
        }
    }
}

/// All checks, in the order of tasks. Equal checks of several tasks are merged.
pub struct Declarations(pub Vec<Declared>);

impl Declarations {
    pub fn of(tool: &Tool) -> Declarations {
        let mut all = Declarations(Vec::new());
        for &task in tool.tasks() {
            for check in task.declared_checks() {
                all.add(check, task.name());
            }
            // For a task without declared checks, use the checks that its faults name.
            if task.declared_checks().is_empty() {
                for &(class, name) in task.spoiled_answers().iter().flat_map(|fault| fault.caught_by()) {
                    all.add(Check::new(class, name, ""), task.name());
                }
            }
        }
        let every = ON_EVERY_TASK.iter().map(|&check| Declared { of: Of::Judge(check), tasks: Vec::new() });
        all.0.extend(every);
        all.0.extend(guards().map(|guard| Declared { of: Of::Guard(guard), tasks: Vec::new() }));
        all
    }

    fn add(&mut self, check: Check, task: &'static str) {
        match self.0.iter_mut().find(|declared| declared.of == Of::Judge(check)) {
            Some(declared) => {
                if !declared.tasks.contains(&task) {
                    declared.tasks.push(task);
                }
            }
            None => self.0.push(Declared { of: Of::Judge(check), tasks: vec![task] }),
        }
    }

    /// The index of the check that a finding of a task belongs to, or `None` if it is not declared.
    pub fn find(&self, task: &str, class: Class, check: &str) -> Option<usize> {
        self.0.iter().position(|declared| match declared.of {
            Of::Judge(of) => (declared.tasks.is_empty() || declared.tasks.contains(&task)) && of.has(class, check),
            Of::Guard(_) => false,
        })
    }

    /// The index of the check that a fault in one of these tasks names.
    pub fn named_by(&self, tasks: &[&str], (class, check): Catch) -> Result<usize, String> {
        let found = tasks.iter().find_map(|task| self.find(task, class, check));
        found.ok_or_else(|| format!("{} declares no check {} ({check})", tasks.join(", "), class.name()))
    }

    /// The index of the check that a fault of a backend names: the only check of this class and name, or that of a
    /// task.
    pub fn named(&self, (class, check): Catch, task: Option<&str>) -> Result<usize, String> {
        let is = |declared: &Declared| match declared.of {
            Of::Judge(of) => of.has(class, check) && task.is_none_or(|task| declared.tasks.contains(&task)),
            Of::Guard(_) => false,
        };
        let all: Vec<usize> = (0..self.0.len()).filter(|&at| is(&self.0[at])).collect();
        match all[..] {
            [at] => Ok(at),
            [] => Err(format!("no task declares a check {} ({check})", class.name())),
            _ => Err(format!("several checks are called {} ({check})", class.name())),
        }
    }

    /// The index of the guard with this name.
    pub fn guard(&self, name: &str) -> Option<usize> {
        self.0.iter().position(|declared| matches!(declared.of, Of::Guard(guard) if guard.name == name))
    }

    /// The indices of the checks that a word of the command line names.
    pub fn called(&self, text: &str) -> Result<Vec<usize>, String> {
        let all: Vec<usize> = (0..self.0.len()).filter(|&at| self.0[at].is_called(text)).collect();
        if all.is_empty() {
            return Err(format!(
                "no check is called `{text}`; write a name, CLASS/NAME, or TASK:CLASS/NAME from `{} setup selftest --checks`",
                crate::out::program()
            ));
        }
        Ok(all)
    }
}

/// Checks that no fault has to need, with the reason: by class, task and name; without a name, all of a class.
const NOT_NEEDED: &[(Class, &str, &str, &str)] = &[
    (
        Class::Declined,
        "",
        "",
        "a refusal is not a wrong answer: reports count and show it, and do not compare its scene",
    ),
    (
        Class::Panic,
        "",
        "",
        "a fault would end this process; tests of `run --isolate` and of engines plant it in separate processes",
    ),
    (Class::Refused, "", "", "an error is not a wrong answer; tests of engines plant one in a program"),
    (Class::Accepted, "", "", "programs alone get invalid input; a test of engines plants the answer in a program"),
    (
        Class::Timeout,
        "",
        "",
        "a fault would run until its time limit; tests of `run --isolate` and of engines plant it in separate \
         processes",
    ),
    (
        Class::SignFlip,
        "polygon-locate",
        "exact location",
        "the checks `gap`, `double` and `misplaced` find the same faults",
    ),
    (
        Class::Topology,
        "cube-union",
        "part",
        "at level quick, every embedded scene has few enough cubes to be measured as a whole; a test of the oracle \
         plants the fault",
    ),
    (
        Class::Topology,
        "mesh-locate",
        "tetrahedron",
        "it compares two truths of the judge; an answer cannot make them differ",
    ),
];

/// The reason why no fault has to need a check, if there is one.
pub fn not_needed(declared: &Declared) -> Option<&'static str> {
    let class = declared.class()?;
    let is = |&&(of, task, name, _): &&(Class, &str, &str, &str)| {
        let is_of = task.is_empty() || declared.tasks.contains(&task);
        of == class && is_of && (name.is_empty() || name == declared.name())
    };
    NOT_NEEDED.iter().find(is).map(|(.., why)| *why)
}
