// Where the names of points stand: each takes the cheapest place around its point, as place_labels() does for the SVG files.
function overlap(a, b) {
    const w = Math.min(a.x1, b.x1) - Math.max(a.x0, b.x0), h = Math.min(a.y1, b.y1) - Math.max(a.y0, b.y0);
    return w > 0 && h > 0 ? w * h : 0;
}

const kSides = [[1, -1], [1, 1], [-1, -1], [-1, 1], [0, -1], [0, 1], [1, 0], [-1, 0]];

function gapBetween(box, x, y) {
    return Math.hypot(Math.max(box.x0 - x, x - box.x1, 0), Math.max(box.y0 - y, y - box.y1, 0));
}

// Beside another point a name would be read as that one's.
function confusion(box, dots, own) {
    return dots.reduce((sum, dot) => sum + (dot === own ? 0 : 2 * Math.max(0, 14 - gapBetween(box, dot.x, dot.y))), 0);
}

function placesAround(x, y, width, height) {
    return [10, 16, 26, 42, 60].flatMap((gap) => kSides.map(([sx, sy]) => {
        const cx = x + sx * (gap + width / 2), cy = y + sy * (gap + height * 0.3);
        return { x0: cx - width / 2, x1: cx + width / 2, y0: cy - height / 2, y1: cy + height / 2, cx, cy };
    }));
}

// dots: {x, y, name}; area and obstacles: boxes. Returns a box for each dot, with its middle.
function placeLabels(dots, area, obstacles) {
    const taken = obstacles.slice();
    return dots.map((dot) => {
        const { x, y, name } = dot;
        let best, least = Infinity;
        for (const place of placesAround(x, y, 6.8 * name.length, 15)) {
            const out = Math.max(area.x0 - place.x0, 0) + Math.max(place.x1 - area.x1, 0) + Math.max(area.y0 - place.y0, 0) + Math.max(place.y1 - area.y1, 0);
            const cost = gapBetween(place, x, y) + confusion(place, dots, dot) + 50 * out + taken.reduce((sum, box) => sum + overlap(place, box), 0);
            if (cost < least) [best, least] = [place, cost];
        }
        taken.push(best);
        return best;
    });
}

function shortened(text, most) {
    const letters = Array.from(text);
    return letters.length <= most ? text : letters.slice(0, most - 1).join("") + "\u2026";
}
