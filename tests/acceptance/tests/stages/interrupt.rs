//! Ctrl-C keeps what there is.

use std::io::Read;
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use acceptance::{Folder, STAGES};
use workbench::Image;

use crate::scenes::{BALL, scene};

#[test]
fn an_interrupt_ends_with_130_and_a_readable_picture() {
    let folder = Folder::with(&[("s.toml", &scene(BALL))]);
    for stage in STAGES {
        let mut child = folder
            .command(stage, "s.toml --samples 4000000000 -o a.png")
            .stderr(Stdio::piped())
            .spawn()
            .expect("the stage starts");
        sleep(Duration::from_millis(700));
        let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
        assert!(sent.is_ok_and(|status| status.success()), "the signal is sent");
        let status = child.wait().expect("the stage ends");
        let mut message = String::new();
        let mut stderr = child.stderr.take().expect("it is piped");
        stderr.read_to_string(&mut message).expect("it is text");
        assert_eq!(status.code(), Some(130), "{stage}: {message}");
        assert!(message.contains("interrupted: the picture holds "), "{stage}: {message}");
        assert_eq!(folder.files(), ["a.png", "s.toml"], "{stage}: the files");
        let image = Image::load_png(&folder.path("a.png")).expect("the picture is read");
        assert!(image.max()[2] > 0.1, "{stage}: the picture is black, {:?}", image.max());
        std::fs::remove_file(folder.path("a.png")).expect("the picture is removed");
    }
}
