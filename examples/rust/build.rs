// PLUMB_LIB_DIR is the folder of libplumb_c.so; an installed one is found without it.
fn main() {
    println!("cargo:rerun-if-env-changed=PLUMB_LIB_DIR");
    if let Ok(folder) = std::env::var("PLUMB_LIB_DIR") {
        println!("cargo:rustc-link-search=native={folder}");
        println!("cargo:rustc-link-arg=-Wl,-rpath,{folder}");
    }
    println!("cargo:rustc-link-lib=dylib=plumb_c");
}
