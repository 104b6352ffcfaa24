# shellcheck shell=bash
# The phases of `./run test --full`, for `run` to include: each is a build, a driver or a check; all are run, and one that fails fails the whole.
# In: names of phases, none for all. Out: a line with its wall time for each, the tests counted over all, exit code 1 if any failed.

all_phases=(suite page format tidy clang sanitize swiftshader mesa25 width128)

suite_cmd() { LIGHTBENCH_VALIDATION=1 ctest --test-dir "$1" -j2 --output-on-failure "${@:2}"; }
gpu_tests='^(kernels|images|cli|viewer)\.'

build_preset() {
    ensure_header
    (cd "$top" && { [ -e "build/$1/build.ninja" ] || cmake --preset "$1" -DLIGHTBENCH_BENCH=OFF >&2; })
    (cd "$top/build/$1" && ninja) | sed -u '/^ninja: no work to do/d; /Re-checking globbed/d' >&2
}

phase_suite() { run_suite; }

# The report's page in a browser; without one, the suite skips these tests.
phase_page() {
    install_packages chromium
    prepare_tests
    suite_cmd "$build" -R '^page\.'
}

phase_format() {
    install_packages clang-format-16
    find "$top/src" "$top/tests" -name '*.cpp' -o -name '*.h' | xargs clang-format-16 --dry-run -Werror
}

# Everything is compiled once more, at -O0 and with clang-tidy beside the compiler.
phase_tidy() {
    install_packages "${build_packages[@]}" "${test_packages[@]}" clang-16 clang-tidy-16
    build_preset tidy
}

phase_clang() {
    install_packages "${build_packages[@]}" "${test_packages[@]}" clang-16
    build_preset clang
    suite_cmd "$top/build/clang"
}

# Leaks are looked for where all the code is ours: LLVM, inside lavapipe, keeps what it compiled until the process ends.
phase_sanitize() {
    install_packages "${build_packages[@]}" "${test_packages[@]}"
    build_preset sanitize
    export UBSAN_OPTIONS=print_stacktrace=1
    ASAN_OPTIONS=detect_leaks=1 suite_cmd "$top/build/sanitize" -R '^(unit|hostile)\.' &&
        ASAN_OPTIONS=detect_leaks=0 suite_cmd "$top/build/sanitize" -R "$gpu_tests"
}

# Of Debian's chromium only the software driver is taken; nothing is installed.
phase_swiftshader() {
    local folder=$top/build/drivers/swiftshader
    prepare_tests
    if [ ! -e "$folder/libvk_swiftshader.so" ]; then
        mkdir -p "$folder"
        (cd "$folder" && apt-get -q -o APT::Sandbox::User=root download chromium-common >&2)
        dpkg --fsys-tarfile "$folder"/chromium-common_*.deb |
            tar -x -C "$folder" --strip-components=4 --wildcards '*/libvk_swiftshader.so' '*/vk_swiftshader_icd.json'
        rm -f "$folder"/chromium-common_*.deb
    fi
    VK_DRIVER_FILES=$folder/vk_swiftshader_icd.json suite_cmd "$build" -R "$gpu_tests"
}

# Debian's backports beside the system's driver: the manifest is pointed at the unpacked library.
phase_mesa25() {
    local folder=$top/build/drivers/mesa25 libraries
    prepare_tests
    libraries=$folder/usr/lib/$(gcc -print-multiarch)
    if [ ! -e "$folder/lvp_icd.json" ]; then
        # shellcheck disable=SC1091
        download_beside "$(. /etc/os-release && printf '%s' "$VERSION_CODENAME")-backports" "$folder" mesa-vulkan-drivers libdrm2 libdrm-amdgpu1
        sed "s|\"library_path\": \".*libvulkan_lvp.so\"|\"library_path\": \"$libraries/libvulkan_lvp.so\"|" \
            "$folder"/usr/share/vulkan/icd.d/lvp_icd*.json >"$folder/lvp_icd.json.part"
        mv "$folder/lvp_icd.json.part" "$folder/lvp_icd.json"
    fi
    LD_LIBRARY_PATH=$libraries VK_DRIVER_FILES=$folder/lvp_icd.json suite_cmd "$build" -R "$gpu_tests"
}

# Subgroups of 4 on the system's own lavapipe. Mesa 22.3.6's shader cache does not tell the widths apart (code of the one corrupts the heap of
# the other), so this one has a folder of its own.
phase_width128() {
    prepare_tests
    MESA_SHADER_CACHE_DIR=$top/build/mesa-width128 LP_NATIVE_VECTOR_WIDTH=128 suite_cmd "$build" -R "$gpu_tests"
}

# run_phases [PHASE...]
run_phases() {
    local phase started status failed_phases=0 log=$top/build/full-test.log passed=0 failed=0 line
    local phases=("$@") summary=()
    [ $# -gt 0 ] || phases=("${all_phases[@]}")
    for phase in "${phases[@]}"; do
        declare -F "phase_$phase" >/dev/null || { say "run: no phase \"$phase\"; there are ${all_phases[*]}"; exit 2; }
    done
    mkdir -p "$top/build"
    for phase in "${phases[@]}"; do
        started=$SECONDS
        say "== $phase"
        # A subshell of its own, not in a condition: there, bash would ignore set -e inside.
        set +e
        (set -e; "phase_$phase") 2>&1 | tee "$log"
        status=${PIPESTATUS[0]}
        set -e
        while read -r line; do # ctest: "97% tests passed, 3 tests failed out of 100"
            [[ $line =~ ([0-9]+)\ tests?\ failed\ out\ of\ ([0-9]+) ]] || continue
            failed=$((failed + BASH_REMATCH[1]))
            passed=$((passed + BASH_REMATCH[2] - BASH_REMATCH[1]))
        done <"$log"
        [ "$status" -eq 0 ] || failed_phases=$((failed_phases + 1))
        summary+=("$(printf '%-12s %-7s %4d s' "$phase" "$([ "$status" -eq 0 ] && echo ok || echo FAILED)" $((SECONDS - started)))")
    done
    printf '%s\n' "" "${summary[@]}" "" "$passed passed, $failed failed"
    [ "$failed_phases" -eq 0 ]
}
