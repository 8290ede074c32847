/**
 * The live state of a pool in flat columns, one slot per body, pair or joint. Stages read and write
 * these arrays; nothing here computes physics. All columns are in SI units. A column that only an
 * undeclared effect would need is null.
 */
package rigibo.backend.storage;
