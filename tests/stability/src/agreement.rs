//! Stages that have to agree, and bits that have to be the same: I1 to I7.

crate::catalogue! {
    I1 elsewhere "chapters/07-light-sampling/tests/estimators/agreement.rs" in_the_cornell_box;
    I2 absent every_bidirectional_strategy_gives_the_same_picture
        "paths from both ends come in chapter 10";
    I3 absent light_tracing_agrees_with_path_tracing "paths from the lights come in chapter 9";
    I4 elsewhere "chapters/06-path-tracing/tests/paths/specular.rs"
        a_scene_of_mirrors_looks_as_in_chapter_3;
    I5 elsewhere "chapters/07-light-sampling/tests/estimators/closed_forms.rs"
        a_sphere_light_above_the_horizon_obeys_the_inverse_square;
    I6 elsewhere "chapters/06-path-tracing/tests/paths/transport.rs"
        contributions_by_length_add_up_to_the_whole;
    I7 elsewhere "chapters/06-path-tracing/tests/paths/agreement.rs"
        the_number_of_threads_changes_no_bit;
}
