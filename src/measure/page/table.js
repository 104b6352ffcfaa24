// Tables that sort by a click on a heading, and buttons that copy a command.
function sortKey(row, column) {
    const text = row.cells[column].dataset.sort;
    return text === "" ? NaN : Number(text);
}

// Cells without a number stay last in either direction.
function compareRows(a, b, column, sign) {
    const x = sortKey(a, column), y = sortKey(b, column);
    return Number.isNaN(x) || Number.isNaN(y) ? Number.isNaN(x) - Number.isNaN(y) : sign * (x - y);
}

function sortTable(table, heading) {
    const ascending = heading.getAttribute("aria-sort") !== "ascending", column = heading.cellIndex, body = table.tBodies[0];
    for (const other of table.querySelectorAll("th[aria-sort]")) other.removeAttribute("aria-sort");
    heading.setAttribute("aria-sort", ascending ? "ascending" : "descending");
    body.append(...Array.from(body.rows).sort((a, b) => compareRows(a, b, column, ascending ? 1 : -1)));
}

function makeSortable(table) {
    for (const heading of table.querySelectorAll("th[data-sortable]")) {
        const button = document.createElement("button");
        button.type = "button";
        button.append(...heading.childNodes);
        heading.append(button);
        button.addEventListener("click", () => sortTable(table, heading));
    }
}

// Where the clipboard is out of reach, the command is at least selected.
async function copyCommand(button) {
    const code = button.parentElement.querySelector("code");
    try {
        await navigator.clipboard.writeText(code.textContent);
        button.textContent = "copied";
    } catch {
        getSelection().selectAllChildren(code);
        button.textContent = "selected";
    }
    setTimeout(() => { button.textContent = "copy"; }, 1500);
}

function addCopyButtons() {
    for (const code of document.querySelectorAll("code.copy")) {
        const button = document.createElement("button");
        button.type = "button", button.textContent = "copy";
        button.addEventListener("click", () => copyCommand(button));
        code.after(" ", button);
    }
}
