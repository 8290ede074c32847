/**
 * Runs programs and checks the engine by laws that hold for every program: only refusals are
 * thrown, refusals change nothing, states are finite, copies continue alike, and answers equal
 * those of a search through all bodies. Programs that break a law are shrunk. This room knows the
 * engine's public face alone. SI units.
 */
package rigibo.fuzz.judge;
