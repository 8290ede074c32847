/**
 * Rest: which bodies form piles and islands, when islands fall asleep, and which bodies wake. This
 * package reads contacts from storage and knows nothing of how they are solved.
 */
package rigibo.backend.rest;
