//! Surfaces whose normals have been computed beforehand.

use glam::Vec3;
use ray_casting::{Intersect, LinearSearch, Ray, Surfaces};
use workbench::{Sampler, Unwatched};

use crate::tools::scene_with_mesh;

const RECORDS: &str = "[[mesh]]\nfile = 'a.obj'\nmaterial = 'white'\nrotate = [10, 20, 30]\n\
    [[quad]]\nvertices = [[-2, -1, -2], [-2, -1, 2], [2, -1, 2], [2, -1, -2]]\nmaterial = 'lamp'\n\
    [[sphere]]\ncenter = [1, 0.1, 0]\nradius = 0.7\nmaterial = 'white'\n";

/// Two triangles of different planes, one of them a needle.
const OBJ: &str = "v -2 0 0\nv 0 0 0.1\nv -1 2 0\nv -2 0.01 -1\nf 1 2 3\nf 1 2 4\n";

#[test]
fn normals_computed_beforehand_change_no_bit_of_a_surface() {
    let scene = scene_with_mesh(RECORDS, OBJ);
    let surfaces = Surfaces::new(&scene);
    let geometry = LinearSearch::new(&scene.geometry, &Unwatched);
    let mut met = vec![0; scene.geometry.primitives() as usize];
    for i in 0..100_000 {
        let mut sampler = Sampler::new(23, i, 0);
        let mut point = || {
            let [x, y] = sampler.next_2d();
            4.0 * Vec3::new(x - 0.5, y - 0.5, sampler.next_1d() - 0.5)
        };
        let (origin, target) = (point(), point());
        let ray = Ray::new(origin, (target - origin).normalize());
        if let Some(hit) = geometry.intersect(&ray) {
            // Printed, every bit shows, that of the sign of a zero too.
            let [plain, beforehand] = [scene.surface(&ray, &hit), surfaces.at(&ray, &hit)];
            assert_eq!(format!("{beforehand:?}"), format!("{plain:?}"), "{ray:?}");
            met[hit.primitive as usize] += 1;
        }
    }
    assert!(met.iter().all(|&met| met > 100), "hits of each primitive: {met:?}");
}
