//! Two cubes, united through the C interface of plumb: `PLUMB_LIB_DIR=... cargo run`.
use std::ffi::{c_char, c_int, CStr};
use std::ptr::{null, null_mut};

/// The opaque handles of plumb.h that this program uses.
macro_rules! handles {
    ($($name:ident),*) => { $(#[repr(C)] struct $name { _private: [u8; 0] })* };
}
handles!(PlumbSolid, PlumbNumbers, PlumbContext, PlumbError, PlumbSolidOptions);

extern "C" {
    fn plumb_solid_from_triangles(
        xyz: *const f64, point_count: usize, triangles: *const u32, triangle_count: usize,
        options: *const PlumbSolidOptions, out: *mut *mut PlumbSolid, context: *const PlumbContext,
        error: *mut *mut PlumbError) -> c_int;
    fn plumb_solid_union(
        a: *const PlumbSolid, b: *const PlumbSolid, out: *mut *mut PlumbSolid,
        context: *const PlumbContext, error: *mut *mut PlumbError) -> c_int;
    fn plumb_solid_volume(
        solid: *const PlumbSolid, out: *mut *mut PlumbNumbers, context: *const PlumbContext,
        error: *mut *mut PlumbError) -> c_int;
    fn plumb_solid_free(solid: *mut PlumbSolid);
    fn plumb_numbers_exact(numbers: *const PlumbNumbers, i: usize) -> *const c_char;
    fn plumb_numbers_free(numbers: *mut PlumbNumbers);
    fn plumb_error_text(error: *const PlumbError) -> *const c_char;
    fn plumb_error_free(error: *mut PlumbError);
}

/// Calls a function that makes a handle. Returns the handle, or the text of the error.
fn made<Handle>(
    call: impl FnOnce(*mut *mut Handle, *mut *mut PlumbError) -> c_int,
) -> Result<*mut Handle, String> {
    let (mut handle, mut error) = (null_mut(), null_mut());
    if call(&mut handle, &mut error) == 0 {
        return Ok(handle);
    }
    // SAFETY: after a failure, the error is an object that the caller owns.
    unsafe {
        let text = CStr::from_ptr(plumb_error_text(error)).to_string_lossy().into_owned();
        plumb_error_free(error);
        Err(text)
    }
}

/// A solid that is released when it goes out of scope.
struct Solid(*mut PlumbSolid);

impl Drop for Solid {
    fn drop(&mut self) {
        // SAFETY: the handle is owned by this object alone.
        unsafe { plumb_solid_free(self.0) }
    }
}

impl Solid {
    fn from_triangles(xyz: &[f64], triangles: &[u32]) -> Result<Solid, String> {
        // SAFETY: the counts are those of the slices.
        made(|out, error| unsafe {
            plumb_solid_from_triangles(xyz.as_ptr(), xyz.len() / 3, triangles.as_ptr(),
                triangles.len() / 3, null(), out, null(), error)
        }).map(Solid)
    }

    fn union(&self, other: &Solid) -> Result<Solid, String> {
        // SAFETY: both handles are alive.
        made(|out, error| unsafe { plumb_solid_union(self.0, other.0, out, null(), error) })
            .map(Solid)
    }

    fn volume(&self) -> Result<String, String> {
        // SAFETY: the handle is alive; the text is copied before its owner is released.
        let numbers =
            made(|out, error| unsafe { plumb_solid_volume(self.0, out, null(), error) })?;
        unsafe {
            let text = CStr::from_ptr(plumb_numbers_exact(numbers, 0)).to_string_lossy().into_owned();
            plumb_numbers_free(numbers);
            Ok(text)
        }
    }
}

fn cube(low: f64) -> Result<Solid, String> {
    let xyz: Vec<f64> = (0..8).flat_map(|i| (0..3).map(move |a| low + ((i >> a) & 1) as f64)).collect();
    const TRIANGLES: [u32; 36] = [
        0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
        2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5,
    ];
    Solid::from_triangles(&xyz, &TRIANGLES)
}

fn main() -> Result<(), String> {
    println!("from Rust: volume {}", cube(0.0)?.union(&cube(0.25)?)?.volume()?);
    match Solid::from_triangles(&[0.0, 0.0, f64::NAN], &[]) {
        Err(text) => println!("refused: {text}"),
        Ok(_) => return Err("a coordinate that is not a number was accepted".into()),
    }
    Ok(())
}
