// Puts the live cloth in place of its picture once it is in view, where the browser has WebGPU.
const figures = document.querySelectorAll("figure[data-live]");

async function hasGraphics() {
  try {
    return Boolean(await navigator.gpu?.requestAdapter());
  } catch {
    return false;
  }
}

function enliven(figure) {
  const frame = document.createElement("iframe");
  frame.src = figure.dataset.live;
  frame.title = `${figure.querySelector("strong").textContent}, live: drag to turn, scroll to come closer.`;
  frame.addEventListener("load", () => frame.classList.add("ready"));
  figure.querySelector(".stage").append(frame);
}

if (figures.length > 0 && (await hasGraphics())) {
  const observer = new IntersectionObserver((entries) => {
    for (const entry of entries) {
      if (entry.isIntersecting) {
        observer.unobserve(entry.target);
        enliven(entry.target);
      }
    }
  });
  figures.forEach((figure) => observer.observe(figure));
}

// On a phone the text comes first.
if (matchMedia("(max-width: 52rem)").matches) {
  document.querySelectorAll("nav details[open]").forEach((group) => (group.open = false));
}
