package rigibo.lab.report;

import java.util.List;

/**
 * A report that is one table, for a terminal and for a page.
 *
 * @param table what was measured
 */
public record MeasuredTable(Table table) {

    /** For a terminal. */
    public List<String> text() {
        return table.text();
    }

    /** The measured part of a page of Markdown. */
    public String markdown(String provenance) {
        return provenance + "\n\n" + table.markdown();
    }
}
