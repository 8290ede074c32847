package rigibo.lab.ablation.probe;

import rigibo.lab.child.Work;

/**
 * What one process found.
 *
 * @param nanosPerStep of the processor, median over the periods after warm-up, ns
 * @param bytesPerStep allocated in the one of those periods that allocated least, bytes: all do the
 *     same, and what comes on top in some is what the compiler allocates on the thread it holds up
 * @param stateHash after the counted steps
 * @param work of the counted steps: those of the first periods, the same however fast the machine
 * @param bitsPerBody the columns that the effects need, bits
 */
public record Sample(
        double nanosPerStep, double bytesPerStep, long stateHash, Work work, int bitsPerBody) {}
