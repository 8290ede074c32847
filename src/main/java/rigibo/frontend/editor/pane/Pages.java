package rigibo.frontend.editor.pane;

/** The page that is open of rows for which one page has no room. */
public final class Pages {

    private String subject = "";
    private int open;

    /** Rows about something; those about something else begin with their first page. */
    void about(String what) {
        if (!what.equals(subject)) {
            subject = what;
            open = 0;
        }
    }

    /** The open page, from 0. */
    int open() {
        return open;
    }

    /** Opens a page, counted from 0; the last one if there is no such page. */
    void open(int page, int count) {
        open = Math.max(0, Math.min(count - 1, page));
    }
}
