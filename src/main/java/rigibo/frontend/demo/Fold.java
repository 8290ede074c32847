package rigibo.frontend.demo;

/** A plate of a demo that can be folded away to its tab. */
enum Fold {
    CONTROLS("fold.controls"),

    /** Readouts, in a hand apart from the controls. */
    NUMBERS("fold.numbers"),

    /** Only in a hand, where there is no room to show it always. */
    ACCURACY("fold.accuracy"),
    EFFECTS("fold.effects"),
    FRAME("fold.frame"),
    ENERGY("fold.energy"),
    GHOST("fold.ghost");

    private final String key;

    Fold(String key) {
        this.key = key;
    }

    /** Key of the word on its tab. */
    String key() {
        return key;
    }

    /** Whether it has a tab in a hand only. */
    boolean isForHands() {
        return this == NUMBERS || this == ACCURACY;
    }

    /** Whether it is one of those of which one is shown at a time, in one place. */
    boolean isAtTheSide() {
        return this == FRAME || this == ENERGY || this == GHOST;
    }
}
