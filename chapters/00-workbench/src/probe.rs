//! Watching a render: exact counters, and the story of one path.
//!
//! A render is compiled twice, once with [`Unwatched`], in which all of this vanishes, and once
//! with a [`Recorder`]: counting costs nothing to those who did not ask for it.

use std::hint::black_box;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// Watches a render.
pub trait Probe: Sync {
    /// Whether anything is recorded at all: lets hot loops skip local counting at compile time.
    const ACTIVE: bool;

    /// Adds `by` to a counter. Hot loops count locally and call this once a ray.
    fn count(&self, counter: Counter, by: u64);

    /// Counts `work` that is not done, because it cannot change the picture.
    ///
    /// Under `--no-skip` it is not counted but done, and what it finds is thrown away: the picture
    /// stays the same, and what the skip saves can be measured. So `work` must leave everything as
    /// it was, random numbers included.
    fn skip<T>(&self, counter: Counter, work: impl FnOnce() -> T);

    /// Whether work of this kind is skipped, where that is a choice between two ways: true, except
    /// under `--no-skip`. Who skips it counts it.
    fn skips(&self, counter: Counter) -> bool;

    /// Prints the sentence under `--pixel`, for the first path only; `sentence` is not called
    /// otherwise.
    fn tell(&self, sentence: impl FnOnce() -> String);
}

/// Watches nothing, and compiles to nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unwatched;

impl Probe for Unwatched {
    const ACTIVE: bool = false;

    #[inline(always)]
    fn count(&self, _: Counter, _: u64) {}

    #[inline(always)]
    fn skip<T>(&self, _: Counter, _: impl FnOnce() -> T) {}

    #[inline(always)]
    fn skips(&self, _: Counter) -> bool {
        true
    }

    #[inline(always)]
    fn tell(&self, _: impl FnOnce() -> String) {}
}

/// What can be counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Counter {
    /// Rays that start at the eye. The film counts them itself.
    CameraRays,
    /// Rays that only ask whether something stands in the way of a light.
    ShadowRays,
    /// Rays that a mirror or a boundary of glass, seen from either side, reflects.
    ReflectionRays,
    /// Rays that pass through a surface.
    RefractionRays,
    /// Rays in random directions.
    ScatterRays,
    /// Ray against bounding volume.
    VolumeTests,
    /// Ray against triangle or sphere.
    PrimitiveTests,
    /// Shadow rays not traced, because nothing arrives from the light: it is behind the surface,
    /// the point is behind the lamp, or it is so far away that its light vanishes.
    ShadowRaysFacingAway,
    /// Shadow rays not traced, because the surface reflects nothing of that light.
    ShadowRaysNothingToReflect,
    /// Branches of the recursion not followed, because each alone cannot change an 8-bit pixel.
    BranchesBelowThreshold,
    /// Paths that chance ended, while their survivors carry the more.
    PathsEndedByRoulette,
    /// Paths cut because they had as many scattering events as `--depth` allows.
    PathsEndedByDepth,
    /// Paths ended because the surface reflects nothing, so that nothing further could count.
    PathsEndedByBlack,
    /// Shadow rays not traced, because a mirror or glass sends none of a lamp's light to the eye
    /// from a direction that was not drawn from itself.
    ShadowRaysDelta,
    /// Shadow rays that stopped at the first hit they met, although there was more to search.
    AnyHitExits,
    /// Points of surfaces, with their normals, that no search computed: those of every hit but the
    /// one that it returns.
    SurfacePoints,
    /// Texture coordinates that were not computed, because the surface wears no picture.
    TextureCoordinates,
    /// Pictures that the scene file names, and that were not loaded, because no surface wears them
    /// or the stage knows no textures.
    TexturesNotLoaded,
    /// Trees that were not built, because there are so few primitives.
    TreesNotBuilt,
    /// Boundaries crossed straight on, because the index of refraction is the same on both sides:
    /// nothing was split in two by Fresnel's and Snell's equations.
    FresnelSplits,
    /// Triangles that were not decided on, because the ray starts or ends on them and they are flat;
    /// with them, those in the same leaf and the same plane, which were not tested.
    OwnTriangles,
    /// Shadow rays that did not look for the walls around the scene, nor for its only lamp.
    WallsLeftOut,
    /// Under `--error`: samples by which pixels hold fewer than the average, because it is quiet
    /// around them.
    SamplesNotNeeded,
}

