package rigibo.frontend.scene;

/** Changes what is shown; the change happens after the present turn, in a window of its own. */
public interface Director {

    /** Shows another scene. */
    void show(Scene scene);

    /** Goes back to the main menu. */
    void showMenu();

    /** Ends the game. */
    void quit();
}
