// The line to the page that holds this one in a frame, in place of a server: requests go up, messages come down.
"use strict";

const KindslConnection = (() => {
  class Connection {
    constructor({ onState, greeting }) {
      addEventListener("message", ({ source, data }) => {
        if (source !== parent || !Array.isArray(data?.kindslMessages)) return;
        onState("live");
        for (const message of data.kindslMessages) kindsl.viewer.handle_command(message);
      });
      this.send(greeting());
    }

    send(request) {
      // An editor's frame has an origin of its own; nothing in a request is a secret.
      parent.postMessage({ kindslRequest: request }, "*");
    }
  }

  return { Connection };
})();
