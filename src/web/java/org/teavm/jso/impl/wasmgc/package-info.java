/** Prints the program's texts like the compiler, by a class that is private to this package. */
package org.teavm.jso.impl.wasmgc;
