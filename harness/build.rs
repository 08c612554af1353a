//! Compiles the one thing that stable Rust cannot express: FMI 2.0's variadic logger.

fn main() {
    println!("cargo::rerun-if-changed=src/loader/logger.c");
    cc::Build::new().file("src/loader/logger.c").warnings(true).compile("swayless_logger");
}
