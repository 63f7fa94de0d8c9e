// What is compressed within the page: text of an element by its id, and the libraries, which are run once it is there.
const predicamentText = async (id) => {
  "use strict";
  const bytes = Uint8Array.from(atob(document.getElementById(id).textContent.trim()), (c) => c.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Response(stream).text();
};
const predicamentLibraries = predicamentText("libraries").then((textContent) => {
  "use strict";
  document.head.append(Object.assign(document.createElement("script"), { textContent }));
});
