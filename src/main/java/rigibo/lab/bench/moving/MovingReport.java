package rigibo.lab.bench.moving;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;

/** What was found of scenes that move, a section each, for a terminal and for a page. */
public final class MovingReport {

    private final List<MovingSection> sections;

    MovingReport(List<MovingSection> sections) {
        this.sections = List.copyOf(sections);
    }

    /** For a terminal. */
    public List<String> text() {
        List<String> lines = new ArrayList<>();
        for (MovingSection section : sections) {
            lines.add(section.title());
            section.table().text().forEach(line -> lines.add("  " + line));
            section.sentences().forEach(line -> lines.add("  " + line));
            lines.add("");
        }
        return lines;
    }

    /** The measured part of a page of Markdown. */
    public String markdown(String provenance) {
        return provenance
                + "\n\n"
                + sections.stream().map(MovingReport::page).collect(Collectors.joining("\n\n"))
                + "\n";
    }

    private static String page(MovingSection section) {
        return "### "
                + section.title()
                + "\n\n"
                + section.table().markdown()
                + "\n"
                + String.join("\n\n", section.sentences());
    }
}
