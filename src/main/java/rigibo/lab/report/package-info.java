/** How the laboratory's reports write down what was found: numbers, tables and files of values. */
package rigibo.lab.report;
