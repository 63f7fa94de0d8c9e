//! The places of a file that can change, and the text that lets each change at run time.
//!
//! A comparison, and a condition of an `if`, a `while` or a guard, is wrapped in `seen`: it notes each outcome, and turns
//! it over if its switch is on. Other changes are chosen by `on`. An edit is made of pieces, because edits nest.

use std::ops::Range;

use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{BinOp, Expr, Stmt, UnOp};

/// A possible change.
#[derive(Clone, Debug)]
pub struct Switch {
    pub line: usize,
    pub column: usize,
    /// The change in words, such as `< becomes <=`.
    pub what: String,
    /// The text that changes, on one line.
    pub text: String,
    /// True if both outcomes can be noted: a comparison or a condition.
    pub has_outcomes: bool,
}

/// A part of a replacement.
#[derive(Clone, Debug)]
pub enum Piece {
    Text(String),
    /// Bytes of the file, with their own edits.
    Source(Range<usize>),
}

/// A replacement of some bytes, for one switch.
#[derive(Clone, Debug)]
pub struct Edit {
    pub range: Range<usize>,
    pub pieces: Vec<Piece>,
    pub number: usize,
}

/// The switches of a file, numbered from `first`, without those of `dropped`, and their edits.
///
/// # Errors
/// If the file is not Rust.
pub fn of(text: &str, first: usize, dropped: &[usize]) -> Result<(Vec<Switch>, Vec<Edit>), syn::Error> {
    let file = syn::parse_file(text)?;
    let mut finder = Finder { text, first, dropped, switches: Vec::new(), edits: Vec::new() };
    finder.visit_file(&file);
    Ok((finder.switches, finder.edits))
}

struct Finder<'a> {
    text: &'a str,
    first: usize,
    dropped: &'a [usize],
    switches: Vec<Switch>,
    edits: Vec<Edit>,
}

fn bytes(of: &impl Spanned) -> Range<usize> {
    of.span().byte_range()
}

fn text(of: &str) -> Piece {
    Piece::Text(of.to_owned())
}

/// The operator that takes the place of another, if there is one.
fn other(op: &BinOp) -> Option<[&'static str; 2]> {
    Some(match op {
        BinOp::Lt(_) => ["<", "<="],
        BinOp::Le(_) => ["<=", "<"],
        BinOp::Gt(_) => [">", ">="],
        BinOp::Ge(_) => [">=", ">"],
        BinOp::Add(_) => ["+", "-"],
        BinOp::Sub(_) => ["-", "+"],
        BinOp::Mul(_) => ["*", "+"],
        BinOp::And(_) => ["&&", "||"],
        BinOp::Or(_) => ["||", "&&"],
        _ => return None,
    })
}

fn is_comparison(op: &BinOp) -> bool {
    use BinOp::{Eq, Ge, Gt, Le, Lt, Ne};
    matches!(op, Lt(_) | Le(_) | Gt(_) | Ge(_) | Eq(_) | Ne(_))
}

/// True if the expression has a `let`, which stands in chains of conditions alone.
fn has_let(expr: &Expr) -> bool {
    match expr {
        Expr::Let(_) => true,
        Expr::Binary(binary) => has_let(&binary.left) || has_let(&binary.right),
        _ => false,
    }
}

impl Finder<'_> {
    /// Adds a switch, and its edit unless it is dropped.
    fn add(&mut self, at: &impl Spanned, what: String, has_outcomes: bool, pieces: impl FnOnce(usize) -> Vec<Piece>) {
        let number = self.first + self.switches.len();
        let start = at.span().start();
        let text = self.text[bytes(at)].split_whitespace().collect::<Vec<_>>().join(" ");
        self.switches.push(Switch { line: start.line, column: start.column + 1, what, text, has_outcomes });
        if !self.dropped.contains(&number) {
            self.edits.push(Edit { range: bytes(at), pieces: pieces(number), number });
        }
    }

    fn outcome(&mut self, expr: &Expr) {
        let what = match expr {
            Expr::Binary(_) => "comparison turned over",
            _ => "condition turned over",
        };
        self.add(expr, what.to_owned(), true, |number| {
            vec![Piece::Text(format!("crate::switch::seen({number}, ")), Piece::Source(bytes(expr)), text(")")]
        });
    }

    /// Wraps the parts of a condition that are not wrapped as comparisons.
    fn condition(&mut self, expr: &Expr) {
        match expr {
            Expr::Let(_) => {}
            Expr::Binary(binary) if matches!(binary.op, BinOp::And(_) | BinOp::Or(_)) => {
                self.condition(&binary.left);
                self.condition(&binary.right);
            }
            Expr::Binary(binary) if is_comparison(&binary.op) => {}
            Expr::Paren(inner) => self.condition(&inner.expr),
            other => self.outcome(other),
        }
    }
}

/// True for an item that is part of tests, or text for people.
fn is_apart(attrs: &[syn::Attribute]) -> bool {
    attrs.iter().any(|attr| attr.path().is_ident("test") || attr.path().is_ident("cfg"))
}

