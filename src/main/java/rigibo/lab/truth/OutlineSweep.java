package rigibo.lab.truth;

import rigibo.backend.geometry.Shape;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.BiPredicate;
import java.util.function.ToDoubleFunction;

/**
 * Finds the deepest overlap of outlines. It sweeps from left to right, since only outlines that
 * begin before another ends can overlap it.
 */
public final class OutlineSweep {

    private record Entry(Outline outline, boolean givesWay, double unit) {

        double left() {
            return outline.left();
        }
    }

    private final ToDoubleFunction<Shape> unit;
    private final BiPredicate<Outline, Outline> meet;
    private final List<Entry> entries = new ArrayList<>();

    /**
     * A sweep without outlines.
     *
     * @param unit of overlap by shape, m; of two shapes the lesser counts
     * @param meet whether two outlines may not overlap; those of a group and joined ones may
     */
    public OutlineSweep(ToDoubleFunction<Shape> unit, BiPredicate<Outline, Outline> meet) {
        this.unit = unit;
        this.meet = meet;
    }

    /**
     * Adds an outline, which may be placed anew before each {@link #deepest}.
     *
     * @param givesWay false for a fixed body; two of them may overlap
     */
    public void add(Outline outline, boolean givesWay) {
        entries.add(new Entry(outline, givesWay, unit.applyAsDouble(outline.shape())));
    }

    /** The deepest overlap, in units of the two outlines; 0 if none overlap. */
    public double deepest() {
        // The list is nearly sorted, since few outlines overtake each other between two steps.
        entries.sort(Comparator.comparingDouble(Entry::left));
        double deepest = 0;
        for (int i = 0; i < entries.size(); i++) {
            Entry one = entries.get(i);
            double right = one.outline.right();
            for (int j = i + 1; j < entries.size() && entries.get(j).left() <= right; j++) {
                deepest = Math.max(deepest, depth(one, entries.get(j)));
            }
        }
        return deepest;
    }

    private double depth(Entry a, Entry b) {
        boolean isAsked = (a.givesWay || b.givesWay) && a.outline.isNear(b.outline);
        double depth = isAsked ? -a.outline.separation(b.outline) / Math.min(a.unit, b.unit) : 0;
        return depth > 0 && meet.test(a.outline, b.outline) ? depth : 0;
    }
}
