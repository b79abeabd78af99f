// The mechanics as Emscripten hands them out, for tests outside a page.
export { default } from "mechanics-glue";
