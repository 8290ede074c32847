package rigibo.frontend.demo;

/** What a demo's buttons do in a hand, in place of keys. */
enum HandButton {
    MENU,
    PREVIOUS,
    NEXT,
    PAUSE,
    RESTART
}
