package rigibo.web.build;

import java.io.IOException;
import java.util.List;

/** A page in a browser that a program drives. */
interface Page {

    /** Sets the size of the page, px. */
    void size(int width, int height) throws IOException, InterruptedException;

    /** Runs a script at the beginning of each document opened later. */
    void begin(String script) throws IOException, InterruptedException;

    /** Opens an address. */
    void open(String address) throws IOException, InterruptedException;

    /** The value of a JavaScript expression, as text. */
    String value(String script) throws IOException, InterruptedException;

    /** Moves the mouse to a place of the page and presses its left button there. */
    void click(Spot at) throws IOException, InterruptedException;

    /** The page as a picture, a PNG. */
    byte[] picture() throws IOException, InterruptedException;

    /** All addresses that were requested. */
    List<String> requests();

    /** All output of the page to the console, and its errors. */
    List<String> complaints();

    /** Closes the page. */
    void close() throws IOException, InterruptedException;

    /** A point of the page, px. */
    record Spot(double x, double y) {

        Spot plus(double dx, double dy) {
            return new Spot(x + dx, y + dy);
        }
    }
}
