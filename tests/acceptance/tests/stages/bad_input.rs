//! Input that is wrong: one clear error, and no file.

use acceptance::{Folder, STAGES};

use crate::scenes::{BALL, HEAD, MESH, scene};

/// Every stage refuses the scene `s.toml` of `folder` with status 1 and a message that has these
/// parts.
fn check(case: &str, folder: &Folder, parts: &[&str]) {
    let files = folder.files();
    for stage in STAGES {
        let message = folder.complaint(stage, "s.toml -o a.png --stats s.json", 1);
        assert!(message.starts_with("error: "), "{case}, {stage}: {message}");
        assert_eq!(message.trim_end().lines().count(), 1, "{case}, {stage}: {message}");
        for part in parts {
            assert!(message.contains(part), "{case}, {stage}: no `{part}` in: {message}");
        }
        assert_eq!(folder.files(), files, "{case}, {stage}: the files");
    }
}

#[test]
fn a_scene_that_is_not_there_or_is_a_folder() {
    let folder = Folder::with(&[]);
    check("no file", &folder, &["s.toml", "no such file"]);
    std::fs::create_dir(folder.path("s.toml")).expect("the folder is made");
    check("a folder", &folder, &["s.toml", "folder"]);
    for stage in STAGES {
        let message = folder.complaint(stage, "whited", 1);
        assert!(message.contains("whitted"), "{stage} names no neighbour of `whited`: {message}");
    }
}

#[test]
fn a_scene_file_that_is_wrong() {
    let with_ball = |old: &str, new: &str| scene(&BALL.replace(old, new));
    let cases = [
        ("an unknown key", HEAD.replace("fov", "fow"), vec!["`s.toml`, line 5:", "fow", "`fov`"]),
        ("an unknown table", scene("[[spheer]]\nradius = 1\n"), vec!["s.toml", "`sphere`"]),
        ("NaN", with_ball("radius = 1", "radius = nan"), vec!["`s.toml`, line 17:", "radius"]),
        ("∞", with_ball("[0, 0, 0]", "[0, inf, 0]"), vec!["`s.toml`, line 15:", "center"]),
        ("1e39", with_ball("radius = 1", "radius = 1e39"), vec!["`s.toml`, line 17:", "radius"]),
        ("a negative radius", with_ball("= 1", "= -1"), vec!["`s.toml`, line 17:", "above 0"]),
        ("a radius of 0", with_ball("= 1", "= 0"), vec!["`s.toml`, line 17:", "above 0"]),
        ("no pixels", HEAD.replace("[24, 16]", "[0, 16]"), vec!["`s.toml`, line 6:", "size"]),
        (
            "too many",
            HEAD.replace("[24, 16]", "[60000, 60000]"),
            vec!["`s.toml`, line 6:", "memory"],
        ),
        (
            "a missing material",
            with_ball("'white'", "'wihte'"),
            vec!["`s.toml`, line 16:", "`white`"],
        ),
        ("a text for a number", with_ball("= 1", "= 'one'"), vec!["`s.toml`, line 17:", "radius"]),
        ("a key twice", with_ball("= 1", "= 1\nradius = 2"), vec!["`s.toml`, line 18:"]),
        ("no camera", BALL.to_owned(), vec!["s.toml", "camera"]),
        ("nothing", String::new(), vec!["s.toml", "camera"]),
        ("no TOML", "%PDF-1.4\n%\u{1}".to_owned(), vec!["`s.toml`, line 1:"]),
        (
            "a long line",
            format!("#{}", "x".repeat(30_000_000)),
            vec!["`s.toml`, line 1:", "longer"],
        ),
        (
            "itself as mesh",
            scene("[[mesh]]\nfile = 's.toml'\n"),
            vec!["`s.toml`, line 15:", ".obj"],
        ),
        (
            "nothing as mesh",
            scene("[[mesh]]\nfile = 'b.obj'\n"),
            vec!["`s.toml`, line 15:", "b.obj", "relative to the scene file"],
        ),
        (
            "a look upwards",
            HEAD.replace("eye = [0, 0, 5]", "eye = [0, 5, 0]"),
            vec!["`s.toml`, line 4:", "`up`"],
        ),
    ];
    for (case, text, parts) in cases {
        check(case, &Folder::with(&[("s.toml", &text)]), &parts);
    }
    let folder = Folder::with(&[]);
    folder.write("s.toml", b"ambient = [0, 0, 0]\n\xff\xfe");
    check("no text", &folder, &["`s.toml`, line 2:", "UTF-8"]);
}

