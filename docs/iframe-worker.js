// Browsers start no worker for a page that was opened from the disk. There the search runs in a hidden frame instead.
if (location.protocol === "file:") {
  window.Worker = class extends EventTarget {
    constructor(url) {
      super();
      this.waiting = [];
      this.frame = document.createElement("iframe");
      this.frame.hidden = true;
      document.body.append(this.frame);
      const inside = this.frame.contentWindow;
      const tell = (type, data) => {
        const event = type === "error" ? new ErrorEvent("error", data) : new MessageEvent("message", { data });
        this.dispatchEvent(event);
        this["on" + type]?.(event);
      };
      inside.postMessage = (data) => setTimeout(() => tell("message", data));
      inside.addEventListener("error", (event) => tell("error", { message: event.message }));
      inside.importScripts = (...files) => Promise.all(files.map((file) => this.load(inside, file)));
      this.load(inside, String(url)).then(() => {
        this.ready = true;
        this.waiting.forEach((data) => this.send(data));
      });
    }
    load(inside, file) {
      return new Promise((loaded, failed) => {
        const script = inside.document.createElement("script");
        Object.assign(script, { src: file, async: false, onload: loaded, onerror: failed });
        inside.document.body.append(script);
      });
    }
    send(data) {
      const event = new this.frame.contentWindow.MessageEvent("message", { data });
      this.frame.contentWindow.onmessage?.(event);
      this.frame.contentWindow.dispatchEvent(event);
    }
    postMessage(data) {
      this.ready ? setTimeout(() => this.send(data)) : this.waiting.push(data);
    }
    terminate() {
      this.frame.remove();
    }
  };
}
