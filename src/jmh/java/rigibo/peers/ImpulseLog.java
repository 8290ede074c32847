package rigibo.peers;

import java.util.Arrays;

/**
 * What contacts did in the last step, as listeners were told it. A list that is searched only when
 * somebody asks: one more entry costs a step next to nothing, while a map would be timed with the
 * engine.
 */
public final class ImpulseLog {

    private static final int FIRST_ROOM = 64;

    private int[] bodyA = new int[FIRST_ROOM];
    private int[] bodyB = new int[FIRST_ROOM];
    private double[] impulses = new double[FIRST_ROOM];
    private int count;
    private boolean isOpen;

    /** Begins: until now there was nothing to be told. */
    public void open() {
        isOpen = true;
    }

    /** Forgets all: a step begins. */
    public void clear() {
        count = 0;
    }

    /** Notes an impulse along a normal, N·s. */
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
     * Sum of those between two bodies, N·s.
     *
     * @throws IllegalStateException where nobody watched
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
