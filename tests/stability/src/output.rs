//! Pictures: G1 to G7.

crate::catalogue! {
    G1 elsewhere "chapters/00-workbench/src/srgb.rs" known_values_have_their_bytes;
    G2 elsewhere "chapters/00-workbench/src/srgb.rs" every_byte_survives_decoding_and_encoding;
    G3 elsewhere "chapters/00-workbench/src/film.rs"
        samples_that_are_not_finite_are_counted_and_left_out;
    G4 elsewhere "chapters/00-workbench/src/srgb.rs" the_neighbours_of_one_are_white;
    G5 elsewhere "chapters/00-workbench/src/picture_file.rs" an_exr_file_gives_back_every_bit;
    G6 absent text_and_binary_ppm_are_the_same "the course writes PNG and EXR, never PPM";
    G7 elsewhere "chapters/00-workbench/src/srgb.rs"
        a_ramp_is_monotone_uses_every_byte_and_is_half_a_byte_off_at_most;
}
