import { Server } from "./api.ts";

const server = await Server.connect();
const app = document.querySelector("#app");
if (app) app.innerHTML = `<h1>${server.session.fabric.name}</h1>`;
