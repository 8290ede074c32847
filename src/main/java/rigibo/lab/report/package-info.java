/** The formats of the laboratory's reports: numbers, tables and CSV files. */
package rigibo.lab.report;
