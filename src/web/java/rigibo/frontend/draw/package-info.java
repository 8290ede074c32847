/** Text, lines and plates of the page, by the browser's own two-dimensional canvas. */
package rigibo.frontend.draw;
