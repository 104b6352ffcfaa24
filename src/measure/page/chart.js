// One curve's chart: error against time (or a row a setting, where only time differs), drawn by d3 at the width that there is.
const kMargin = { left: 62, right: 14, top: 12, bottom: 42 };

function paddedScale(values, range, padding) {
    const [low, high] = d3.extent(values);
    if (low === undefined) return d3.scaleLinear([0, 1], range);
    if (low <= 0) return d3.scaleLinear([Math.min(low, 0), high > 0 ? high * (1 + padding) : 1], range);
    const margin = Math.pow(Math.max(high / low, 4), padding);
    return d3.scaleLog([low / margin, high * margin], range);
}

// An error of 0 has no place on a logarithmic axis: it is drawn on the lower edge.
function errorScale(points, metric, range) {
    const errors = points.map((p) => p.errors[metric]).filter((e) => e !== null && e > 0);
    const scale = paddedScale(errors, range, 0.12);
    if (errors.length > 0 && points.some((p) => p.errors[metric] === 0)) {
        const [low, high] = scale.domain();
        scale.domain([low / Math.pow(high / low, 0.12), high]);
    }
    return scale;
}

function drawnPoints(curve, metric) {
    return curve.points.filter((p) => p.ms !== null && (curve.time_only || (p.errors[metric] !== undefined && p.errors[metric] !== null)));
}

// Where everything stands: scales, and for each drawn point its pixel and whether it is on the front or on the edge.
function layOut(curve, metric, width) {
    const points = drawnPoints(curve, metric), longest = d3.max(curve.points, (p) => Math.min(p.value.length, 22)) || 0;
    const left = curve.time_only ? 24 + 7 * longest : kMargin.left;
    const height = curve.time_only ? kMargin.top + kMargin.bottom + 30 * curve.points.length : Math.max(300, Math.min(480, 0.66 * width));
    const x = paddedScale(points.flatMap((p) => [p.q1, p.ms, p.q3]).filter((t) => t !== null), [left, width - kMargin.right], 0.09);
    const range = [height - kMargin.bottom, kMargin.top];
    const y = curve.time_only ? d3.scalePoint(curve.points.map((p) => p.index), [range[1], range[0]]).padding(0.7) : errorScale(points, metric, range);
    const dots = points.map((point) => {
        const error = point.errors[metric], edge = !curve.time_only && error === 0 && y.base !== undefined;
        const best = curve.time_only ? point.pareto.length > 0 : point.pareto.includes(metric);
        return { point, best, edge, x: x(point.ms), y: curve.time_only ? y(point.index) : edge ? range[0] - 6 : y(error), name: shortened(point.value, 24) };
    });
    return { x, y, dots, left, width, height, base: range[0] };
}

// 1, 2 and 5 of each ten where there is room for them, else powers of ten, or every other one.
function ticksOf(scale, room) {
    const [from, to] = scale.range(), count = Math.max(2, Math.floor(Math.abs(to - from) / room));
    if (scale.base === undefined) return scale.ticks(count);
    const [low, high] = scale.domain(), powers = d3.range(Math.floor(Math.log10(low)), Math.ceil(Math.log10(high)) + 1);
    const within = (digits, step) => powers.filter((p) => p % step === 0).flatMap((p) => digits.map((d) => Number(`${d}e${p}`))).filter((t) => t >= low && t <= high);
    const choices = [[[1, 1.5, 2, 3, 4, 5, 6, 7, 8, 9], 1], [[1, 2, 5], 1], [[1], 1], [[1], 2], [[1], 3], [[1], 5], [[1], 10]];
    return choices.map(([digits, step]) => within(digits, step)).find((ticks) => ticks.length <= count) || [];
}

function tickText(value) {
    return value !== 0 && (Math.abs(value) < 1e-3 || Math.abs(value) >= 1e5) ? value.toExponential() : d3.format("~g")(value);
}

function drawGrid(svg, at, curve) {
    const lines = (axis, scale, room, size) => axis.tickValues(ticksOf(scale, room)).tickSize(size).tickFormat("");
    svg.append("g").attr("class", "axis grid").attr("transform", `translate(0,${at.base})`).call(lines(d3.axisBottom(at.x), at.x, 52, kMargin.top - at.base));
    if (curve.time_only) return;
    svg.append("g").attr("class", "axis grid").attr("transform", `translate(${at.left},0)`)
        .call(lines(d3.axisLeft(at.y), at.y, 34, at.left + kMargin.right - at.width));
}

function drawAxes(svg, at, curve, metric) {
    drawGrid(svg, at, curve);
    const bottom = d3.axisBottom(at.x).tickValues(ticksOf(at.x, 52)).tickFormat(tickText).tickSizeOuter(0);
    svg.append("g").attr("class", "axis").attr("transform", `translate(0,${at.base})`).call(bottom);
    const side = d3.axisLeft(at.y).tickSizeOuter(0);
    if (curve.time_only) side.tickFormat((i) => shortened(curve.points[i].value, 22));
    else side.tickValues(ticksOf(at.y, 34)).tickFormat(tickText);
    svg.append("g").attr("class", "axis").attr("transform", `translate(${at.left},0)`).call(side);
    svg.append("text").attr("x", (at.left + at.width) / 2).attr("y", at.height - 6).attr("text-anchor", "middle").text("time on the device in ms (bars: quartiles)");
    if (curve.time_only) return;
    svg.append("text").attr("transform", `translate(12,${at.base / 2}) rotate(-90)`).attr("text-anchor", "middle").text(`${metric} (${curve.units[metric]})`);
}