impl Counter {
    /// Every counter, in the order of the statistics file.
    pub const ALL: [Self; 23] = [
        Self::CameraRays,
        Self::ShadowRays,
        Self::ReflectionRays,
        Self::RefractionRays,
        Self::ScatterRays,
        Self::VolumeTests,
        Self::PrimitiveTests,
        Self::ShadowRaysFacingAway,
        Self::ShadowRaysNothingToReflect,
        Self::BranchesBelowThreshold,
        Self::PathsEndedByRoulette,
        Self::PathsEndedByDepth,
        Self::PathsEndedByBlack,
        Self::ShadowRaysDelta,
        Self::AnyHitExits,
        Self::SurfacePoints,
        Self::TextureCoordinates,
        Self::TexturesNotLoaded,
        Self::TreesNotBuilt,
        Self::FresnelSplits,
        Self::OwnTriangles,
        Self::WallsLeftOut,
        Self::SamplesNotNeeded,
    ];

    /// The group and the key under which the statistics file shows the count.
    #[must_use]
    pub const fn name(self) -> (&'static str, &'static str) {
        match self {
            Self::CameraRays => ("rays", "camera"),
            Self::ShadowRays => ("rays", "shadow"),
            Self::ReflectionRays => ("rays", "reflection"),
            Self::RefractionRays => ("rays", "refraction"),
            Self::ScatterRays => ("rays", "scatter"),
            Self::VolumeTests => ("tests", "volume"),
            Self::PrimitiveTests => ("tests", "primitive"),
            Self::ShadowRaysFacingAway => ("skipped", "shadow_rays_facing_away"),
            Self::ShadowRaysNothingToReflect => ("skipped", "shadow_rays_nothing_to_reflect"),
            Self::BranchesBelowThreshold => ("skipped", "branches_below_threshold"),
            Self::PathsEndedByRoulette => ("skipped", "paths_ended_by_roulette"),
            Self::PathsEndedByDepth => ("skipped", "paths_ended_by_depth"),
            Self::PathsEndedByBlack => ("skipped", "paths_ended_by_black"),
            Self::ShadowRaysDelta => ("skipped", "shadow_rays_delta"),
            Self::AnyHitExits => ("skipped", "any_hit_exits"),
            Self::SurfacePoints => ("skipped", "surface_points"),
            Self::TextureCoordinates => ("skipped", "texture_coordinates"),
            Self::TexturesNotLoaded => ("skipped", "textures_not_loaded"),
            Self::TreesNotBuilt => ("skipped", "trees_not_built"),
            Self::FresnelSplits => ("skipped", "fresnel_splits"),
            Self::OwnTriangles => ("skipped", "own_triangles"),
            Self::WallsLeftOut => ("skipped", "walls_left_out"),
            Self::SamplesNotNeeded => ("skipped", "samples_not_needed"),
        }
    }
}

/// How many threads may count without getting in each other's way.
const SHARDS: usize = 32;

/// The counts of some of the threads, on cache lines of their own.
#[derive(Debug, Default)]
#[repr(align(128))]
struct Shard([AtomicU64; Counter::ALL.len()]);

/// Counts exactly, and prints the story of a path while it is told to.
#[derive(Debug)]
pub struct Recorder {
    shards: Vec<Shard>,
    /// What is done although it could be skipped, by counter.
    unskipped: [bool; Counter::ALL.len()],
    telling: AtomicBool,
    to_stderr: bool,
}

impl Recorder {
    /// All counts zero; tells nothing yet.
    #[must_use]
    pub fn new() -> Self {
        let shards = (0..SHARDS).map(|_| Shard::default()).collect();
        let unskipped = [false; Counter::ALL.len()];
        Self { shards, unskipped, telling: AtomicBool::new(false), to_stderr: false }
    }

