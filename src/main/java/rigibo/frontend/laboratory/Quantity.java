package rigibo.frontend.laboratory;

import java.util.Locale;

/** The quantities of a step of the two worlds that can be graphed and saved. */
enum Quantity {
    /** Between the two worlds, root mean square over the bodies, m. */
    DISTANCE("m"),
    /** Change of the energy of motion and height since the start, as a share of it, %. */
    ENERGY("%"),
    /** The deepest of all, mm. */
    OVERLAP("mm"),
    /** That a step took, ms. */
    TIME("ms"),
    /** Between bodies. */
    CONTACTS("");

    /** How it is called in the tables that are saved. */
    final String column;

    final String unit;

    Quantity(String unit) {
        this.unit = unit;
        String name = name().toLowerCase(Locale.ROOT);
        column = unit.isEmpty() ? name : name + "_" + unit.replace("%", "percent");
    }

    /** Its name in links. */
    String linked() {
        return name().toLowerCase(Locale.ROOT);
    }

    /** Key of its name among the words of the laboratory. */
    String key() {
        return "laboratory.graph." + linked();
    }

    /** Whether it is one number for both worlds. */
    boolean isShared() {
        return this == DISTANCE;
    }

    /** Whether graphs of it begin at 0; small changes of the energy are what matters of it. */
    boolean beginsAtZero() {
        return this != ENERGY;
    }

    /** The quantity of one world after its last step. */
    double of(Half half) {
        return switch (this) {
            case DISTANCE -> 0;
            case ENERGY -> 100 * (half.energyShare() - 1);
            case OVERLAP -> 1000 * half.report().deepestOverlap();
            case TIME -> half.lastMillis();
            case CONTACTS -> half.report().contacts();
        };
    }
}