function frontOf(at) {
    return at.dots.filter((d) => d.best).sort((a, b) => a.x - b.x);
}

// What names should not cover: points, their bars, the steps of the front.
function obstaclesIn(at) {
    const boxes = at.dots.flatMap((d) => [{ x0: d.x - 8, x1: d.x + 8, y0: d.y - 8, y1: d.y + 8 },
        { x0: at.x(d.point.q1 || d.point.ms), x1: at.x(d.point.q3 || d.point.ms), y0: d.y - 2, y1: d.y + 2 }]);
    for (const [a, b] of d3.pairs(frontOf(at))) {
        boxes.push({ x0: a.x, x1: b.x, y0: a.y - 1, y1: a.y + 1 });
        boxes.push({ x0: b.x - 1, x1: b.x + 1, y0: Math.min(a.y, b.y), y1: Math.max(a.y, b.y) });
    }
    return boxes;
}

function drawNoiseAndFront(svg, at, curve) {
    svg.selectAll(".noise").data(at.dots.filter((d) => d.point.runs > 1 && d.point.q1 !== null && d.point.q3 !== null)).join("line").attr("class", "noise")
        .attr("x1", (d) => at.x(d.point.q1)).attr("x2", (d) => at.x(d.point.q3)).attr("y1", (d) => d.y).attr("y2", (d) => d.y);
    const front = frontOf(at);
    if (curve.time_only || front.length < 2) return;
    svg.append("path").attr("class", "front").attr("d", d3.line().x((d) => d.x).y((d) => d.y).curve(d3.curveStepAfter)(front));
}

function drawNames(svg, at, curve) {
    if (curve.time_only) return;
    const places = placeLabels(at.dots, { x0: at.left, x1: at.width, y0: 0, y1: at.base }, obstaclesIn(at));
    places.forEach((place, i) => {
        const { x, y, name } = at.dots[i];
        const nx = Math.max(place.x0, Math.min(x, place.x1)), ny = Math.max(place.y0, Math.min(y, place.y1));
        if (Math.hypot(nx - x, ny - y) > 16) svg.append("line").attr("class", "leader").attr("x1", x).attr("y1", y).attr("x2", nx).attr("y2", ny);
        svg.append("text").attr("class", "name").attr("x", place.cx).attr("y", place.cy).attr("dy", "0.35em").attr("text-anchor", "middle").text(name);
    });
}

// A point without a place is said to be missing.
function drawMissing(svg, at, curve, metric) {
    const missing = curve.points.length - at.dots.length;
    if (missing === 0) return;
    svg.append("text").attr("class", "missing").attr("x", at.width - kMargin.right).attr("y", kMargin.top + 10).attr("text-anchor", "end")
        .text(`not drawn: ${missing} of ${curve.points.length} points, without a finite ${curve.time_only ? "time" : metric}`);
}

function drawDots(svg, at, metric, on) {
    const symbol = (d) => d3.symbol().type(d.edge ? d3.symbolTriangle : d3.symbolCircle).size(70)();
    const dots = svg.selectAll(".dot").data(at.dots).join("g")
        .attr("class", (d) => "dot" + (d.best ? " best" : "") + (d.point.note || !d.point.settled ? " noted" : ""))
        .attr("transform", (d) => `translate(${d.x},${d.y})`).attr("tabindex", 0).attr("role", "button").attr("data-index", (d) => d.point.index)
        .attr("aria-label", (d) => describe(d.point)).attr("aria-pressed", (d) => on.isChosen(d.point));
    dots.append("circle").attr("class", "target").attr("r", 14);
    dots.append("circle").attr("class", "ring").attr("r", 9);
    dots.append("path").attr("d", symbol).attr("transform", (d) => (d.edge ? "rotate(180)" : null));
    dots.each(function (d) {
        for (const [event, act] of [["mouseenter", on.look], ["focus", on.look], ["mouseleave", on.leave], ["blur", on.leave], ["click", on.choose]])
            this.addEventListener(event, () => act(d.point));
        this.addEventListener("keydown", (event) => {
            if (event.key === "Enter" || event.key === " ") event.preventDefault(), on.choose(d.point);
            if (event.key === "Escape") on.clear();
        });
    });
}

// on: look(point), leave(point), choose(point), clear(), isChosen(point). Returns {draw(metric), mark()}.
function makeChart(host, curve, on) {
    let metric = curve.metric, width = 0;
    const draw = () => {
        const at = layOut(curve, metric, width);
        d3.select(host).selectAll("svg").remove();
        const svg = d3.select(host).append("svg").attr("viewBox", `0 0 ${at.width} ${at.height}`).attr("role", "group")
            .attr("aria-label", `${curve.knob}: ${curve.time_only ? "time" : metric + " against time"}; the table below has the numbers`);
        drawAxes(svg, at, curve, metric);
        drawNoiseAndFront(svg, at, curve);
        drawNames(svg, at, curve);
        drawMissing(svg, at, curve, metric);
        drawDots(svg, at, metric, on);
    };
    new ResizeObserver(() => {
        const now = Math.floor(host.clientWidth);
        if (now > 0 && now !== width) width = now, draw();
    }).observe(host);
    return {
        draw: (wanted) => { metric = wanted, draw(); },
        mark: () => d3.select(host).selectAll(".dot").attr("aria-pressed", (d) => on.isChosen(d.point)),
    };
}
