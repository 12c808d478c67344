//! The binary carries the database's migrations and the dashboard: build again when either changes.

fn main() {
    println!("cargo::rerun-if-changed=../migrations");
    println!("cargo::rerun-if-changed=../web/dist");
}
