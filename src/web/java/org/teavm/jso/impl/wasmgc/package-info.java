/** What prints the program's texts as the compiler does, with a class that is this package's. */
package org.teavm.jso.impl.wasmgc;
