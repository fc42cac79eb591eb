#[path = "recursion/scenes.rs"]
#[allow(dead_code)]
mod scenes;
use glam::Vec3;
#[test]
fn time() {
    for n in [100u32, 707, 1600] {
        let mut s = scenes::white([scenes::glass(1.5)]);
        for i in 0..=n { for j in 0..n {
            let (a,b)=(std::f32::consts::PI*i as f32/n as f32, std::f32::consts::TAU*j as f32/n as f32);
            s.geometry.vertices.push(Vec3::new(a.sin()*b.cos(), a.cos(), a.sin()*b.sin()));
        }}
        for i in 0..n { for j in 0..n { let k=(j+1)%n;
            let v=[i*n+j, i*n+k, (i+1)*n+k, (i+1)*n+j];
            if i>0 {s.geometry.triangles.push([v[0],v[1],v[2]]); s.attributes.materials.push(0);}
            if i+1<n {s.geometry.triangles.push([v[0],v[2],v[3]]);s.attributes.materials.push(0);}
        }}
        let t=std::time::Instant::now();
        let c = mirror_refraction::Contacts::find(&s);
        let e=t.elapsed();
        let count: usize = (0..s.geometry.primitives()).map(|f| c.of(f).len()).sum();
        eprintln!("{} triangles: {e:?}, {count} contacts", s.geometry.triangles.len());
    }
}
