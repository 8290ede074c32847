package rigibo.lab.ablation.probe;

import rigibo.lab.child.Work;

/**
 * The result of one process.
 *
 * @param nanosPerStep of the processor, median over the periods after warm-up, ns
 * @param bytesPerStep allocated in the period that allocated least, bytes: all periods do the same
 *     work, and the compiler may allocate on that thread too
 * @param stateHash after the counted steps
 * @param work of the counted steps, those of the first periods: equal on every machine
 * @param bitsPerBody the columns that the effects need, bits
 */
public record Sample(
        double nanosPerStep, double bytesPerStep, long stateHash, Work work, int bitsPerBody) {}
