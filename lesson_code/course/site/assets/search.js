// Puts below each result of the search the sentence of that page, or section, that answers best.
// The sentences come as a script (lesson_code/course/site/search.py), since a page from a folder may
// not read other pages.
"use strict";
{
  const LEAST = 3; // letters of a word that are compared
  const words = (new URLSearchParams(location.search).get("q") || "").toLowerCase().replace(/['\u2019]s\b/g, "").split(/[^\p{L}\p{N}_]+/u).filter(Boolean);
  // "bounces" finds "bounce" and "bouncing", as the theme's own search does.
  const stems = words.map((word) => word.slice(0, Math.max(LEAST, word.length - (word.length > 7 ? 2 : word.length > 5 ? 1 : 0))));
  const results = document.getElementById("search-results");
  const home = new URL(".", location.href).href;
  let pages = {};

  const hits = (sentence) => {
    const inside = sentence.toLowerCase().split(/[^\p{L}\p{N}_]+/u);
    return stems.filter((stem) => inside.some((word) => word.startsWith(stem))).length;
  };

  /** Return the sentence with the most of the words: of the section, or else of the whole page. */
  function answer(address) {
    const { href, hash } = new URL(address);
    const page = pages[href.slice(home.length).replace(/\.html.*$/, "")] || {};
    const section = page[decodeURIComponent(hash.slice(1))] || [];
    const all = [...section.map((one) => [hits(one) + 0.5, one]), ...Object.values(page).flat().map((one) => [hits(one), one])];
    // Of equals the first of full length: a title says less than the sentence below it.
    const best = all.reduce((most, one) => (one[0] > most[0] || (one[0] === most[0] && !/[.?!]$/.test(most[1]) && /[.?!]$/.test(one[1])) ? one : most), [0, ""]);
    return best[0] >= 1 ? best[1] : "";
  }

  function put(item) {
    const link = item.querySelector("a");
    if (!link || item.querySelector(".sentence")) return;
    const sentence = answer(link.href);
    if (!sentence) return;
    const line = document.createElement("p");
    line.className = "sentence";
    for (const part of sentence.split(/([\p{L}\p{N}_]+)/u)) {
      const isHit = stems.some((stem) => part.toLowerCase().startsWith(stem));
      if (isHit) line.append(Object.assign(document.createElement("mark"), { textContent: part }));
      else line.append(part);
    }
    item.append(line);
  }

  const MARKED = "sphinx_highlight_terms"; // what the theme marks in the page that is opened
  const all = () => {
    results.querySelectorAll("li").forEach(put);
    const terms = (localStorage.getItem(MARKED) || "").split(" ");
    // One letter, as the s of "Coulomb's", would be marked all over the page, and fails in a drawing.
    localStorage.setItem(MARKED, terms.filter((term) => term.length > 1).join(" "));
  };
  window.sentencesOfPages = (given) => {
    pages = given;
    all();
  };
  new MutationObserver(all).observe(results, { childList: true, subtree: true });
}
