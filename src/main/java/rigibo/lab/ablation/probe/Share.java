package rigibo.lab.ablation.probe;

/** How many of a scene's bodies use an effect that is declared. */
public enum Share {
    NONE,
    ONE,
    HALF,
    ALL;

    /** The number of users among a number of bodies. */
    public int of(int bodies) {
        return switch (this) {
            case NONE -> 0;
            case ONE -> 1;
            case HALF -> bodies / 2;
            case ALL -> bodies;
        };
    }
}
