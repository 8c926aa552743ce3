// Puts the panes of a comparison on top of each other: yours on the left of a line that can be
// moved, the reference or the signed error on the right. Without scripts the panes stay side by
// side. Nothing here comes from a submission: only elements that are there are moved.
"use strict";

let compares = 0;

function element(tag, properties, children = []) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

// One of the pictures that can lie on the right.
function choice(compare, group, pane, checked) {
  const words = pane.querySelector("figcaption").textContent;
  const input = element("input", { type: "radio", name: group, checked });
  input.addEventListener("change", () => {
    for (const other of compare.querySelectorAll(".pane.beside")) other.classList.remove("beside");
    pane.classList.add("beside");
  });
  return element("label", {}, [input, " " + words]);
}

function slide(compare) {
  const yours = compare.querySelector(".pane.yours img");
  const others = [...compare.querySelectorAll(".pane:not(.yours)")].filter((pane) =>
    pane.querySelector("img"));
  if (!yours || others.length === 0) return;

  const group = "beside-" + compares++;
  const range = element("input", { type: "range", min: 0, max: 100, step: 1, value: 50 });
  range.setAttribute("aria-label", "How much of your picture is shown, in percent");
  const move = () => compare.style.setProperty("--split", range.value + "%");
  range.addEventListener("input", move);

  // The pictures themselves can be dragged too.
  const drag = (event) => {
    const box = yours.getBoundingClientRect();
    range.value = (100 * (event.clientX - box.left)) / box.width;
    move();
  };
  compare.addEventListener("pointerdown", (event) => {
    if (!event.target.closest(".pane")) return;
    event.preventDefault();
    compare.setPointerCapture(event.pointerId);
    drag(event);
  });
  compare.addEventListener("pointermove", (event) => {
    if (compare.hasPointerCapture(event.pointerId)) drag(event);
  });

  others[0].classList.add("beside");
  const choices = others.map((pane, i) => choice(compare, group, pane, i === 0));
  const fieldset = element("fieldset", {}, [element("legend", { textContent: "yours beside" }),
    ...choices]);
  compare.classList.add("sliding");
  compare.after(element("div", { className: "controls" }, [range, fieldset]));
  move();
}

document.querySelectorAll(".compare").forEach(slide);
