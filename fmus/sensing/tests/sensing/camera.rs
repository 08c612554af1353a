//! The camera: against vectors turned one after the other, and back from the image to where the payload is.

use proptest::prelude::*;
use swayless_sensing::Camera;

const WIDE: f64 = 3.0;

/// Turns a vector (radial, tangential, up) about the radial or the tangential axis.
fn turned([r, t, z]: [f64; 3], about_radial: f64, about_tangential: f64) -> [f64; 3] {
    let (sin, cos) = about_radial.sin_cos();
    let [r, t, z] = [r, cos * t - sin * z, sin * t + cos * z];
    let (sin, cos) = about_tangential.sin_cos();
    [cos * r + sin * z, t, cos * z - sin * r]
}

/// From pivot to payload: hanging straight down, swung out radially, then tangentially.
fn payload(length: f64, [radial, tangential]: [f64; 2]) -> [f64; 3] {
    turned(turned([0.0, 0.0, -length], 0.0, -radial), tangential, 0.0)
}

proptest! {
    #[test]
    fn a_level_camera_leads_back_to_the_payload(
        length in 0.5..100.0_f64,
        part in 0.0..0.9_f64,
        radial in -1.2..1.2_f64,
        tangential in -1.2..1.2_f64,
    ) {
        let camera = Camera { drop: part * length, field_of_view: WIDE };
        let image = camera.image(length, [radial, tangential], 0.0);
        prop_assume!(image.is_some());
        let found = camera.locate(length, image.unwrap()).unwrap();
        let [r, t, _] = payload(length, [radial, tangential]);
        // Close to the camera's own height an image is ill-conditioned by (1 + q)^1.5/(1 − κ); q ≤ 2·tan² 1.5.
        prop_assert!((found.displacement[0] - r).abs() < 1e-10 * length);
        prop_assert!((found.displacement[1] - t).abs() < 1e-10 * length);
        prop_assert!((found.swing[0] - radial).abs() < 1e-9 && (found.swing[1] - tangential).abs() < 1e-9);
    }

    /// A camera that is pitched outwards sees what a level one sees where everything is turned back about the pivot.
    #[test]
    fn the_image_is_that_of_the_turned_payload(
        radial in -0.6..0.6_f64,
        tangential in -0.6..0.6_f64,
        pitch in -0.3..0.3_f64,
        drop in 0.0..2.0_f64,
    ) {
        let camera = Camera { drop, field_of_view: WIDE };
        let [u, v] = camera.image(10.0, [radial, tangential], pitch).unwrap();
        let [r, t, z] = turned(payload(10.0, [radial, tangential]), 0.0, pitch);
        prop_assert!((u - r / (-z - drop)).abs() < 1e-13 && (v - t / (-z - drop)).abs() < 1e-13);
    }

    /// In the plane of the boom, a pitch is an error of the angle, all of it: it turns about the pivot.
    #[test]
    fn in_the_plane_of_the_boom_a_pitch_is_the_error(radial in -0.5..0.5_f64, pitch in -0.3..0.3_f64) {
        let camera = Camera { drop: 0.7, field_of_view: WIDE };
        let image = camera.image(8.0, [radial, 0.0], pitch).unwrap();
        let found = camera.locate(8.0, image).unwrap();
        prop_assert!((found.swing[0] - (radial - pitch)).abs() < 1e-13 && found.swing[1] == 0.0);
    }

    /// To first order in ε: n' = n + ε (n_z, 0, −n_r), so that with φ = asin n_r and β = atan2(n_t, −n_z)
    /// φ' = φ − ε cos β and β' = β − ε tan φ sin β; what is left is of second order.
    #[test]
    fn elsewhere_the_error_is_the_one_of_geometry(radial in -0.5..0.5_f64, tangential in -0.5..0.5_f64) {
        let camera = Camera { drop: 0.7, field_of_view: WIDE };
        for pitch in [1e-3, -1e-3, 1e-5] {
            let image = camera.image(8.0, [radial, tangential], pitch).unwrap();
            let found = camera.locate(8.0, image).unwrap().swing;
            let wanted = [radial - pitch * tangential.cos(), tangential - pitch * radial.tan() * tangential.sin()];
            for axis in 0..2 {
                prop_assert!((found[axis] - wanted[axis]).abs() < 2.0 * pitch * pitch + 1e-14, "{axis}");
            }
        }
    }

    /// Whatever the numbers, an answer is finite.
    #[test]
    fn no_number_leads_astray(
        length in any::<f64>(), radial in any::<f64>(), tangential in any::<f64>(), drop in 0.0..1e3_f64, u in -100.0..100.0,
    ) {
        prop_assume!(length.is_finite() && radial.is_finite() && tangential.is_finite());
        let camera = Camera { drop, field_of_view: WIDE };
        let image = camera.image(length, [radial, tangential], 0.1);
        prop_assert!(image.is_none_or(|image| image.iter().all(|c| c.abs() <= (0.5 * WIDE).tan())));
        if let Some(found) = camera.locate(length, [u, -u]) {
            prop_assert!(found.displacement.iter().chain(&found.swing).all(|number| number.is_finite()));
            prop_assert!(length > drop);
        }
    }
}

#[test]
fn the_field_of_view_ends_where_it_says() {
    let camera = Camera { drop: 0.0, field_of_view: 0.6 };
    for (inside, swing) in [(true, 0.3 - 1e-12), (false, 0.3 + 1e-12)] {
        for sign in [1.0, -1.0] {
            assert_eq!(camera.image(10.0, [sign * swing, 0.0], 0.0).is_some(), inside);
            assert_eq!(camera.image(10.0, [0.0, sign * swing], 0.0).is_some(), inside);
        }
    }
    // Along the diagonal it sees farther: the image is a square.
    let corner = camera.image(10.0, [0.28, 0.28], 0.0).unwrap();
    assert!(corner[0].hypot(corner[1]) > 0.3_f64.tan());
    // From lower down the same swing is seen under a greater angle.
    assert!(Camera { drop: 2.0, ..camera }.image(10.0, [0.29, 0.0], 0.0).is_none());
}

#[test]
fn what_is_not_below_the_camera_is_not_seen() {
    let camera = Camera { drop: 2.0, field_of_view: WIDE };
    for (length, swing) in [(2.0, 0.0), (1.0, 0.0), (0.0, 0.0), (-5.0, 0.0), (10.0, 1.5), (10.0, 3.0)] {
        assert_eq!(camera.image(length, [swing, 0.0], 0.0), None, "{length} m, {swing} rad");
    }
    for length in [2.0, 1.0, 0.0, -5.0] {
        assert_eq!(camera.locate(length, [0.0, 0.0]), None);
    }
    // A camera in the pivot does without its distance.
    let camera = Camera { drop: 0.0, ..camera };
    assert_eq!(camera.image(0.0, [0.0, 0.0], 0.0), None);
    assert_eq!(camera.image(1e-300, [0.0, 0.0], 0.0), Some([0.0, 0.0]));
}
