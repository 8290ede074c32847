package rigibo.peers;

import java.util.Arrays;

/**
 * The impulses of contacts in the last step, as listeners received them. It is a list, searched
 * only when it is read: adding to it takes almost no time, while a map would be timed with the
 * engine.
 */
public final class ImpulseLog {

    private static final int FIRST_ROOM = 64;

    private int[] bodyA = new int[FIRST_ROOM];
    private int[] bodyB = new int[FIRST_ROOM];
    private double[] impulses = new double[FIRST_ROOM];
    private int count;
    private boolean isOpen;

    /** Begins recording. */
    public void open() {
        isOpen = true;
    }

    /** Removes all impulses, before a step. */
    public void clear() {
        count = 0;
    }

    /** Adds an impulse along a normal, N·s. */
    public void add(int a, int b, double impulse) {
        if (count == impulses.length) {
            bodyA = Arrays.copyOf(bodyA, 2 * count);
            bodyB = Arrays.copyOf(bodyB, 2 * count);
            impulses = Arrays.copyOf(impulses, 2 * count);
        }
        bodyA[count] = a;
        bodyB[count] = b;
        impulses[count] = impulse;
        count++;
    }

    /**
     * The sum of the impulses between two bodies, N·s.
     *
     * @throws IllegalStateException if recording has not begun
     */
    public double between(int a, int b) {
        if (!isOpen) {
            throw new IllegalStateException("impulses are kept after watchImpulses() only");
        }
        double sum = 0;
        for (int i = 0; i < count; i++) {
            boolean isThis = bodyA[i] == a && bodyB[i] == b;
            boolean isReverse = bodyA[i] == b && bodyB[i] == a;
            sum += isThis || isReverse ? impulses[i] : 0;
        }
        return sum;
    }
}
