"use strict";
// All pictures of one scene are zoomed together about the same point, so that the same yarns stand side by side.
const largest = 24;
for (const row of document.querySelectorAll(".row")) {
  const views = [...row.querySelectorAll(".view")];
  let zoom = 1, x = 0.5, y = 0.5;
  const show = () => {
    for (const view of views) {
      view.classList.toggle("near", zoom > 1);
      view.firstElementChild.style.transform =
        `translate(${100 * x * (1 - zoom)}%, ${100 * y * (1 - zoom)}%) scale(${zoom})`;
    }
  };
  const place = (event, view) => {
    const box = view.getBoundingClientRect();
    x = Math.min(1, Math.max(0, (event.clientX - box.left) / box.width));
    y = Math.min(1, Math.max(0, (event.clientY - box.top) / box.height));
  };
  for (const view of views) {
    view.addEventListener("click", (event) => {
      zoom = zoom > 1 ? 1 : 6;
      place(event, view);
      show();
    });
    view.addEventListener("pointermove", (event) => {
      if (zoom === 1) return;
      place(event, view);
      show();
    });
    view.addEventListener("wheel", (event) => {
      if (zoom === 1) return; // the page scrolls until a picture was clicked
      event.preventDefault();
      zoom = Math.min(largest, Math.max(1, zoom * Math.exp(-event.deltaY * 0.002)));
      show();
    }, { passive: false });
  }
}
for (const choice of document.querySelectorAll("input[name=shown]")) {
  choice.addEventListener("change", () => {
    for (const image of document.querySelectorAll("img[data-flip]")) {
      image.src = choice.value === "flip" ? image.dataset.flip : image.dataset.picture;
    }
  });
}
