package rigibo.lab.hardcase;

import java.util.ArrayList;
import java.util.List;

/**
 * A body that slides back and forth in a bowl without friction and loses a share of its kinetic
 * energy at every kink. Energy is kept between kinks, so only their heights matter.
 */
final class KinkedSlide {

    private final double[] heights;
    private final double loss;
    private double energy;
    private int next;
    private int direction = 1;

    /**
     * A body at rest that is about to slide to the right.
     *
     * @param heights of the body's centre at the kinks, m, from the left
     * @param loss share of the energy of motion that a kink takes
     * @param height of the centre where it starts, m
     * @param next number of the first kink to the right
     */
    KinkedSlide(double[] heights, double loss, double height, int next) {
        this.heights = heights;
        this.loss = loss;
        this.next = next;
        energy = height;
    }

    /** The energies at the turning points, as heights in m, down to a least one. */
    List<Double> swings(double lowest, int most) {
        List<Double> turns = new ArrayList<>();
        while (turns.size() < most && energy > lowest) {
            if (next < 0 || next >= heights.length) {
                break;
            }
            if (energy > heights[next]) {
                energy -= loss * (energy - heights[next]);
                next += direction;
            } else {
                turns.add(energy);
                direction = -direction;
                next += direction;
            }
        }
        return turns;
    }
}