impl<'ast> Visit<'ast> for Finder<'_> {
    fn visit_attribute(&mut self, _: &'ast syn::Attribute) {}
    fn visit_pat(&mut self, pat: &'ast syn::Pat) {
        if let syn::Pat::Guard(guarded) = pat {
            self.condition(&guarded.guard);
            self.visit_expr(&guarded.guard);
        }
    }
    fn visit_type(&mut self, _: &'ast syn::Type) {}
    fn visit_item_const(&mut self, _: &'ast syn::ItemConst) {}
    fn visit_impl_item_const(&mut self, _: &'ast syn::ImplItemConst) {}
    fn visit_item_static(&mut self, _: &'ast syn::ItemStatic) {}
    fn visit_item_enum(&mut self, _: &'ast syn::ItemEnum) {}

    fn visit_item_mod(&mut self, item: &'ast syn::ItemMod) {
        if !is_apart(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }

    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        if !is_apart(&item.attrs) && item.sig.constness.is_none() {
            visit::visit_item_fn(self, item);
        }
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        if item.sig.constness.is_none() {
            visit::visit_impl_item_fn(self, item);
        }
    }

    fn visit_item_impl(&mut self, item: &'ast syn::ItemImpl) {
        let last = item.trait_.as_ref().and_then(|(path, _)| path.segments.last());
        if last.is_none_or(|name| !["Debug", "Display", "Error"].contains(&name.ident.to_string().as_str())) {
            visit::visit_item_impl(self, item);
        }
    }

    fn visit_expr_if(&mut self, expr: &'ast syn::ExprIf) {
        self.condition(&expr.cond);
        visit::visit_expr_if(self, expr);
    }

    fn visit_expr_while(&mut self, expr: &'ast syn::ExprWhile) {
        self.condition(&expr.cond);
        visit::visit_expr_while(self, expr);
    }

    fn visit_stmt(&mut self, stmt: &'ast Stmt) {
        let name = match stmt {
            Stmt::Expr(Expr::MethodCall(call), Some(_)) => Some(format!(".{}(…);", call.method)),
            Stmt::Expr(Expr::Call(_), Some(_)) => Some("a call".to_owned()),
            Stmt::Expr(Expr::Assign(_), Some(_)) => Some("an assignment".to_owned()),
            Stmt::Expr(Expr::Binary(_), Some(_)) => Some("an assignment with an operator".to_owned()),
            _ => None,
        };
        if let Some(name) = name {
            self.add(stmt, format!("{name} left out"), false, |number| {
                let head = format!("if !crate::switch::on({number}) {{ ");
                vec![Piece::Text(head), Piece::Source(bytes(stmt)), text(" }")]
            });
        }
        visit::visit_stmt(self, stmt);
    }

    fn visit_expr_unary(&mut self, expr: &'ast syn::ExprUnary) {
        if matches!(expr.op, UnOp::Neg(_)) {
            self.add(expr, "- left out".to_owned(), false, |number| {
                let operand = || Piece::Source(bytes(&expr.expr));
                let head = format!("(if crate::switch::on({number}) {{ ");
                vec![Piece::Text(head), operand(), text(" } else { -("), operand(), text(") })")]
            });
        }
        visit::visit_expr_unary(self, expr);
    }

    fn visit_expr_path(&mut self, expr: &'ast syn::ExprPath) {
        let mut segments = expr.path.segments.iter().rev().map(|segment| segment.ident.to_string());
        if let (Some(last), Some("Sign")) = (segments.next(), segments.next().as_deref()) {
            let becomes = match last.as_str() {
                "Positive" => "Negative",
                "Negative" => "Positive",
                _ => return,
            };
            self.add(expr, format!("{last} becomes {becomes}"), false, |number| {
                let head = format!("(if crate::switch::on({number}) {{ Sign::{becomes} }} else {{ ");
                vec![Piece::Text(head), Piece::Source(bytes(expr)), text(" })")]
            });
        }
    }

    fn visit_expr_binary(&mut self, expr: &'ast syn::ExprBinary) {
        if is_comparison(&expr.op) {
            self.outcome(&Expr::Binary(expr.clone()));
        }
        if let Some([op, becomes]) = other(&expr.op)
            && !has_let(&expr.left)
            && !has_let(&expr.right)
        {
            let [left, right] = [&expr.left, &expr.right].map(|side| Piece::Source(bytes(side)));
            self.add(expr, format!("{op} becomes {becomes}"), false, |number| match op {
                // The left side once: chains are deep.
                "&&" | "||" => vec![
                    text("({ let switch_left: bool = "),
                    left,
                    Piece::Text(format!("; if crate::switch::on({number}) {{ switch_left {becomes} (")),
                    right.clone(),
                    Piece::Text(format!(") }} else {{ switch_left {op} (")),
                    right,
                    text(") } })"),
                ],
                _ => vec![
                    Piece::Text(format!("(if crate::switch::on({number}) {{ (")),
                    left.clone(),
                    Piece::Text(format!(") {becomes} (")),
                    right.clone(),
                    text(") } else { ("),
                    left,
                    Piece::Text(format!(") {op} (")),
                    right,
                    text(") })"),
                ],
            });
        }
        visit::visit_expr_binary(self, expr);
    }
}
