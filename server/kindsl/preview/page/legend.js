// What is drawn in which colour, and switches and opacities for each kind of thing.
"use strict";

const KindslLegend = (() => {
  const { make } = KindslElements;

  function fill(parent, setView) {
    for (const category of KindslCategories.CATEGORIES) parent.append(entry(category, setView));
  }

  function entry(category, setView) {
    const row = make("label", "entry"), box = make("input"), fade = make("input", "fade");
    Object.assign(box, { type: "checkbox", checked: !category.hidden });
    box.dataset.category = category.key;
    Object.assign(fade, { type: "range", min: 0.05, max: 1, step: 0.05, value: category.opacity, title: "Opacity" });
    fade.ariaLabel = `opacity of ${category.title}`;
    fade.hidden = category.key === "names";
    const change = () => setView(category.key, box.checked, Number(fade.value));
    box.addEventListener("change", change);
    fade.addEventListener("input", change);
    row.append(box, swatch(category.swatch), make("span", "title", category.title), fade);
    return row;
  }

  // A colour, or the name of a drawn one.
  function swatch(look) {
    const element = make("span", "swatch");
    if (look.startsWith("#")) element.style.background = look;
    else element.classList.add(look);
    return element;
  }

  return { fill };
})();
