/**
 * The origin report's {@code dataStorage}: the live state of a pool in flat columns, one slot per
 * body or pair. Stages read and write these arrays; nothing here computes physics. All columns are
 * SI. A column that only an undeclared effect would need is null.
 */
package rigibo.backend.storage;
