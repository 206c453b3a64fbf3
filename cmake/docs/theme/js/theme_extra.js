// Debian's mkdocs lacks this file of its theme. The theme's style sheet knows tables by this class.
$(function () {
  $("div.rst-content table").addClass("docutils");
});
