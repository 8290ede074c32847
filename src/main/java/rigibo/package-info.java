/**
 * The command line: which words there are and what each starts. It knows the frontend's catalog and
 * display and hands the one to the other; it computes and draws nothing itself.
 */
package rigibo;
