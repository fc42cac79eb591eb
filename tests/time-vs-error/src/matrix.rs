//! All experiments: which settings are held against each other, on which scenes.

use crate::experiment::{Experiment, Setting};
use crate::scene::{Answer, Scene};

/// How much of the matrix is run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Extent {
    /// About ten minutes of processor time.
    Full,
    /// About a minute: fewer seeds, fewer samples.
    Quick,
}

/// 4⁰, 4¹, … up to 4ⁿ⁻¹.
fn powers_of_four(n: u32) -> Vec<u32> {
    (0..n).map(|i| 4_u32.pow(i)).collect()
}

/// What most pictures are like: small, because only the number of samples matters.
const SIZE: [u32; 2] = [64, 64];

/// Every experiment, in the order in which they are run.
#[must_use]
pub fn experiments(extent: Extent) -> Vec<Experiment> {
    [
        trees(extent),
        vec![volumes(extent)],
        densities(extent),
        vec![branching(extent), ending(extent)],
        estimators(extent),
        vec![lights(extent)],
        whitted(extent),
    ]
    .concat()
}

fn seeds(extent: Extent) -> u64 {
    match extent {
        Extent::Full => 8,
        Extent::Quick => 3,
    }
}

fn setting(name: &str, stage: &'static str, options: &str, samples: &[u32], price: f64) -> Setting {
    let [name, options] = [name, options].map(str::to_owned);
    Setting { name, stage, options, samples: samples.to_vec(), price }
}

/// From which triangle on does the tree pay? Each terrain shows the same landscape.
fn trees(extent: Extent) -> Vec<Experiment> {
    let sides: &[u32] = match extent {
        Extent::Full => &[1, 2, 4, 8, 16, 32, 64, 128],
        Extent::Quick => &[1, 2, 4, 8, 16, 32],
    };
    // Without the tree as many samples as take a second or so; with it enough for a clock to read.
    // They have the first number in common, and there the pictures are compared.
    let enough = match extent {
        Extent::Full => 128,
        Extent::Quick => 16,
    };
    let experiment = |&side: &u32| {
        let triangles = 2 * side * side;
        let common = (64 * enough / triangles).clamp(1, enough);
        let mut with_tree = vec![common, enough];
        with_tree.dedup();
        let tests = f64::from(triangles);
        Experiment {
            question: "tree",
            scene: Scene::terrain(side, SIZE),
            settings: vec![
                setting("tree", "bv-tree", "--volume aabb", &with_tree, 3.0),
                setting("none", "bv-tree", "--volume none", &[common], 3.0 + 0.1 * tests),
            ],
            seeds: seeds(extent),
        }
    };
    sides.iter().map(experiment).collect()
}

/// Which volume, and which builder?
fn volumes(extent: Extent) -> Experiment {
    let samples = match extent {
        Extent::Full => [128],
        Extent::Quick => [8],
    };
    let of = |name, options| setting(name, "bv-tree", options, &samples, 8.0);
    Experiment {
        question: "volumes",
        scene: Scene::stored("whitted-teapot", SIZE, Answer::None),
        settings: vec![
            of("aabb, sah", "--volume aabb --builder sah"),
            of("aabb, median", "--volume aabb --builder median"),
            of("obb, sah", "--volume obb --builder sah"),
            of("kdop14, sah", "--volume kdop14 --builder sah"),
            of("kdop18, sah", "--volume kdop18 --builder sah"),
        ],
        seeds: seeds(extent),
    }
}

/// Uniform directions, or in proportion to what counts?
fn densities(extent: Extent) -> Vec<Experiment> {
    let of = |scene, answer, samples: &[u32]| Experiment {
        question: "density",
        scene: Scene::stored(scene, SIZE, answer),
        settings: ["cosine", "uniform"]
            .map(|density| {
                let options = format!("--branching 1 --depth 16 --density {density}");
                setting(density, "rendering-equation", &options, samples, 6.0)
            })
            .to_vec(),
        seeds: seeds(extent),
    };
    let most = match extent {
        Extent::Full => 5,
        Extent::Quick => 3,
    };
    // The furnace's paths are short, and a clock wants to read them, too.
    vec![
        of("furnace", Answer::Furnace, &powers_of_four(most + 1)),
        of("cornell-box", Answer::Reference("cornell"), &powers_of_four(most)),
    ]
}

