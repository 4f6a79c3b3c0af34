// A view in the cell of a notebook: requests the page and its pictures from the kernel over the kernel's channel, as comm
// messages of the target "nacre". If that fails, the cell's picture stays.
//   to the kernel    {n, view, path}, path as in an HTTP request: "", "picture?zoom=2"
//   to the page      {n, status, type}, and the response's body as the buffer

/** Opens the notebook's channel to the kernel: {send(data)}; calls receive(data, buffers) and closed(). One per page. */
async function openChannel(kernel, receive, closed) {
  const colab = globalThis.google && google.colab && google.colab.kernel;
  if (colab && colab.comms) {
    const comm = await colab.comms.open("nacre", {}, []);
    (async () => { for await (const message of comm.messages) receive(message.data, message.buffers); closed(); })();
    return {send: data => comm.send(data)};
  }
  if (globalThis.Jupyter && Jupyter.notebook) {  // Notebook 6
    const ready = () => Jupyter.notebook.kernel && Jupyter.notebook.kernel.is_connected();
    while (!ready()) await new Promise(done => Jupyter.notebook.events.one("kernel_ready.Kernel", () => setTimeout(done, 100)));
    const comm = Jupyter.notebook.kernel.comm_manager.new_comm("nacre", {});
    comm.on_msg(message => receive(message.content.data, message.buffers));
    comm.on_close(closed);
    return {send: data => comm.send(data)};
  }
  return openSocket(kernel, receive, closed);
}

/** A random ID; crypto.randomUUID() needs https. */
const newId = () => Array.from(crypto.getRandomValues(new Uint8Array(16)), byte => byte.toString(16).padStart(2, "0")).join("");

/** For JupyterLab and Notebook 7, which hide the kernel from scripts of outputs: uses Jupyter Server's web socket. */
async function openSocket(kernel, receive, closed) {
  const config = JSON.parse(document.getElementById("jupyter-config-data").textContent);
  const session = newId(), comm = newId();
  const address = new URL(config.baseUrl + "api/kernels/" + kernel + "/channels", location);
  address.protocol = address.protocol.replace("http", "ws");
  address.searchParams.set("session_id", session);
  if (config.token) address.searchParams.set("token", config.token);
  const socket = new WebSocket(address);
  socket.binaryType = "arraybuffer";
  await new Promise((done, failed) => { socket.onopen = done; socket.onerror = failed; });
  const message = (kind, content) => socket.send(JSON.stringify({
    header: {msg_id: newId(), msg_type: kind, session, username: "nacre", date: new Date().toISOString(), version: "5.3"},
    parent_header: {}, metadata: {}, channel: "shell", buffers: [], content: {comm_id: comm, ...content}}));
  socket.onmessage = event => {
    let text = event.data, buffers = [];
    if (typeof text !== "string") {  // a count, offsets, the message, its buffers
      const view = new DataView(text), count = view.getUint32(0);
      const from = i => i < count ? view.getUint32(4 + 4 * i) : text.byteLength;
      buffers = Array.from({length: count - 1}, (_, i) => text.slice(from(i + 1), from(i + 2)));
      text = new TextDecoder().decode(text.slice(from(0), from(1)));
    }
    const told = JSON.parse(text);
    if (!told.content || told.content.comm_id !== comm) return;
    if (told.header.msg_type === "comm_msg") receive(told.content.data, buffers);
    if (told.header.msg_type === "comm_close") closed();
  };
  socket.onclose = closed;
  message("comm_open", {target_name: "nacre", data: {}});
  return {send: data => message("comm_msg", {data})};
}

/** Sends requests over a channel, and returns their responses. */
class Asker {
  constructor(open) {
    this.waiting = new Map();
    this.count = 0;
    this.channel = open((data, buffers) => this.receive(data, buffers), () => this.close());
  }
  receive(data, buffers) {
    const done = this.waiting.get(data.n);
    this.waiting.delete(data.n);
    if (done) done.resolve(new Response(data.status === 204 ? null : buffers[0], {status: data.status, headers: {"Content-Type": data.type}}));
  }
  close() {
    for (const one of this.waiting.values()) one.reject(new Error("the kernel is gone"));
    this.waiting.clear();
    this.closed = true;
  }
  async ask(view, path) {
    const channel = await this.channel;
    if (this.closed) throw new Error("the kernel is gone");
    return new Promise((resolve, reject) => {
      const n = ++this.count;
      this.waiting.set(n, {resolve, reject});
      channel.send({n, view, path});
    });
  }
}

/** Notebook 6 stores the outputs as they were given: replaces their picture with the last one. */
function keepPicture(id, data) {
  if (!globalThis.Jupyter || !Jupyter.notebook) return;
  for (const cell of Jupyter.notebook.get_cells())
    for (const output of cell.output_area ? cell.output_area.outputs : []) {
      const html = output.data && output.data["text/html"];
      if (typeof html !== "string" || !html.includes(id)) continue;
      output.data["text/html"] = html.replace(/src="data:image\/png;base64,[^"]*"/, () => 'src="' + data + '"');
      output.data["image/png"] = data.split(",")[1];
    }
}

/** Puts the page over an element's picture when the element becomes visible. */
function showView(root, view, asker) {
  const image = root.querySelector("img");
  let page = null;
  async function wake() {
    page = document.createElement("iframe");
    page.title = image.alt;
    page.style.cssText = "position:absolute;top:0;left:0;width:100%;height:100%;border:0;visibility:hidden";
    page.nacre = {
      ask: path => asker.ask(view, path),
      shown(blob, rest) {
        page.style.visibility = "visible";
        if (!rest) return;
        const reader = new FileReader();
        reader.onload = () => { image.src = reader.result; keepPicture(root.id, reader.result); };
        reader.readAsDataURL(blob);
      }};
    try {
      const answer = await asker.ask(view, "");
      if (!answer.ok) return;  // another kernel without this view
      page.srcdoc = await answer.text();
      root.append(page);
    } catch (error) { /* no kernel: the picture stays */ }
  }
  new IntersectionObserver((entries, observer) => {
    if (!page && entries.some(entry => entry.isIntersecting)) { observer.disconnect(); wake(); }
  }).observe(root);
}
