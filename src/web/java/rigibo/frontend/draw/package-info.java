/** Text, lines and plates of the page, by the browser's two-dimensional canvas. */
package rigibo.frontend.draw;
