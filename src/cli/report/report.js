"use strict";

// The page says everything without this script, which adds two things: a button that turns light into dark, and table
// columns that sort at a click.

(function () {
    const root = document.documentElement;
    const systemIsDark = window.matchMedia("(prefers-color-scheme: dark)");

    // Pages from a file may be denied storage; then the choice holds for this page alone.
    function storedTheme() {
        try {
            return localStorage.getItem("lodsmith-report-theme");
        } catch (error) {
            return null;
        }
    }

    function storeTheme(theme) {
        try {
            localStorage.setItem("lodsmith-report-theme", theme);
        } catch (error) {
            return;
        }
    }

    function isDark() {
        return root.dataset.theme ? root.dataset.theme === "dark" : systemIsDark.matches;
    }

    function addThemeButton() {
        const button = document.createElement("button");
        button.type = "button";
        button.className = "theme";
        const label = () => {
            button.textContent = isDark() ? "Light" : "Dark";
            button.setAttribute("aria-label", isDark() ? "Show the page light" : "Show the page dark");
        };
        button.addEventListener("click", () => {
            root.dataset.theme = isDark() ? "light" : "dark";
            storeTheme(root.dataset.theme);
            label();
        });
        systemIsDark.addEventListener("change", label);
        label();
        document.body.prepend(button);
    }

    // Cells hold what they sort by in data-value: a number, or else a text. Rows that have none, because there is
    // nothing to compare, stay at the end.
    function compare(a, b) {
        const x = Number(a), y = Number(b);
        if (a !== "" && b !== "" && !Number.isNaN(x) && !Number.isNaN(y))
            return x - y;
        return a < b ? -1 : a > b ? 1 : 0;
    }

    function sortBy(table, column, direction) {
        const body = table.tBodies[0];
        const value = (row) => row.cells[column] ? row.cells[column].dataset.value : undefined;
        const rows = Array.from(body.rows);
        rows.sort((a, b) => {
            const x = value(a), y = value(b);
            if (x === undefined || y === undefined)
                return (x === undefined ? 1 : 0) - (y === undefined ? 1 : 0);
            return direction * compare(x, y);
        });
        body.append(...rows);
    }

    function makeSortable(table) {
        const heads = Array.from(table.tHead.rows[0].cells);
        heads.forEach((head, column) => {
            const button = document.createElement("button");
            button.type = "button";
            button.append(...head.childNodes);
            head.append(button);
            button.addEventListener("click", () => {
                // Figures are asked for from the greatest down, names from the first on.
                const first = column === 0 ? "ascending" : "descending";
                const other = column === 0 ? "descending" : "ascending";
                const order = head.getAttribute("aria-sort") === first ? other : first;
                heads.forEach((each) => each.removeAttribute("aria-sort"));
                head.setAttribute("aria-sort", order);
                sortBy(table, column, order === "ascending" ? 1 : -1);
            });
        });
    }

    const theme = storedTheme();
    if (theme === "light" || theme === "dark")
        root.dataset.theme = theme;
    document.addEventListener("DOMContentLoaded", () => {
        addThemeButton();
        document.querySelectorAll("table.sortable").forEach(makeSortable);
    });
})();
