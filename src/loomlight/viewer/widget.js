/** The editor's page in a frame of a notebook; carries its messages to Python and back. See widget.py. */

async function render({ model, el }) {
  const view = crypto.randomUUID();
  let port = null;
  const frame = document.createElement("iframe");
  Object.assign(frame, { title: "loomlight: the live editor", allow: "clipboard-write" });
  Object.assign(frame.style, { width: "100%", boxSizing: "border-box", border: "1px solid #ddd5c5", borderRadius: "4px" });
  const size = () => (frame.style.height = `${model.get("height")}px`);

  const receive = async (content, buffers) => {
    if ((content.view ?? view) !== view || content.by === view) return;
    const buffer = buffers?.[0];
    const bytes = buffer && new Uint8Array(buffer.buffer ?? buffer, buffer.byteOffset ?? 0, buffer.byteLength);
    if (content.answer === 0) {
      const page = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
      frame.srcdoc = await new Response(page).text();
    } else {
      port?.postMessage({ ...content, buffer: bytes?.slice().buffer });
    }
  };
  // The page says that it is there, again where the notebook moves its frame, and gets its way to Python.
  const greet = (event) => {
    if (event.source === null || event.source !== frame.contentWindow || event.data !== "loomlight") return;
    port?.close();
    const channel = new MessageChannel();
    port = channel.port1;
    port.onmessage = ({ data: { buffer, ...asked } }) => model.send({ ...asked, view }, undefined, [buffer]);
    frame.contentWindow.postMessage("loomlight", "*", [channel.port2]);
  };
  addEventListener("message", greet);
  model.on("msg:custom", receive);
  model.on("change:height", size);
  size();
  el.append(frame);
  model.send({ view, ask: 0, place: "page" });
  return () => {
    removeEventListener("message", greet);
    model.off("msg:custom", receive);
    model.off("change:height", size);
    port?.close();
  };
}

export default { render };