#[test]
fn a_mesh_that_is_wrong() {
    let text = scene(MESH);
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (case, obj, parts) in [
        ("a corner too large", "f 1 2 4", vec!["`a.obj`, line 4:", "4"]),
        ("a corner 0", "f 0 1 2", vec!["`a.obj`, line 4:", "0"]),
        ("a corner too negative", "f -4 -2 -1", vec!["`a.obj`, line 4:", "-4"]),
        ("a corner that is none", "f 1 2 x", vec!["`a.obj`, line 4:"]),
        ("no face", "", vec!["a.obj"]),
        ("lines alone", "l 1 2\np 1", vec!["a.obj"]),
        ("faces without area", "f 1 1 2\nf 2 2 2", vec!["a.obj"]),
        ("NaN", "v nan 0 0\nf 1 2 4", vec!["`a.obj`, line 4:"]),
        ("a number too large", "v 1e99 0 0\nf 1 2 4", vec!["`a.obj`, line 4:"]),
        ("a normal that is missing", "f 1//1 2//1 3//1", vec!["`a.obj`, line 4:"]),
    ] {
        let obj = format!("{corners}{obj}\n");
        check(case, &Folder::with(&[("s.toml", &text), ("a.obj", &obj)]), &parts);
    }
}

/// The header of a PNG file that claims 10⁶ × 10⁶ pixels; its checksum was computed by a second
/// program.
fn huge_texture() -> Vec<u8> {
    let mut file =
        b"\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\x0f\x42\x40\0\x0f\x42\x40\x08\x02\0\0\0".to_vec();
    file.extend(HUGE_TEXTURE_CHECKSUM);
    file.extend(b"\0\0\0\0IDAT\x35\xaf\x06\x1e");
    file
}

const HUGE_TEXTURE_CHECKSUM: [u8; 4] = [0xd3, 0x0f, 0xaf, 0x2a];

#[test]
fn a_texture_that_is_wrong() {
    let text = scene("[materials.floor]\nkd = [1, 1, 1]\nmap_kd = 'a.png'\n");
    let folder = Folder::with(&[("s.toml", &text)]);
    check("no texture", &folder, &["`s.toml`, line 16:", "a.png"]);
    folder.write("a.png", b"this is no picture");
    check("no picture", &folder, &["`s.toml`, line 16:", "a.png"]);
    folder.write("a.png", &huge_texture());
    check("a huge picture", &folder, &["`s.toml`, line 16:", "1000000×1000000", "at most"]);
}

/// A mesh whose materials are missing is drawn, and the summary says so or an error does.
#[test]
fn materials_that_are_missing() {
    let obj = "mtllib none.mtl\nusemtl red\nv -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";
    let folder = Folder::with(&[("s.toml", &scene(MESH)), ("a.obj", obj)]);
    for stage in STAGES {
        let output = folder.command(stage, "s.toml -o a.png").output().expect("the stage starts");
        let message = String::from_utf8_lossy(&output.stderr);
        assert!(message.contains("none.mtl"), "{stage} does not name the file: {message}");
        assert!(matches!(output.status.code(), Some(0 | 1)), "{stage}: {message}");
        assert_eq!(output.status.success(), folder.path("a.png").exists(), "{stage}: {message}");
    }
}