    /// The same, but work of these kinds is done although it could be skipped.
    #[must_use]
    pub fn without_skipping(mut self, counters: &[Counter]) -> Self {
        counters.iter().for_each(|&counter| self.unskipped[counter as usize] = true);
        self
    }

    /// The same, but the story goes to standard error: standard output belongs to the statistics.
    pub(crate) fn telling_stderr(mut self) -> Self {
        self.to_stderr = true;
        self
    }

    /// What a counter stands at.
    #[must_use]
    pub fn get(&self, counter: Counter) -> u64 {
        // Integers, so the sum is the same whatever thread counted what.
        self.shards.iter().map(|shard| shard.0[counter as usize].load(Ordering::Relaxed)).sum()
    }

    /// Whether sentences are printed from now on.
    pub(crate) fn set_telling(&self, telling: bool) {
        self.telling.store(telling, Ordering::Relaxed);
    }
}

impl Default for Recorder {
    fn default() -> Self {
        Self::new()
    }
}

impl Probe for Recorder {
    const ACTIVE: bool = true;

    fn count(&self, counter: Counter, by: u64) {
        if by == 0 {
            return;
        }
        let shard = rayon::current_thread_index().unwrap_or(0) % SHARDS;
        self.shards[shard].0[counter as usize].fetch_add(by, Ordering::Relaxed);
    }

    fn skip<T>(&self, counter: Counter, work: impl FnOnce() -> T) {
        if self.skips(counter) {
            self.count(counter, 1);
        } else {
            // Nobody reads the result, and without the box the compiler would drop the work.
            black_box(work());
        }
    }

    fn skips(&self, counter: Counter) -> bool {
        !self.unskipped[counter as usize]
    }

    fn tell(&self, sentence: impl FnOnce() -> String) {
        if self.telling.load(Ordering::Relaxed) {
            // A render cannot fail. If the line cannot be written, the last one cannot either, and
            // there it is an error.
            let _ = crate::run::say(self.to_stderr, &sentence());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Counter, Probe, Recorder, Unwatched};
    use rayon::iter::{IntoParallelIterator, ParallelIterator};

    #[test]
    fn counts_are_exact_on_many_threads() {
        let recorder = Recorder::new();
        (0..10_000_u64).into_par_iter().for_each(|i| recorder.count(Counter::ShadowRays, i));
        assert_eq!(recorder.get(Counter::ShadowRays), 49_995_000, "the sum of 0 to 9999");
        assert_eq!(recorder.get(Counter::CameraRays), 0, "another counter");
    }

    #[test]
    fn every_counter_has_a_place_and_a_name_of_its_own() {
        for (i, counter) in Counter::ALL.into_iter().enumerate() {
            assert_eq!(counter as usize, i, "the place of {counter:?}");
            let same = Counter::ALL.iter().filter(|other| other.name() == counter.name()).count();
            assert_eq!(same, 1, "counters called {:?}", counter.name());
        }
    }

    /// The skip is counted or its work is done, never both, and each kind for itself.
    #[test]
    fn work_is_skipped_and_counted_or_else_done() {
        let kinds = [Counter::FresnelSplits, Counter::AnyHitExits];
        let results = |recorder: &Recorder| {
            kinds.map(|kind| {
                let mut done = 0;
                recorder.skip(kind, || done += 1);
                (recorder.skips(kind), recorder.get(kind), done)
            })
        };
        let skipped = (true, 1, 0);
        assert_eq!(results(&Recorder::new()), [skipped; 2], "what is skipped, counted, done");
        let recorder = Recorder::new().without_skipping(&kinds[1..]);
        assert_eq!(results(&recorder), [skipped, (false, 0, 1)], "without skipping the second");
    }

    #[test]
    fn an_unwatched_render_skips_everything_and_calls_nothing() {
        assert!(Counter::ALL.into_iter().all(|counter| Unwatched.skips(counter)), "all skipped");
        Unwatched.skip(Counter::FresnelSplits, || panic!("the work was done"));
    }

    #[test]
    fn nothing_is_told_unless_it_was_asked_for() {
        let sentence = || -> String { panic!("the sentence was put together") };
        Unwatched.tell(sentence);
        Recorder::new().tell(sentence);
    }
}