/// One direction a hit, or N?
fn branching(extent: Extent) -> Experiment {
    // About as many rays for each: a sample has 4, 15, 85, 585.
    let counts: [(u32, &[u32], f64); 4] = match extent {
        Extent::Full => [
            (1, &[4, 16, 64, 256], 3.1),
            (2, &[1, 4, 16, 64], 9.9),
            (4, &[1, 4, 16], 50.0),
            (8, &[1, 2, 4], 330.0),
        ],
        Extent::Quick => {
            [(1, &[4, 16, 64], 3.1), (2, &[1, 4, 16], 9.9), (4, &[1, 2, 4], 50.0), (8, &[1], 330.0)]
        }
    };
    let answer = Answer::Own { depth: 3, samples: own_samples(extent) };
    Experiment {
        question: "branching",
        scene: Scene::stored("cornell-box", SIZE, answer),
        settings: counts
            .map(|(n, samples, rays)| {
                let options = format!("--depth 3 --branching {n}");
                setting(&format!("N = {n}"), "rendering-equation", &options, samples, rays)
            })
            .to_vec(),
        seeds: seeds(extent),
    }
}

/// Samples a pixel of a picture that others are held against.
fn own_samples(extent: Extent) -> u32 {
    match extent {
        Extent::Full => 4096,
        Extent::Quick => 512,
    }
}

/// Where should a path end?
fn ending(extent: Extent) -> Experiment {
    let samples: &[u32] = match extent {
        Extent::Full => &[4, 16, 64, 256, 1024, 4096],
        Extent::Quick => &[4, 16, 64],
    };
    let of = |name, options, price| setting(name, "path-tracing", options, samples, price);
    // What is only dearer, and not biased, need not be followed so far.
    let fewer = |name, options, price| {
        let samples: Vec<u32> = samples.iter().copied().filter(|&n| n <= 1024).collect();
        setting(name, "path-tracing", options, &samples, price)
    };
    Experiment {
        question: "ending",
        scene: Scene::stored("cornell-box", [32, 32], Answer::Reference("cornell")),
        settings: vec![
            of("roulette", "--depth 16 --roulette throughput", 3.6),
            fewer("roulette, 1/2", "--depth 16 --roulette 0.5", 2.5),
            fewer("depth 16", "--depth 16 --roulette off", 6.0),
            of("depth 4", "--depth 4 --roulette off", 3.6),
            of("depth 2", "--depth 2 --roulette off", 2.5),
        ],
        seeds: seeds(extent),
    }
}

/// Lamps by chance, by sampling them, or both?
fn estimators(extent: Extent) -> Vec<Experiment> {
    let samples = powers_of_four(match extent {
        Extent::Full => 5,
        Extent::Quick => 3,
    });
    let of = |scene| Experiment {
        question: "estimators",
        scene,
        settings: [("mis", 6.0), ("light", 6.0), ("scatter", 3.6)]
            .map(|(estimator, price)| {
                let options = format!("--depth 16 --estimator {estimator}");
                setting(estimator, "light-sampling", &options, &samples, price)
            })
            .to_vec(),
        seeds: seeds(extent),
    };
    let own = Answer::Own { depth: 16, samples: own_samples(extent) };
    let scenes = [
        Scene::stored("cornell-box", SIZE, Answer::Reference("cornell")),
        Scene::mesh(SIZE),
        Scene::stored("veach-plates", [64, 48], own),
    ];
    scenes.into_iter().map(of).collect()
}

/// Which of many lamps should be asked?
fn lights(extent: Extent) -> Experiment {
    let samples = powers_of_four(match extent {
        Extent::Full => 5,
        Extent::Quick => 3,
    });
    Experiment {
        question: "lights",
        scene: Scene::stored("many-lights", SIZE, Answer::Reference("many-lights")),
        settings: ["nearby", "power", "uniform"]
            .map(|choice| {
                let options = format!("--depth 16 --choice {choice}");
                setting(choice, "light-sampling", &options, &samples, 4.0)
            })
            .to_vec(),
        seeds: seeds(extent),
    }
}

/// How far is a Whitted picture from the right one, and what of that do samples mend?
fn whitted(extent: Extent) -> Vec<Experiment> {
    let samples = powers_of_four(match extent {
        Extent::Full => 4,
        Extent::Quick => 2,
    });
    let of = |scene, reference| Experiment {
        question: "whitted",
        scene: Scene::stored(scene, SIZE, Answer::Reference(reference)),
        settings: [("03 and 04", "bv-tree"), ("02", "blinn-phong")]
            .map(|(name, stage)| setting(name, stage, "", &samples, 4.0))
            .to_vec(),
        seeds: seeds(extent),
    };
    vec![of("cornell-box", "cornell"), of("cornell-spheres", "cornell-spheres")]
}
