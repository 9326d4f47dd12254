// The words below the picture: ?text=…
(function () {
  var found = /[?&]text=([^&]*)/.exec(window.location.search);
  if (!found) { return; }
  try {
    document.getElementById("text").textContent = decodeURIComponent(found[1].replace(/\+/g, " "));
  } catch (error) { /* not UTF-8: no words, only the picture */ }
}());
