package rigibo.frontend.gallery;

/** The plates that can stand beside an exhibit, one at a time. */
enum Side {
    SOURCE("gallery.source"),
    FRAME("fold.frame"),
    GHOST("fold.ghost");

    private final String key;

    Side(String key) {
        this.key = key;
    }

    /** Key of the word on its tab. */
    String key() {
        return key;
    }
}
