package rigibo.web.build;

import java.io.IOException;

/** A kind of browser that reads the output of a page. */
interface PageReader {

    /** The text of a page after its scripts have run. */
    String read(LocalServer server, String page) throws IOException, InterruptedException;
}
