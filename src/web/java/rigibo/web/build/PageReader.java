package rigibo.web.build;

import java.io.IOException;

/** A kind of browser that tells what a page of a server says. */
interface PageReader {

    /** The text of a page once its scripts are through. */
    String read(LocalServer server, String page) throws IOException, InterruptedException;
}
