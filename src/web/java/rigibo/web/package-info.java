/** Programs that are compiled for a browser. They know neither files nor threads. */
package rigibo.web;
