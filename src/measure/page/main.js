// Brings each curve's chart, pictures and table together.
function addMetrics(bar, curve, chart) {
    if (curve.time_only || curve.metrics.length < 2) return;
    const label = addTo(bar, "label", "", "error: "), select = addTo(label, "select", "metric");
    for (const metric of curve.metrics) {
        const option = addTo(select, "option", "", metric);
        option.value = metric, option.selected = metric === curve.metric;
    }
    select.addEventListener("change", () => chart.draw(select.value));
}

function legend(curve) {
    return curve.time_only ? "filled: the fastest" : "filled: Pareto front; triangle: error 0; dashed: noted";
}

// Two at a time; a third takes the place of the older one.
function makeChoice(refresh) {
    let chosen = [];
    return {
        points: () => chosen,
        has: (point) => chosen.includes(point),
        toggle: (point) => { chosen = chosen.includes(point) ? chosen.filter((p) => p !== point) : [...chosen.slice(-1), point], refresh(); },
        clear: () => { chosen = [], refresh(); },
    };
}

// A button in each row chooses its picture, as a click on the point does.
function addRowButtons(section, choose, marks) {
    for (const cell of section.querySelectorAll("td.picture")) {
        const button = addTo(cell, "button", "", "compare"), point = marks.points[Number(cell.parentElement.dataset.index)];
        button.type = "button";
        if (point.picture === null) { button.remove(); continue; }
        button.addEventListener("click", () => choose(point));
        marks.buttons.push([button, point]);
    }
}

function addReference(bar, reference, choose, marks) {
    if (reference.picture === null) return;
    const button = addTo(bar, "button", "", "reference");
    button.type = "button";
    button.addEventListener("click", () => choose(reference));
    marks.buttons.push([button, reference]);
}

function setUp(section, curve, pictures) {
    const chartCard = section.querySelector(".chart"), viewerCard = section.querySelector(".viewer"), marks = { points: curve.points, buttons: [] };
    const bar = addTo(chartCard, "div", "bar"), viewerBar = addTo(viewerCard, "div", "bar"), host = addTo(chartCard, "div", "host");
    const show = makeViewer(viewerCard, pictures), atRest = curve.reference.picture !== null ? [curve.reference] : curve.points.slice(0, 1);
    const rest = () => show(choice.points().length > 0 ? choice.points() : atRest);
    const choice = makeChoice(() => {
        chart.mark(), rest();
        for (const [button, point] of marks.buttons) button.setAttribute("aria-pressed", choice.has(point));
    });
    const chart = makeChart(host, curve, { look: (p) => show([p]), leave: rest, choose: choice.toggle, clear: choice.clear, isChosen: choice.has });
    addMetrics(bar, curve, chart);
    addTo(bar, "span", "hint", legend(curve));
    const pictured = curve.points.some((p) => p.picture !== null);
    addReference(viewerBar, curve.reference, choice.toggle, marks);
    addTo(viewerBar, "span", "hint", pictured ? "choose two points to compare" : "this knob has no pictures");
    addRowButtons(section, choice.toggle, marks);
    for (const [button] of marks.buttons) button.setAttribute("aria-pressed", "false");
    rest();
}

const report = JSON.parse(document.getElementById("report").textContent);
report.curves.forEach((curve, i) => setUp(document.getElementById(`curve-${i}`), curve, report.pictures));
for (const table of document.querySelectorAll("table.sortable")) makeSortable(table);
addCopyButtons();
