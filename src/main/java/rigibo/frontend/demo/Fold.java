package rigibo.frontend.demo;

/** A plate of a demo that can be folded away to its tab. */
enum Fold {
    CONTROLS("fold.controls"),

    /** Readouts, which are a plate of their own in a handheld window. */
    NUMBERS("fold.numbers"),

    /** A plate only in a handheld window; others always show it. */
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

    /** Whether it has a tab in a handheld window only. */
    boolean isForHands() {
        return this == NUMBERS || this == ACCURACY;
    }

    /** Whether it stands at the side, where one plate is shown at a time. */
    boolean isAtTheSide() {
        return this == FRAME || this == ENERGY || this == GHOST;
    }
}
