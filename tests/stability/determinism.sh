#!/usr/bin/env bash
# The same bits from every build and for any number of threads.
#
#   tests/stability/determinism.sh        from anywhere; ten minutes on two cores, the first time more
#
# Four builds, each in a folder of its own below the target folder:
#
#   dev      as `cargo test` builds: optimised, with assertions and checks of overflow
#   release  as users build
#   native   release, for this very processor: RUSTFLAGS="-C target-cpu=native"
#   plain    dev without any optimisation
#
# With each, the picture snapshots are run, and one scene of each stage is rendered on 1, 2 and 5
# threads; all files of a scene must be the same, byte for byte. One line is printed for each build
# and for each scene, the latter with the SHA-256 of its EXR file. Other machines print the same.
# If the target wasm32-wasip1 and the program `wasmtime` are installed, the snapshots are run there
# too; if not, the last line says so.
#
# Exit status: 0 all is the same, 1 something differs or a build fails.
set -euo pipefail
cd "$(dirname "$0")/../.."
unset RUSTFLAGS CARGO_ENCODED_RUSTFLAGS
export INSTA_UPDATE=no CARGO_TERM_COLOR=never CARGO_TERM_QUIET=true
target=$(realpath -m "${CARGO_TARGET_DIR:-target}")
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
failed=0

# Stage, scene and options of each render; small, since `plain` is a hundred times slower.
renders=(
  "workbench teapot --size 64x48"
  "ray-casting whitted --size 96x64 --samples 4"
  "blinn-phong teapot --size 64x48 --samples 2"
  "mirror-refraction nested-glass --size 64x48 --samples 4"
  "bv-tree whitted-teapot --size 96x60 --samples 4"
  "rendering-equation cornell-spheres --size 32x32 --samples 4"
  "path-tracing cornell-spheres --size 48x48 --samples 16"
  "light-sampling many-lights --size 48x48 --samples 16"
)

# cargo, as a build is made; the folder of its programs is in $programs.
cargo_of() {
  local build=$1 command=$2
  shift 2
  case $build in
    dev) programs=$target/debug && cargo "$command" --target-dir "$target" "$@" ;;
    release) programs=$target/release && cargo "$command" --release --target-dir "$target" "$@" ;;
    native)
      programs=$target/native/release
      RUSTFLAGS="-C target-cpu=native" \
        cargo "$command" --release --target-dir "$target/native" "$@"
      ;;
    plain)
      programs=$target/plain/debug
      cargo "$command" --config profile.dev.opt-level=0 --target-dir "$target/plain" "$@"
      ;;
  esac
}

# Snapshots of one build, then its programs for the renders.
snapshots_and_renders() {
  local build=$1 render stage scene options threads
  if cargo_of "$build" test --test pictures >"$out/log" 2>&1; then
    printf 'snapshots  %-8s the same\n' "$build"
  else
    cat "$out/log"
    printf 'snapshots  %-8s DIFFER, or were not built: see above\n' "$build"
    failed=1
  fi
  # With a test among what is built, the libraries are those that the snapshots have used.
  cargo_of "$build" build --bins --test pictures
  for render in "${renders[@]}"; do
    read -r stage scene options <<<"$render"
    for threads in 1 2 5; do
      # shellcheck disable=SC2086 # the options are several words
      "$programs/$stage" "$scene" $options --threads "$threads" --quiet \
        --output "$out/$stage.$build.$threads.exr"
    done
  done
}

for build in dev release native plain; do
  snapshots_and_renders "$build"
done

for render in "${renders[@]}"; do
  read -r stage scene options <<<"$render"
  hashes=$(sha256sum "$out/$stage".*.exr | cut -d' ' -f1 | sort | uniq -c | sort -rn)
  files=$(find "$out" -name "$stage.*.exr" | wc -l)
  if [ "$files" -eq 12 ] && [ "$(wc -l <<<"$hashes")" -eq 1 ]; then
    printf 'render     %-18s %-15s %s\n' "$stage" "$scene" "$(awk '{print $2}' <<<"$hashes")"
  else
    printf 'render     %-18s %-15s DIFFERS\n' "$stage" "$scene"
    (cd "$out" && sha256sum "$stage".*.exr)
    failed=1
  fi
done

wasm=wasm32-wasip1
if [ ! -d "$(rustc --print sysroot)/lib/rustlib/$wasm/lib" ]; then
  echo "snapshots  wasm32   not tried: the target $wasm is not installed (rustup target add $wasm)"
elif ! command -v wasmtime >/dev/null; then
  echo "snapshots  wasm32   not tried: there is no wasmtime to run it"
elif ! CARGO_TARGET_WASM32_WASIP1_RUNNER="wasmtime --dir /" \
  cargo test --target "$wasm" --target-dir "$target/wasm" --test pictures; then
  echo "snapshots  wasm32   DIFFER, or cannot be built: see above"
  failed=1
else
  echo "snapshots  wasm32   the same"
fi
exit "$failed"
