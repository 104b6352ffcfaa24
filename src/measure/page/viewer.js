// The picture beside a chart: of the point that is looked at, or two chosen ones with a seam that is moved between them, or what lies between
// the two, brightened, so that one sees where they differ.
function figures(number) {
    return number === null || number === undefined ? "not finite" : Number(number).toPrecision(4).replace(/\.?0+(e|$)/, "$1");
}

function describe(point) {
    const errors = Object.entries(point.errors).map(([metric, error]) => `${metric} ${figures(error)}`);
    const noise = point.runs === 1 ? "1 run" : `quartiles ${figures(point.q1)} to ${figures(point.q3)}, ${point.runs} runs`;
    const time = point.ms === undefined ? [] : [`${figures(point.ms)} ms (${noise}${point.settled ? "" : ", not settled"})`];
    const fronts = point.pareto || [], all = fronts.length === errors.length;
    const front = fronts.length > 0 ? [`on the Pareto front${all ? "" : ` of ${fronts.join(", ")}`}`] : [];
    return `${point.value}: ${[...time, ...errors, ...front, ...(point.note ? [point.note] : [])].join("; ")}`;
}

function addTo(parent, tag, name, text) {
    const element = document.createElement(tag);
    element.className = name;
    if (text) element.textContent = text;
    parent.append(element);
    return element;
}

// |left - right|, channel by channel as displayed, times a power of two.
function addDifference(parts) {
    const { figure, stage } = parts, bar = addTo(figure, "div", "bar difference"), button = addTo(bar, "button", "", "difference");
    const gain = addTo(bar, "input", "gain"), text = addTo(bar, "output", "");
    button.type = "button";
    button.setAttribute("aria-pressed", "false");
    Object.assign(gain, { type: "range", min: 0, max: 8, step: 1, value: 3 });
    gain.setAttribute("aria-label", "how much brighter the difference is shown, a power of two");
    const show = () => {
        const times = 2 ** gain.value, on = parts.differs && !bar.hidden;
        stage.classList.toggle("difference", on);
        stage.style.setProperty("--gain", times);
        text.textContent = `${times} times`;
        for (const part of [gain, text]) part.hidden = !on;
        for (const part of [parts.seam, parts.slider]) part.hidden = bar.hidden || on;
        button.setAttribute("aria-pressed", String(on));
    };
    button.addEventListener("click", () => { parts.differs = !parts.differs, show(); });
    gain.addEventListener("input", show);
    parts.showTwo = (two) => { bar.hidden = !two, show(); };
}

function makeStage(figure) {
    const stage = addTo(figure, "div", "stage"), pair = addTo(stage, "div", "pair"), under = addTo(pair, "img", "under"), over = addTo(pair, "img", "over");
    const parts = { figure, differs: false, stage, under, over, seam: addTo(stage, "div", "seam"), left: addTo(stage, "span", "side left"), right: addTo(stage, "span", "side right") };
    for (const image of [under, over]) image.addEventListener("load", () => image.classList.toggle("enlarged", image.naturalWidth < image.clientWidth));
    parts.slider = addTo(figure, "input", "");
    Object.assign(parts.slider, { type: "range", min: 0, max: 100, step: 0.5, value: 50 });
    parts.slider.setAttribute("aria-label", "seam between the two pictures, percent from the left");
    addDifference(parts);
    parts.caption = addTo(figure, "figcaption", "");
    parts.caption.setAttribute("aria-live", "polite");
    return parts;
}

function letTheSeamBeDragged({ stage, slider }) {
    const cut = (percent) => { slider.value = percent, stage.style.setProperty("--cut", `${slider.value}%`); };
    slider.addEventListener("input", () => cut(slider.value));
    const follow = (event) => {
        const box = stage.getBoundingClientRect();
        if (!slider.hidden) cut(100 * (event.clientX - box.left) / box.width);
    };
    stage.addEventListener("pointerdown", (event) => { stage.setPointerCapture(event.pointerId), event.preventDefault(), follow(event); });
    stage.addEventListener("pointermove", (event) => { if (event.buttons) follow(event); });
    cut(50);
}

function setPicture(image, pictures, point) {
    const there = point !== undefined && point.picture !== null;
    image.hidden = !there;
    image.alt = there ? `picture of ${point.value}` : "";
    if (there && image.dataset.picture !== String(point.picture)) image.src = pictures[point.picture], image.dataset.picture = point.picture;
}

// show([]), show([point]) or show([left, right]).
function makeViewer(figure, pictures) {
    const parts = makeStage(figure);
    letTheSeamBeDragged(parts);
    return (points) => {
        const seen = points.filter((p) => p.picture !== null), two = seen.length === 2;
        setPicture(parts.under, pictures, seen[0]);
        setPicture(parts.over, pictures, two ? seen[1] : undefined);
        parts.stage.hidden = seen.length === 0;
        parts.right.hidden = !two;
        parts.showTwo(two);
        parts.left.textContent = seen.length > 0 ? seen[0].value : "";
        parts.right.textContent = two ? seen[1].value : "";
        parts.caption.replaceChildren();
        for (const point of points) addTo(parts.caption, "div", "", describe(point));
    };
}
